// SPDX-License-Identifier: Apache-2.0
//
// Draws units as Yosys reads them: docs/images/UNIT.svg. Run by scripts/diagrams.sh, which provides the
// packages. The picture names the RTL that it was drawn from by a hash, which a test compares.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { runYosys } from '@yowasp/yosys';

const netlistsvg = createRequire(import.meta.url)('netlistsvg');
const root = process.argv[2];
const packages = ['fixed', 'light', 'normal', 'specular_table', 'shading'].map((p) => `${p}_pkg.sv`);

// FNV-1a of 64 bits.
function hash(text) {
  let value = 0xcbf29ce484222325n;
  for (const byte of Buffer.from(text)) value = ((value ^ BigInt(byte)) * 0x100000001b3n) & (2n ** 64n - 1n);
  return value.toString(16).padStart(16, '0');
}

for (const unit of ['quad_surface', 'quad_third_difference']) {
  const path = `rtl/intensity/${unit}.sv`;
  const files = { [`${unit}.sv`]: readFileSync(`${root}/${path}`, 'utf8') };
  for (const name of packages) files[name] = readFileSync(`${root}/rtl/pkg/${name}`, 'utf8');
  let log = '';
  const keep = (bytes) => { if (bytes) log += new TextDecoder().decode(bytes); };
  const out = await runYosys(
    ['-p', `read_slang -j 1 --top ${unit} -D SYNTHESIS ${packages.join(' ')} ${unit}.sv; proc; ` +
           'opt -full; wreduce; opt; clean -purge; write_json out.json'],
    files, { stdout: keep, stderr: keep });
  const json = out['out.json'];
  const netlist = JSON.parse(typeof json === 'string' ? json : new TextDecoder().decode(json));
  const skin = readFileSync('node_modules/netlistsvg/lib/default.svg', 'utf8');
  const svg = await netlistsvg.render(skin, netlist);
  const white = svg.replace(/(<svg [^>]*>)/, `$1\n<!-- ${path} ${hash(files[`${unit}.sv`])} -->` +
    '\n<rect width="100%" height="100%" style="fill:#fff;stroke:none"/>');
  writeFileSync(`${root}/docs/images/${unit}.svg`, white);
  console.log(`docs/images/${unit}.svg`);
}
