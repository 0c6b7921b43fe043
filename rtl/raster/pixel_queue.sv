// SPDX-License-Identifier: Apache-2.0
//
// Reorders nothing: keeps the positions of the pixels that are being lit and joins them with their
// codes. Admits as many groups of Lanes pixels as it can hold, so that the light pipeline behind it
// never has to stop. With HasShaded some groups enter with their codes and are not lit.
//
// Timing    A group whose codes come in one cycle, with it or from the light, is on offer from the
//           next, when those before it have left. A place is free in the cycle after its group
//           left. No bubble as long as a group is on offer fewer than Depth cycles after it
//           entered.
// Streams   ready/valid at the walker's and at the pixels' side; the light side never waits.
// Formats   shading_pkg.
// Error     None.
// Model     model/raster/pixel_queue.h      Doc  docs/units/raster/pixel_queue.md
module pixel_queue
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1,
  parameter bit HasShaded = 1'b0
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  // From the walker.
  input  logic                  enter_valid_i,
  output logic                  enter_ready_o,
  input  position_t [Lanes-1:0] position_i,
  input  logic      [Lanes-1:0] mask_i,
  input  material_index_t       material_i,
  input  logic                  dark_i,          // no highlight is wanted
  input  logic                  shaded_i,        // the group has its codes, HasShaded only
  input  code_t [Lanes-1:0][Channels-1:0] shaded_code_i,

  // To the light: the material of the group whose cosines come next.
  input  logic                  cosines_valid_i,
  output material_index_t       material_o,
  output logic                  dark_o,

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
  typedef code_t [Lanes-1:0][Channels-1:0] codes_t;
  typedef struct packed {
    position_t [Lanes-1:0] position;
    logic      [Lanes-1:0] mask;
  } entry_t;
  typedef struct packed {
    codes_t           code;
    logic [Lanes-1:0] unlit;
    logic [Lanes-1:0] no_highlight;
  } lit_t;
  // What the light is told of a group, in the order of the groups that are lit.
  typedef struct packed {
    material_index_t material;
    logic            dark;
  } lighting_t;

  entry_t    entry_mem    [Depth];
  lighting_t lighting_mem [Depth];
  lit_t      lit_mem      [Depth];

  count_t enter_q, leave_q;                      // groups so far, modulo 2 Depth
  count_t lit_enter_q, cosines_q, code_q;        // of those that are lit
  place_t code_place, leave_place;
  logic   enter, enter_lit, leave, shaded;
  assign shaded        = HasShaded && shaded_i;
  assign enter_ready_o = count_t'(enter_q - leave_q) != count_t'(Depth);
  assign enter         = enter_valid_i && enter_ready_o;
  assign enter_lit     = enter && !shaded;
  assign leave_place   = place_t'(leave_q);
  assign leave         = pixel_valid_o && pixel_ready_i;
  assign busy_o        = enter_q != leave_q;
  lighting_t lighting;
  assign lighting = cosines_q == lit_enter_q ? '{material: material_i, dark: dark_i}
                                             : lighting_mem[place_t'(cosines_q)];
  assign {material_o, dark_o} = lighting;

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
    if (enter)     entry_mem[place_t'(enter_q)] <= '{position: position_i, mask: mask_i};
    if (enter_lit) begin
      lighting_mem[place_t'(lit_enter_q)] <= '{material: material_i, dark: dark_i};
    end
    if (code_valid_i) begin
      lit_mem[code_place] <= '{code: code_i, unlit: unlit_i, no_highlight: no_highlight_i};
    end
  end

  // Groups that came with their codes lie between those that are lit.
  logic   leave_shaded;                          // the group on offer came with its codes
  codes_t leave_code;
  if (HasShaded) begin : gen_shaded
    place_t             place_mem [Depth];       // of the groups that are lit, in their order
    codes_t             shaded_mem [Depth];
    logic [Depth-1:0]   shaded_q, present_q;     // of each place: which codes, and that they came
    count_t             lit_enter_count_q;
    assign lit_enter_q   = lit_enter_count_q;
    assign code_place    = place_mem[place_t'(code_q)];
    assign leave_shaded  = shaded_q[leave_place];
    assign leave_code    = shaded_mem[leave_place];
    assign pixel_valid_o = busy_o && present_q[leave_place];
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni)        lit_enter_count_q <= '0;
      else if (enter_lit) lit_enter_count_q <= lit_enter_count_q + 1'b1;
    end
    always_ff @(posedge clk_i) begin
      if (code_valid_i) present_q[code_place] <= 1'b1;
      if (enter) begin
        present_q[place_t'(enter_q)] <= shaded;
        shaded_q[place_t'(enter_q)]  <= shaded;
      end
      if (enter_lit)       place_mem[place_t'(lit_enter_q)] <= place_t'(enter_q);
      if (enter && shaded) shaded_mem[place_t'(enter_q)]    <= shaded_code_i;
    end
  end else begin : gen_lit
    assign lit_enter_q   = enter_q;
    assign code_place    = place_t'(code_q);
    assign leave_shaded  = 1'b0;
    assign leave_code    = '0;
    assign pixel_valid_o = code_q != leave_q;
  end

  entry_t entry;
  lit_t   lit;
  assign entry          = entry_mem[leave_place];
  assign lit            = lit_mem[leave_place];
  assign mask_o         = entry.mask;
  assign unlit_o        = leave_shaded ? '0 : entry.mask & lit.unlit;
  assign no_highlight_o = leave_shaded ? '0 : entry.mask & lit.no_highlight;
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    code_t [Channels-1:0] code;
    assign code          = leave_shaded ? leave_code[lane] : lit.code[lane];
    assign pixel_o[lane] = '{x: entry.position[lane].x, y: entry.position[lane].y,
                             z: entry.position[lane].z, r: code[0], g: code[1], b: code[2],
                             last: entry.position[lane].last};
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    assert (!code_valid_i || code_q != lit_enter_q) else $error("pixel_queue: a code of no pixel");
    assert (!cosines_valid_i || cosines_q != lit_enter_q || enter_lit)
      else $error("pixel_queue: cosines of no pixel");
  end
`endif
endmodule
