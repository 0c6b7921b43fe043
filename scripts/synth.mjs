// SPDX-License-Identifier: Apache-2.0
//
// Synthesises the units with Yosys (slang front end) and prints what they cost on an ECP5.
// Run by scripts/synth.sh, which provides the package.
import { readdirSync, readFileSync } from 'node:fs';
import { runYosys } from '@yowasp/yosys';
import { Record } from './synth_record.mjs';

const [, , rtl, json, only] = process.argv;
const wanted = only ? only.split(',') : null;
const isWanted = (name) => !wanted || wanted.includes(name);
const files = {};
for (const folder of ['pkg', 'raster', 'intensity', 'normal', 'light', 'footprint', 'choice', '.']) {
  for (const name of readdirSync(`${rtl}/${folder}`)) {
    if (name.endsWith('.sv')) files[name] = readFileSync(`${rtl}/${folder}/${name}`, 'utf8');
  }
}
const packages = ['fixed_pkg.sv', 'light_pkg.sv', 'normal_pkg.sv', 'footprint_pkg.sv', 'method_pkg.sv',
  'specular_table_pkg.sv', 'shading_pkg.sv'];
const sources = [...packages, ...Object.keys(files).filter((name) => !packages.includes(name))];

async function yosys(top, parameters, commands, extra = {}) {
  let log = '';
  const keep = (bytes) => { if (bytes) log += new TextDecoder().decode(bytes); };
  await runYosys(
    ['-p', `read_slang -j 1 --top ${top} ${parameters} -D SYNTHESIS ${[...sources, ...Object.keys(extra)].join(' ')}; ${commands}`],
    { ...files, ...extra }, { stdout: keep, stderr: keep });
  return log;
}

const count = (log, cell) => {
  const rows = [...log.matchAll(new RegExp(`^ +(\\d+) +\\S* *${cell}$|^ +${cell} +(\\d+)$`, 'gm'))];
  return rows.length ? Number(rows.at(-1)[1] ?? rows.at(-1)[2]) : 0;
};

async function cells(top, parameters) {
  const log = await yosys(top, parameters, `${target}; stat`);
  const [lut4, flip_flops, carry, multipliers] =
    ['LUT4', 'TRELLIS_FF', 'CCU2C', 'MULT18X18D'].map((cell) => count(log, cell));
  if (flip_flops === 0 && !['lane_seed', 'method_choice'].includes(top)) {
    throw new Error(`${top}: no registers found; the log has changed its form`);
  }
  return { lut4, flip_flops, carry, multipliers };
}

// Longest path: from register to register in levels of 4-input tables, without carry chains, so that adders
// count as logic.
async function path(top) {
  const log = await yosys(top, '', 'synth -flatten -lut 4; ltp -noff');
  const match = log.match(/Longest topological path in \S+ \(length=(\d+)\)/);
  if (!match) throw new Error(`${top}: no longest path found; the log has changed its form`);
  return Number(match[1]);
}

// What one hardware multiplier is worth: an 18 x 18 bit product of LUT4 and carry cells, by Booth's method,
// which takes half of what Yosys makes without it.
async function multiplier() {
  const source = `module product (input logic clk_i, input logic signed [17:0] a_i, b_i,
    output logic signed [35:0] c_o); always_ff @(posedge clk_i) c_o <= a_i * b_i; endmodule`;
  const log = await yosys('product', '', `hierarchy -top product; proc; booth; ${target} -nodsp; stat`, { 'product.sv': source });
  return count(log, 'LUT4') + 2 * count(log, 'CCU2C');
}

const target = 'synth_ecp5 -noabc9';
const rows = ['quad_surface', 'quad_polynomial', 'quad_horner', 'quad_step', 'quad_midpoint',
  'quad_three_term', 'quad_third_difference', 'quad_segment', 'quad_difference', 'quad_split'];
// Recurrences of paper 003: shifts and additions only.
const recurrences = [...rows.filter((name) => !['quad_polynomial', 'quad_horner'].includes(name)),
  'quad_cosine'];
const units = ['flat_color', 'gouraud_interpolator', ...rows, 'quad_cosine', 'lane_seed', 'pixel_walker',
  'span_setup', 'span_binder', 'normal_setup', 'linear_recurrence', 'slerp_recurrence', 'slerp_paper',
  'length_recurrence', 'slerp_direct_setup', 'slerp_direct', 'reciprocal_sqrt', 'phong_direct',
  'taylor_normalizer', 'duff_normalizer', 'adaptive_normalizer',
  'aniso_footprint', 'footprint_mean', 'dot_product', 'pixel_light', 'pixel_queue',
  'method_choice'];
// Multipliers of logic alone make the search for their path take hours.
const slowPaths = ['normal_setup', 'slerp_direct_setup', 'phong_direct', 'taylor_normalizer', 'pixel_light',
  'duff_normalizer', 'adaptive_normalizer', 'slerp_direct', 'span_setup'];
// One build per method: bit k of Methods is method k of method_e. auto has those that it chooses from.
const methods = ['flat', 'gouraud', 'quad', 'quad-polynomial', 'quad-horner', 'quad-step',
  'quad-midpoint', 'quad-three-term', 'quad-third-difference', 'quad-segment', 'quad-difference',
  'quad-footprint', 'quad-split', 'quad-cosine', 'phong-surface', 'phong', 'phong-taylor', 'phong-duff',
  'slerp', 'slerp-paper', 'slerp-intensity', 'slerp-direct', 'adaptive', 'adaptive-paper', 'adaptive-chord',
  'footprint', 'footprint-paper', 'auto'];
const chosen = ['flat', 'gouraud', 'quad', 'quad-cosine', 'phong-surface', 'phong-duff', 'auto'];
const bitsOf = (method) => methods.reduce((bits, name, k) =>
  (name === method || (method === 'auto' && chosen.includes(name)) ? bits + 2 ** k : bits), 0);
const record = new Record(json, 'Yosys 0.70, slang front end', target, files);
if (record.data.multiplier_lut4 === 0) {
  record.data.multiplier_lut4 = await multiplier();
  record.write();
}
console.log(`An 18 x 18 multiplier of logic takes ${record.data.multiplier_lut4} LUT4.\n`);

console.log('| unit | method | lanes | LUT4 | flip-flops | carry cells | 18x18 multipliers | longest path |');
console.log('|---|---|--:|--:|--:|--:|--:|--:|');
const print = (unit, method, lanes, c) => console.log(`| ${unit} | ${method} | ${lanes} | ${c.lut4} | ` +
  `${c.flip_flops} | ${c.carry} | ${c.multipliers} | ${c.path_lut4 ?? ''} |`);

for (const name of units.filter(isWanted)) {
  if (!record.unit(name)) {
    const entry = { name, ...await cells(name, '') };
    if (recurrences.includes(name) && entry.multipliers !== 0) throw new Error(`${name} has a multiplier`);
    if (!slowPaths.includes(name)) entry.path_lut4 = await path(name);
    record.data.units.push(entry);
    record.write();
  }
  print(name, '', '', record.unit(name));
}
for (const lanes of [1, 4]) {
  for (const method of methods) {
    if (!isWanted(method)) continue;
    if (!record.build(method, lanes)) {
      const parameters = `-G Methods=${methods.length}'d${bitsOf(method)} -G Lanes=${lanes}`;
      record.data.builds.push({ method, lanes, ...await cells('shading_unit', parameters) });
      record.write();
    }
    print('shading_unit', method, lanes, record.build(method, lanes));
  }
}
