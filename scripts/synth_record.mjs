// SPDX-License-Identifier: Apache-2.0
//
// What scripts/synth.mjs has measured, as the JSON that shadesim bench reads. The file is written anew after
// every module, whole or not at all; with another RTL or tool nothing of it is kept.
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, renameSync, writeFileSync } from 'node:fs';

export class Record {
  constructor(path, tool, target, files) {
    this.path = path;
    const hash = createHash('sha256');
    for (const name of Object.keys(files).sort()) {
      hash.update(`${name}\0${files[name].replace(/\/\/.*$/gm, '')}\0`);  // comments do not count
    }
    this.data = {
      format: 'shadesim-synthesis', version: 1, tool, target, rtl: hash.digest('hex'),
      multiplier_lut4: 0, units: [], builds: [],
    };
    if (!path || !existsSync(path)) return;
    try {
      const old = JSON.parse(readFileSync(path, 'utf8'));
      if (old.rtl === this.data.rtl && old.tool === tool && old.target === target) this.data = old;
    } catch { /* not ours, or cut off: written anew */ }
  }
  unit(name) { return this.data.units.find((entry) => entry.name === name); }
  build(method, lanes) {
    return this.data.builds.find((entry) => entry.method === method && entry.lanes === lanes);
  }
  write() {
    if (!this.path) return;
    writeFileSync(`${this.path}.tmp`, `${JSON.stringify(this.data, null, 1)}\n`);
    renameSync(`${this.path}.tmp`, this.path);
  }
}
