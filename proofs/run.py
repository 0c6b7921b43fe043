#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Checks every proof with Gappa, and that the same proof with a bound one bit tighter fails.
# Usage: run.py    Exit status: 0 all proved, 1 not, 77 Gappa is missing.
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import reciprocal_sqrt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CONTRACT = {  # proof: header and the constant of its contract that the proof states
    "quad_step_drift.g": ("intensity/quad_step.h", "0.0313"),
    "quad_difference_drift.g": ("intensity/quad_difference.h", "0.0157"),
    "slerp_recurrence_dead_zone.g": ("normal/slerp_recurrence.h", "1025"),
    "slerp_recurrence_step.g": ("normal/slerp_recurrence.h", ""),
    "slerp_paper_drift.g": ("normal/slerp_paper.h", "2098200"),
}


def proved(text):
    return subprocess.run(["gappa"], input=text, capture_output=True, text=True, timeout=60).returncode == 0


def tighter(text):
    goal = re.compile(r"(->[^\[]*)\[-([0-9.e-]+?)(b-?\d+)?, ([0-9.e-]+?)(b-?\d+)?\] *}")
    m = goal.search(text)
    bound = f"{m[2]}{m[3] or ''} / 2"
    value = re.fullmatch(r"([0-9.]+)(e-?\d+)?", m[2])
    half = f"{float(value[1]) / 2}{value[2] or ''}{m[3] or ''}"
    return text[:m.start()] + f"{m[1]}[-{half}, {half}] }}" + text[m.end():], bound


def check(name, text, halve=True):
    ok = proved(text)
    narrow, bound = tighter(text)
    fails = not halve or not proved(narrow)
    if not (ok and fails):
        print(f"{name}: {'proved' if ok else 'NOT PROVED'}, "
              f"{'fails' if fails else 'STILL HOLDS'} with {bound}")
    return ok and fails


def main():
    if not shutil.which("gappa"):
        print("gappa is not installed (Debian package gappa): proofs skipped")
        return 77
    good = True
    for path in sorted(HERE.glob("*.g")):
        header, bound = CONTRACT[path.name]
        text = path.read_text()
        if bound not in text or bound not in (HERE.parent / "model" / header).read_text():
            print(f"{path.name}: {bound} is not the number of {header}")
            good = False
        one = check(path.name, text)
        good &= one
        if one:
            print(f"{path.name}: proved; fails with half the bound")
    header = HERE.parent / "model/normal/reciprocal_sqrt.h"
    if "0.77," not in header.read_text():
        print("reciprocal_sqrt: 0.77 is not the number of the contract")
        good = False
    words = reciprocal_sqrt.table(HERE.parent / "model/normal/reciprocal_sqrt_table.h")
    done = sum(check(f"reciprocal_sqrt segment {k}", reciprocal_sqrt.text(words[k], k, "0.77"), k % 64 == 0)
               for k in range(len(words)))
    print(f"reciprocal_sqrt: {done} of {len(words)} segments proved; every 64th tried with half the bound fails")
    return 0 if good and done == len(words) else 1


sys.exit(main())
