// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace shading::report {

// Colours of series: --c0 is neutral, --c1 .. --c7 tell apart. Each has 3:1 on its ground.
inline constexpr char kStyle[] = R"css(
:root { --ground:#fff; --text:#1a1c20; --soft:#5c6370; --rule:#d8dce2; --tint:#f3f5f8;
  --c0:#777d88; --c1:#1f63c4; --c2:#c4540a; --c3:#1d7f3f; --c4:#8038b0; --c5:#0b7d85; --c6:#b8241c;
  --c7:#7d6214; --muted:#b9bec7; --link:#1a56b0; }
@media (prefers-color-scheme: dark) { :root { --ground:#14161a; --text:#e6e8ec; --soft:#a0a7b3;
  --rule:#373c45; --tint:#1f232a; --c0:#a7adb8; --c1:#6fa8ff; --c2:#ff9d57; --c3:#5fce86;
  --c4:#cb95ff; --c5:#4fd0d9; --c6:#ff857c; --c7:#d9b652; --muted:#565d69; --link:#8ab8ff; } }
@media print { :root { --ground:#fff; --text:#000; --soft:#444; --rule:#bbb; --tint:#f3f3f3;
  --c0:#666; --c1:#1f63c4; --c2:#c4540a; --c3:#1d7f3f; --c4:#8038b0; --c5:#0b7d85; --c6:#b8241c;
  --c7:#7d6214; --muted:#bbb; --link:#000; } nav { display:none; }
  figure, tr, h2, h3 { break-inside:avoid; } h2, h3 { break-after:avoid; }
  .scroll, .long { max-height:none !important; overflow:visible !important; } }
* { box-sizing:border-box; }
body { margin:0; background:var(--ground); color:var(--text);
  font:15px/1.5 system-ui, "Segoe UI", "Liberation Sans", sans-serif; }
main { max-width:1280px; margin:0 auto; padding:24px 32px 64px; }
h1 { font-size:28px; margin:0 0 8px; } h2 { font-size:21px; margin:40px 0 8px;
  padding-top:8px; border-top:1px solid var(--rule); } h3 { font-size:16px; margin:24px 0 4px; }
p, ul { max-width:86ch; } p { margin:8px 0; } a { color:var(--link); }
.facts { list-style:none; padding:0; color:var(--soft); font-size:13px; max-width:none; margin:0; }
nav ol { columns:3; font-size:14px; padding-left:24px; }
pre, code { font:13px/1.5 ui-monospace, "Liberation Mono", monospace; }
pre { background:var(--tint); padding:8px 12px; overflow-x:auto; margin:8px 0; }
figure { margin:16px 0; } .row { display:flex; flex-wrap:wrap; gap:4px 12px; }
.row > div { flex:none; }
figcaption { color:var(--soft); font-size:13px; max-width:110ch; }
figcaption code { display:block; color:var(--soft); font-size:12px; overflow-wrap:anywhere; }
.scroll { overflow-x:auto; margin:8px 0; } .long { overflow:auto; max-height:640px; }
table { border-collapse:collapse; font-size:13px; font-variant-numeric:tabular-nums; }
th, td { padding:3px 10px; border-bottom:1px solid var(--rule); text-align:left;
  vertical-align:top; }
th { position:sticky; top:0; background:var(--tint); } .n { text-align:right; }
th button { all:unset; cursor:pointer; font-weight:600;
}
th button:focus-visible { outline:2px solid var(--link); }
th button::after { content:" \2195"; color:var(--muted); }
th[aria-sort=ascending] button::after { content:" \2191"; color:var(--text); }
th[aria-sort=descending] button::after { content:" \2193"; color:var(--text); }
.gallery { display:flex; flex-wrap:wrap; gap:16px; } .gallery figure { margin:0; width:292px; }
.gallery img { width:144px; image-rendering:pixelated; background:#000; vertical-align:top;
  margin-right:2px; }
svg { display:block; max-width:100%; height:auto; } svg text { fill:var(--text);
  font:11px system-ui, "Liberation Sans", sans-serif; }
svg .halo { paint-order:stroke; stroke:var(--ground); stroke-width:3px;
}
svg .soft { fill:var(--soft); } svg .title { font-size:13px; font-weight:600; }
svg .grid { stroke:var(--rule); stroke-width:1; } svg .frame { stroke:var(--soft); fill:none; }
svg .line { fill:none; stroke-width:1.8; } svg .front { fill:none; stroke:var(--soft);
  stroke-dasharray:4 3; }
svg .dim { fill:none; stroke:var(--muted); stroke-width:1.3; }
)css"
R"css(
svg .f0{fill:var(--c0)} svg .f1{fill:var(--c1)} svg .f2{fill:var(--c2)} svg .f3{fill:var(--c3)}
svg .f4{fill:var(--c4)} svg .f5{fill:var(--c5)} svg .f6{fill:var(--c6)} svg .f7{fill:var(--c7)}
svg .s0{stroke:var(--c0)} svg .s1{stroke:var(--c1)} svg .s2{stroke:var(--c2)}
svg .s3{stroke:var(--c3)}
svg .s4{stroke:var(--c4)} svg .s5{stroke:var(--c5)} svg .s6{stroke:var(--c6)}
svg .s7{stroke:var(--c7)}
)css";

// Sorts a table by the column whose heading is pressed; pressing again turns the order.
inline constexpr char kScript[] = R"js(
document.querySelectorAll('th button').forEach(button => button.addEventListener('click', () => {
  const heading = button.parentNode, column = heading.cellIndex;
  const body = heading.closest('table').tBodies[0];
  const up = heading.getAttribute('aria-sort') !== 'ascending';
  heading.parentNode.querySelectorAll('th').forEach(th => th.removeAttribute('aria-sort'));
  heading.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  const key = row => {
    const cell = row.cells[column];
    return cell.dataset.v === undefined ? cell.textContent : Number(cell.dataset.v);
  };
  const order = (a, b) => typeof a === 'number' && typeof b === 'number' ? a - b
    : String(a).localeCompare(String(b), 'en', {numeric: true});
  [...body.rows].map(row => [key(row), row])
    .sort((a, b) => (up ? 1 : -1) * order(a[0], b[0])).forEach(pair => body.append(pair[1]));
}));
)js";

}  // namespace shading::report
