// SPDX-License-Identifier: Apache-2.0
//
// Adaptive normalisation, paper 002: a span is halved until the angle of every part is within a
// limit; only the normals at the borders are normalised, those between lie on straight lines.
//
//   N(mid) = (Nl + Nr) / z_j       (1)      z_j = 2 cos(eta_j / 2), eta_j the angle of level j
//   N_i = N_p + i dN,  dN = (N_g - N_p) 2^j / m
//
//   AdaptiveSphere     halves the span itself: slerp within the limit at every pixel
//   AdaptiveExtended   the paper's: halves the span extended to a power of 2, end on the chord
//   AdaptiveChord      borders are normalised points of the chord: Phong's normals
//
// Timing    Latency 10 cycles for a span of one segment, 4 more a level on the way to the first
//           one; Lanes pixels a cycle, with four lanes a cycle more where two segments share a
//           group. The division of later segments and the set-up of later spans run meanwhile.
// Streams   ready/valid; run_valid_o: the pixels of run_o begin in the next cycle.
// Formats   ends S1.30, limit U0.30, lines S1.38, pixels S1.24, rounded half up.
// Error     AdaptiveSphere up to 90 degrees: N.L and (N.H)^n, n <= 256, within the tolerance
//           behind the limit + 0.009 codes of slerp; up to 120, 0.036. RTL = model on every pixel.
// Bad input angles above 120 degrees count as 120.
// Model     model/normal/adaptive_normalizer.h     Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
#(
  parameter int unsigned Lanes = 1           // 1 or 4
) (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  adaptive_kind_e kind_i,             // stable while busy_o

  input  logic           span_valid_i,
  output logic           span_ready_o,
  input  lit_run_t       run_i,
  input  span_normal_t [1:0][Components-1:0] normal_i,     // first and last pixel
  input  angle_limit_t   limit_i,

  output logic           run_valid_o,        // with its first segment: it cannot wait
  output lit_run_t       run_o,

  output logic           pixel_valid_o,
  input  logic           pixel_ready_i,
  output pixel_normal_t [Lanes-1:0][Components-1:0] normal_o,
  output logic          [Lanes-1:0]                 mask_o,
  output logic           last_o,             // last group of its span

  output logic           count_valid_o,      // once a span
  output span_length_t   normalised_o,       // normalisations of the span
  output span_length_t   skipped_o,          // pixels less those, not below 0
  output logic           busy_o
);
  localparam int unsigned Latency = 10;
  localparam int unsigned Interval = 4;

  logic is_extended;
  assign is_extended = kind_i == AdaptiveExtended;

  logic                           setup_point_valid, divide_point_valid, point_valid;
  quantity_t     [Components-1:0] setup_point, divide_point;
  pixel_normal_t [Components-1:0] point;
  phong_direct u_phong_direct (
    .clk_i, .rst_ni,
    .valid_i (is_extended ? setup_point_valid : divide_point_valid),
    .normal_i(is_extended ? setup_point : divide_point),
    .valid_o (point_valid),
    .normal_o(point));

  logic           setup_valid, divide_ready, setup_busy;
  lit_run_t       setup_run;
  adaptive_span_t span;
  adaptive_normalizer_setup u_setup (
    .clk_i, .rst_ni, .kind_i,
    .span_valid_i, .span_ready_o, .run_i, .normal_i, .limit_i,
    .point_valid_o(setup_point_valid), .point_o(setup_point),
    .point_valid_i(point_valid), .point_i(point),
    .valid_o(setup_valid), .ready_i(divide_ready), .run_o(setup_run), .span_o(span),
    .busy_o (setup_busy));

  logic           part_valid, part_ready, divide_busy;
  lit_run_t       part_run;
  adaptive_part_t part;
  adaptive_normalizer_divide u_divide (
    .clk_i, .rst_ni, .kind_i,
    .span_valid_i(setup_valid), .span_ready_o(divide_ready), .run_i(setup_run), .span_i(span),
    .point_valid_o(divide_point_valid), .point_o(divide_point),
    .point_valid_i(point_valid), .point_i(point),
    .part_valid_o(part_valid), .part_ready_i(part_ready), .run_o(part_run), .part_o(part),
    .count_valid_o, .normalised_o, .skipped_o,
    .busy_o(divide_busy));

  logic              segment_valid, segment_ready, segment_busy, fill_busy;
  adaptive_segment_t segment;
  adaptive_normalizer_segment #(.Lanes(Lanes)) u_segment (
    .clk_i, .rst_ni,
    .part_valid_i(part_valid), .part_ready_o(part_ready), .run_i(part_run), .part_i(part),
    .segment_valid_o(segment_valid), .segment_ready_i(segment_ready), .run_o,
    .segment_o(segment), .busy_o(segment_busy));

  adaptive_normalizer_fill #(.Lanes(Lanes)) u_fill (
    .clk_i, .rst_ni,
    .segment_valid_i(segment_valid), .segment_ready_o(segment_ready), .segment_i(segment),
    .load_o(run_valid_o),
    .pixel_valid_o, .pixel_ready_i, .normal_o, .mask_o, .last_o,
    .busy_o(fill_busy));

  assign busy_o = setup_busy || divide_busy || segment_busy || fill_busy;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (span_valid_i && span_ready_o) begin
      assert (run_i.run.length != '0) else $error("adaptive_normalizer: a span of 0 pixels");
    end
  end
`endif
endmodule
