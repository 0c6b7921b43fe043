// SPDX-License-Identifier: Apache-2.0
//
// Second stage of adaptive_normalizer: halves a span, depth first and from left to right, and
// issues its parts.
//
//   N(mid) = (Nl + Nr) / z_j      paper 002 (1), on level j
//
// A part is issued when its level is the span's, or when no pixel lies inside it; one without any
// pixel is passed over. A part that contains the last pixel is the last, whatever lies behind it.
//
// Timing    A span taken in cycle b acts from b + 1: a division, issue or pass takes a cycle; an
//           issue waits for part_ready_i. The next span is taken in the cycle of the last issue.
//           AdaptiveChord: adaptive_normalizer_chord, 14 cycles for the ends, 13 for a division, 2
//           more for a part that is not divided after all.
// Formats   places U13.12 pixels, exact; normals S1.30, rounded half up.
// Model     model/normal/adaptive_normalizer.h     Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer_divide
  import fixed_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
  import shading_pkg::*;
(
  input  logic           clk_i,
  input  logic           rst_ni,
  input  adaptive_kind_e kind_i,

  input  logic           span_valid_i,
  output logic           span_ready_o,
  input  lit_run_t       run_i,
  input  adaptive_span_t span_i,

  // phong_direct, for points of a chord.
  output logic                           point_valid_o,
  output quantity_t     [Components-1:0] point_o,
  input  logic                           point_valid_i,
  input  pixel_normal_t [Components-1:0] point_i,

  output logic           part_valid_o,
  input  logic           part_ready_i,
  output lit_run_t       run_o,
  output adaptive_part_t part_o,

  output logic           count_valid_o,      // with the last part of a span
  output span_length_t   normalised_o,       // normalisations of the span
  output span_length_t   skipped_o,          // pixels less those, not below 0
  output logic           busy_o
);
  typedef logic [24:0] place_t;
  typedef span_normal_t [Components-1:0] node_t;
  typedef struct packed {
    node_t      normal;                      // right end of a part
    logic [3:0] level;                       // of that part
  } pending_t;

  logic           busy_q;
  adaptive_span_t span_q;                    // but for its ends
  lit_run_t       run_q;
  span_length_t   count_q;
  node_t          left_q;                    // of the part at hand
  pending_t [AdaptiveLevels:0] pending_q;    // right ends; [depth_q] of the part at hand
  logic [3:0]     depth_q, level_q, depth, level;        // one more
  place_t         place_q;

  pending_t top;
  node_t    middle;
  assign top   = pending_q[depth_q];
  assign depth = depth_q + 4'd1;
  assign level = level_q + 4'd1;

  /////////////////////
  // The part's fate //
  /////////////////////

  logic         is_chord, chord_ready, chord_near, chord_middle;
  place_t       right;
  span_length_t next, first, behind, pixels;
  logic         inner, last, divide, issue, pass, done, take;
  assign is_chord = kind_i == AdaptiveChord;
  assign right    = place_q + ({span_q.width, 12'd0} >> level_q);
  assign next     = place_q[24:12] + 13'd1;
  assign first    = 13'((place_q + 25'd4095) >> 12);
  assign behind   = 13'((right + 25'd4095) >> 12);
  assign last     = right >= {1'b0, span_q.last_pixel, 12'd0};
  assign pixels   = (last ? 13'(span_q.last_pixel) + 13'd1 : behind) - first;
  // The last pixel is never before next: a part that contains it is the last.
  assign inner    = level_q != span_q.levels && {next, 12'd0} < right;

  // Not for chords, which take their time.
  logic whole;                               // the part is not divided
  assign whole        = busy_q && (is_chord ? chord_ready && (!inner || chord_near) : !inner);
  assign divide       = busy_q && inner && (!is_chord || chord_middle);
  assign part_valid_o = whole && pixels != '0;
  assign issue        = part_valid_o && part_ready_i;
  assign done         = issue && last;
  assign pass         = (whole && pixels == '0) || (issue && !last);
  assign span_ready_o = !busy_q || done;
  assign take         = span_valid_i && span_ready_o;
  assign busy_o       = busy_q;

  assign run_o  = run_q;
  assign part_o = '{normal: {top.normal, left_q}, inverse: span_q.inverse,
                    exponent: span_q.exponent, level: level_q, place: place_q,
                    first: first[11:0], count: pixels, last: last};

  ////////////
  // Middle //
  ////////////

  logic                       chord_left, chord_right;     // its ends arrive
  logic  signed [33:0]        divisor;
  node_t                      chord_node;
  logic                       halve;        // else the factors rest at 0
  assign halve   = busy_q && inner && !is_chord;
  assign divisor = halve ? signed'({1'b0, span_q.divisor[level_q]}) : '0;
  for (genvar i = 0; i < Components; i++) begin : gen_middle
    logic signed [32:0] sum;
    logic signed [66:0] product;
    assign sum           = halve ? 33'(signed'(left_q[i])) + 33'(signed'(top.normal[i])) : '0;
    assign product       = 67'(sum) * 67'(divisor);
    assign chord_node[i] = {point_i[i], 6'd0};
    assign middle[i]     = is_chord ? chord_node[i]
                                    : span_normal_t'((product + 67'sh8000_0000) >>> 32);
  end

  adaptive_normalizer_chord u_chord (
    .clk_i, .rst_ni,
    .take_i  (take && is_chord),
    .normal_i(span_i.normal),
    .limit_i (span_q.limit),
    .look_i  (busy_q && is_chord && inner),
    .done_i  (pass || done),
    .level_i (level_q),
    .left_i  (left_q),
    .right_i (top.normal),
    .point_valid_o, .point_o, .point_valid_i,
    .left_o  (chord_left), .right_o(chord_right), .middle_o(chord_middle),
    .ready_o (chord_ready), .near_o(chord_near),
    .pass_i  (pass));

  ///////////
  // State //
  ///////////

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else         busy_q <= take || (busy_q && !done);
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      run_q   <= run_i;
      span_q  <= span_i;
      left_q  <= span_i.normal[0];
      place_q <= '0;
      level_q <= '0;
      depth_q <= '0;
      pending_q[0] <= '{normal: span_i.normal[1], level: '0};
      count_q <= is_chord ? 13'd2 : 13'(kind_i == AdaptiveExtended);
    end else if (divide) begin
      level_q <= level;
      depth_q <= depth;
      pending_q[depth] <= '{normal: middle, level: level};
      count_q <= count_q + 13'd1;
    end else if (pass) begin
      place_q <= right;
      left_q  <= top.normal;
      level_q <= top.level;
      depth_q <= depth_q - 4'd1;
    end else begin
      if (chord_left)  left_q              <= chord_node;
      if (chord_right) pending_q[0].normal <= chord_node;
    end
  end

  span_length_t length;
  assign length        = 13'(span_q.last_pixel) + 13'd1;
  assign count_valid_o = done;
  assign normalised_o  = count_q;
  assign skipped_o     = length > count_q ? length - count_q : '0;
endmodule
