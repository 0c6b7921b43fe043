// SPDX-License-Identifier: Apache-2.0
//
// Reorders nothing: keeps the positions of the pixels that are being lit and joins them with their
// codes. Admits as many groups of Lanes pixels as it can hold, so that the light pipeline behind it
// never has to stop.
//
// Timing    A group whose codes come in one cycle is on offer from the next. A place is free in the
//           cycle after its group left. No bubble as long as a group is on offer fewer than Depth
//           cycles after it entered.
// Streams   ready/valid at the walker's and at the pixels' side; the light side never waits.
// Formats   shading_pkg.
// Error     None.
// Model     model/raster/pixel_queue.h      Doc  docs/units/raster/pixel_queue.md
module pixel_queue
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  // From the walker.
  input  logic                  enter_valid_i,
  output logic                  enter_ready_o,
  input  position_t [Lanes-1:0] position_i,
  input  logic      [Lanes-1:0] mask_i,
  input  material_index_t       material_i,

  // To the light: the material of the group whose cosines come next.
  input  logic                  cosines_valid_i,
  output material_index_t       material_o,

  // From the light.
  input  logic                               code_valid_i,
  input  code_t [Lanes-1:0][Channels-1:0]    code_i,
  input  logic  [Lanes-1:0]                  unlit_i,
  input  logic  [Lanes-1:0]                  no_highlight_i,

  output logic                  pixel_valid_o,
  input  logic                  pixel_ready_i,
  output pixel_t    [Lanes-1:0] pixel_o,
  output logic      [Lanes-1:0] mask_o,
  output logic      [Lanes-1:0] unlit_o,         // of the pixels in mask_o
  output logic      [Lanes-1:0] no_highlight_o,
  output logic                  busy_o           // pixels are inside
);
  localparam int unsigned Latency = 1;
  localparam int unsigned Depth = 64;            // groups

  typedef logic [$clog2(Depth)-1:0] place_t;
  typedef logic [$clog2(Depth):0]   count_t;
  typedef struct packed {
    position_t [Lanes-1:0] position;
    logic      [Lanes-1:0] mask;
  } entry_t;
  typedef struct packed {
    code_t [Lanes-1:0][Channels-1:0] code;
    logic  [Lanes-1:0]               unlit;
    logic  [Lanes-1:0]               no_highlight;
  } lit_t;

  entry_t          entry_mem    [Depth];
  material_index_t material_mem [Depth];
  lit_t            lit_mem      [Depth];

  count_t enter_q, cosines_q, code_q, leave_q;   // groups so far, modulo 2 Depth
  logic   enter, leave;
  assign enter_ready_o = count_t'(enter_q - leave_q) != count_t'(Depth);
  assign enter         = enter_valid_i && enter_ready_o;
  assign pixel_valid_o = code_q != leave_q;
  assign leave         = pixel_valid_o && pixel_ready_i;
  assign busy_o        = enter_q != leave_q;
  assign material_o    = cosines_q == enter_q ? material_i : material_mem[place_t'(cosines_q)];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      enter_q   <= '0;
      cosines_q <= '0;
      code_q    <= '0;
      leave_q   <= '0;
    end else begin
      if (enter)           enter_q   <= enter_q + 1'b1;
      if (cosines_valid_i) cosines_q <= cosines_q + 1'b1;
      if (code_valid_i)    code_q    <= code_q + 1'b1;
      if (leave)           leave_q   <= leave_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (enter) begin
      entry_mem[place_t'(enter_q)]    <= '{position: position_i, mask: mask_i};
      material_mem[place_t'(enter_q)] <= material_i;
    end
    if (code_valid_i) begin
      lit_mem[place_t'(code_q)] <= '{code: code_i, unlit: unlit_i, no_highlight: no_highlight_i};
    end
  end

  entry_t entry;
  lit_t   lit;
  assign entry          = entry_mem[place_t'(leave_q)];
  assign lit            = lit_mem[place_t'(leave_q)];
  assign mask_o         = entry.mask;
  assign unlit_o        = entry.mask & lit.unlit;
  assign no_highlight_o = entry.mask & lit.no_highlight;
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    assign pixel_o[lane] = '{x: entry.position[lane].x, y: entry.position[lane].y,
                             z: entry.position[lane].z, r: lit.code[lane][0],
                             g: lit.code[lane][1], b: lit.code[lane][2],
                             last: entry.position[lane].last};
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    assert (!code_valid_i || code_q != enter_q) else $error("pixel_queue: a code of no pixel");
    assert (!cosines_valid_i || cosines_q != enter_q || enter)
      else $error("pixel_queue: cosines of no pixel");
  end
`endif
endmodule
