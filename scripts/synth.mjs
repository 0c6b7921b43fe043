// SPDX-License-Identifier: Apache-2.0
//
// Synthesises the units with Yosys (slang front end) and prints what they cost on an ECP5.
// Run by scripts/synth.sh, which provides the package.
import { readdirSync, readFileSync } from 'node:fs';
import { runYosys } from '@yowasp/yosys';

const rtl = process.argv[2];
const files = {};
for (const folder of ['pkg', 'raster', 'intensity', 'normal', 'light', 'footprint', '.']) {
  for (const name of readdirSync(`${rtl}/${folder}`)) {
    if (name.endsWith('.sv')) files[name] = readFileSync(`${rtl}/${folder}/${name}`, 'utf8');
  }
}
const packages = ['fixed_pkg.sv', 'light_pkg.sv', 'normal_pkg.sv', 'footprint_pkg.sv',
  'specular_table_pkg.sv', 'shading_pkg.sv'];
const sources = [...packages, ...Object.keys(files).filter((name) => !packages.includes(name))];

async function yosys(top, methods, commands) {
  const parameters = methods ? `-G Methods=${methods}` : '';
  let log = '';
  const keep = (bytes) => { if (bytes) log += new TextDecoder().decode(bytes); };
  await runYosys(
    ['-p', `read_slang -j 1 --top ${top} ${parameters} -D SYNTHESIS ${sources.join(' ')}; ${commands}`],
    files, { stdout: keep, stderr: keep });
  return log;
}

const count = (log, cell) => {
  const rows = [...log.matchAll(new RegExp(`^ +(\\d+) +\\S* *${cell}$|^ +${cell} +(\\d+)$`, 'gm'))];
  return rows.length ? Number(rows.at(-1)[1] ?? rows.at(-1)[2]) : 0;
};

const rows = ['quad_surface', 'quad_polynomial', 'quad_horner', 'quad_step', 'quad_midpoint',
  'quad_three_term', 'quad_third_difference', 'quad_segment', 'quad_difference', 'quad_split'];
// Recurrences of paper 003: shifts and additions only.
const recurrences = [...rows.filter((name) => !['quad_polynomial', 'quad_horner'].includes(name)),
  'quad_cosine'];
const units = ['flat_color', 'gouraud_interpolator', ...rows, 'quad_cosine', 'lane_seed', 'pixel_walker',
  'span_setup', 'span_binder', 'normal_setup', 'linear_recurrence', 'slerp_recurrence', 'slerp_paper',
  'length_recurrence', 'slerp_direct_setup', 'slerp_direct', 'reciprocal_sqrt', 'phong_direct',
  'taylor_normalizer', 'duff_normalizer', 'adaptive_normalizer', 'aniso_footprint', 'footprint_mean',
  'dot_product', 'pixel_light', 'pixel_queue'];
// One build per method: bit k of Methods is method k of method_e.
const methods = ['flat', 'gouraud', 'quad', 'quad-polynomial', 'quad-horner', 'quad-step',
  'quad-midpoint', 'quad-three-term', 'quad-third-difference', 'quad-segment', 'quad-difference',
  'quad-split', 'quad-cosine', 'phong', 'phong-taylor', 'phong-duff', 'slerp',
  'slerp-paper', 'slerp-intensity', 'slerp-direct', 'adaptive', 'adaptive-paper', 'adaptive-chord'];
const tops = [...units.map((name) => [name]),
  ...methods.map((name, k) => ['shading_unit', `${methods.length}'d${2 ** k}`, name])];
console.log('| unit | method | LUT4 | flip-flops | carry cells | 18x18 multipliers |');
console.log('|---|---|--:|--:|--:|--:|');
for (const [top, built, method] of tops) {
  const log = await yosys(top, built, 'synth_ecp5 -noabc9; stat');
  const cells = ['LUT4', 'TRELLIS_FF', 'CCU2C', 'MULT18X18D'].map((cell) => count(log, cell));
  console.log(`| ${top} | ${method ?? ''} | ${cells.join(' | ')} |`);
  if (recurrences.includes(top) && cells[3] !== 0) throw new Error(`${top} has a multiplier`);
  if (cells[1] === 0 && top !== 'lane_seed') throw new Error(`${top}: no registers found; the log has changed its form`);
}

// Longest path of a row form: from register to register in levels of 4-input tables, without carry chains,
// so that adders count as logic.
console.log('\n| unit | longest path, LUT4 levels |\n|---|--:|');
for (const top of ['flat_color', 'gouraud_interpolator', ...rows, 'quad_cosine']) {
  const log = await yosys(top, '', 'synth -flatten -lut 4; ltp -noff');
  const path = log.match(/Longest topological path in \S+ \(length=(\d+)\)/);
  if (!path) throw new Error(`${top}: no longest path found; the log has changed its form`);
  console.log(`| ${top} | ${path[1]} |`);
}
