// SPDX-License-Identifier: Apache-2.0
//
// Part of adaptive_normalizer_divide: points of a chord and the comparison of a part.
//
//   ends      normalise(Na), normalise(Nb)
//   middle    normalise(Na + (Nb - Na) w)       w: the middle of the part
//   near     |Nr - Nl|^2 / 2 <= limit
//
// Timing    Ends: left_o 13 cycles after take_i, right_o one later, ready_o from the next cycle on.
//           A part that looks: near_o from its third cycle, or middle_o in its thirteenth. near_o
//           holds until done_i.
// Formats   w U1.12, points S1.38, rounded half up; normals S1.24 in S1.30.
// Model     model/normal/adaptive_normalizer.h     Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer_chord
  import fixed_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
(
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         take_i,
  input  span_normal_t [1:0][Components-1:0] normal_i,   // with take_i
  input  angle_limit_t limit_i,
  input  logic         look_i,               // the part at hand might be divided
  input  logic         done_i,               // it is issued or passed over
  input  logic         pass_i,               // to the part behind it
  input  logic [3:0]   level_i,
  input  span_normal_t [Components-1:0] left_i,
  input  span_normal_t [Components-1:0] right_i,

  output logic                       point_valid_o,
  output quantity_t [Components-1:0] point_o,
  input  logic                       point_valid_i,

  output logic         left_o,
  output logic         right_o,
  output logic         middle_o,
  output logic         ready_o,              // the ends are there
  output logic         near_o
);
  typedef enum logic [2:0] {
    StateIdle, StateLeft, StateRight, StateEnds, StateLook, StateCompare, StateMiddle
  } state_e;

  state_e      state_q;
  logic        got_left_q, near_q, launch_q;
  logic [12:0] place_q;                      // of the part's left end on the chord, U1.12
  span_normal_t [1:0][Components-1:0] normal_q;
  quantity_t [Components-1:0]        point_q;
  logic [Components-1:0][53:0]       square_q;

  logic near, arrive;
  logic [55:0] sum;
  assign sum    = 56'(square_q[0]) + 56'(square_q[1]) + 56'(square_q[2]);
  assign near  = sum <= {7'd0, limit_i, 19'd0};
  assign arrive = point_valid_i && state_q == StateEnds;

  assign left_o        = arrive && !got_left_q;
  assign right_o       = arrive && got_left_q;
  assign middle_o      = point_valid_i && state_q == StateMiddle;
  assign ready_o       = state_q == StateLook;
  assign near_o       = near_q;
  assign point_valid_o = launch_q || (state_q == StateCompare && !near);
  assign point_o       = point_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= StateIdle;
      launch_q <= 1'b0;
    end else begin
      launch_q <= state_q == StateLeft || state_q == StateRight;
      if (take_i) begin
        state_q <= StateLeft;
      end else begin
        case (state_q)
          StateLeft:    state_q <= StateRight;
          StateRight:   state_q <= StateEnds;
          StateEnds:    if (right_o) state_q <= StateLook;
          StateLook:    if (look_i && !near_q) state_q <= StateCompare;
          StateCompare: state_q <= near ? StateLook : StateMiddle;
          StateMiddle:  if (middle_o) state_q <= StateLook;
          default: ;
        endcase
      end
    end
  end

  // Where the point lies: the ends, or the middle of the part.
  logic [12:0] place;
  assign place = state_q == StateLeft ? '0 : state_q == StateRight ? 13'h1000
                 : place_q + 13'(13'h0800 >> level_i);
  logic sample;
  assign sample = state_q == StateLeft || state_q == StateRight ||
                  (state_q == StateLook && look_i && !near_q);
  for (genvar i = 0; i < Components; i++) begin : gen_component
    logic signed [32:0] chord;
    logic signed [46:0] product;
    logic signed [26:0] difference;
    assign chord      = 33'(signed'(normal_q[1][i])) - 33'(signed'(normal_q[0][i]));
    assign product    = 47'(chord) * 47'(signed'({1'b0, place}));
    assign difference = 27'(signed'(right_i[i][31:6])) - 27'(signed'(left_i[i][31:6]));
    always_ff @(posedge clk_i) begin
      if (sample) begin
        point_q[i]  <= quantity_t'({normal_q[0][i], 8'd0}) +
                       quantity_t'((product + 47'sd8) >>> 4);
        square_q[i] <= 54'(54'(difference) * 54'(difference));
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (take_i) begin
      normal_q   <= normal_i;
      place_q    <= '0;
      got_left_q <= 1'b0;
      near_q    <= 1'b0;
    end else begin
      if (left_o) got_left_q <= 1'b1;
      if (state_q == StateCompare) near_q <= near;
      else if (done_i)             near_q <= 1'b0;
      if (pass_i) place_q <= place_q + 13'(13'h1000 >> level_i);
    end
  end
endmodule
