// SPDX-License-Identifier: Apache-2.0
//
// aniso_footprint between the walker and the queue, and what the mean wants to know of a sample
// when its cosines are there. For other methods the pixels pass, each with one sample.
//
// Timing    As aniso_footprint; place_o and live_o come with the cosines, 13 cycles after a sample.
// Formats   As aniso_footprint.
// Error     None.
// Model     model/footprint/footprint_shader.h      Doc  docs/units/shading_unit.md
module footprint_samples
  import footprint_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter bit Built = 1'b1,                // the build has a method of footprints
  parameter int unsigned Lanes = 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  input  logic                       is_footprint_i,   // the frame's method, stable

  input  logic                       load_i,           // a span starts
  input  span_footprint_t            footprint_i,

  input  logic                       pixel_valid_i,
  output logic                       pixel_ready_o,
  input  logic [Lanes-1:0]           mask_i,
  input  quantity_t [Components-1:0][Lanes-1:0] normal_i,
  output logic                       enter_valid_o,
  input  logic                       enter_ready_i,

  output logic                       sample_valid_o,
  output quantity_t [Lanes-1:0][Components-1:0] normal_o,

  output sample_place_t              place_o,          // of the cosines that come now
  output logic [Lanes-1:0]           live_o,

  input  logic                       clear_i,
  output sample_counters_t           counters_o
);
  localparam int unsigned ToCosines = 13;    // phong_direct and dot_product
  localparam sample_place_t Only = '{first: 1'b1, last: 1'b1, twice: 1'b0};

  if (Built) begin : gen_footprint
    logic                            ready, enter;
    sample_place_t                   place;
    logic [Lanes-1:0]                live;
    sample_place_t [ToCosines-1:0]   place_q;
    logic [ToCosines-1:0][Lanes-1:0] live_q;

    aniso_footprint #(.Lanes(Lanes)) u_aniso_footprint (
      .clk_i, .rst_ni,
      .load_i       (load_i && is_footprint_i),
      .footprint_i  (footprint_i.footprint),
      .margin_i     (footprint_i.margin),
      .pixel_valid_i(pixel_valid_i && is_footprint_i),
      .pixel_ready_o(ready),
      .mask_i, .normal_i,
      .enter_valid_o(enter),
      .enter_ready_i,
      .sample_valid_o,
      .place_o      (place),
      .live_o       (live),
      .normal_o, .clear_i, .counters_o
    );

    always_ff @(posedge clk_i) begin
      place_q <= {place_q[ToCosines-2:0], place};
      live_q  <= {live_q[ToCosines-2:0], live};
    end
    assign pixel_ready_o = is_footprint_i ? ready : enter_ready_i;
    assign enter_valid_o = is_footprint_i ? enter : pixel_valid_i;
    assign place_o       = is_footprint_i ? place_q[ToCosines-1] : Only;
    assign live_o        = live_q[ToCosines-1];
  end else begin : gen_none
    assign pixel_ready_o = enter_ready_i;
    assign enter_valid_o = pixel_valid_i;
    assign place_o       = Only;
    assign live_o        = '1;
    assign {sample_valid_o, normal_o, counters_o} = '0;
  end
endmodule
