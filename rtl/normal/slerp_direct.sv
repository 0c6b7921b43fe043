// SPDX-License-Identifier: Apache-2.0
//
// Normals of one lane along a span, paper 000 (6): two sines per pixel, by a CORDIC. The recurrence
// (7) of slerp_recurrence and slerp_paper removes them.
//
//   N = start cos(a) + side sin(a),  a = t step          lane j takes t = j, j + Lanes, ...
//
// Timing    Marches with the walker: 1 cycle from load_i to the first angle, then one per step_i.
//           Latency 30 cycles from valid_i, in whose cycle the pixel leaves the walker, to valid_o;
//           a normal a cycle, never stalls.
// Formats   angle U1.40, modulo 2, rounded to 36 fraction bits for 28 rotations, of which the first
//           is the same for all and costs nothing; x, y S1.34, shifts truncate; sine, cosine S1.28,
//           rounded; start, side S1.30; the sum is rounded half up once to S1.24, saturates.
// Error     0.75 ulp of S1.24 while the angle is at most 1.74 and start, side are unit vectors at
//           right angles. RTL = model.
// Bad input Angles from 1.74 to 2 stop short of their direction; larger ones wrap; sums saturate.
// Model     model/normal/slerp_direct.h           Doc  docs/units/normal/slerp_direct.md
module slerp_direct
  import fixed_pkg::*;
  import light_pkg::*;
  import normal_pkg::*;
#(
  parameter int unsigned Lane = 0,
  parameter int unsigned Lanes = 1
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic load_i,                       // takes arc_i
  input  logic step_i,                       // moves to the next pixel; load_i wins
  input  arc_t arc_i,
  input  logic valid_i,                      // the pixel leaves the walker
  output logic valid_o,
  output pixel_normal_t [Components-1:0] normal_o
);
  localparam int unsigned Latency = 30;
  localparam int unsigned Rotations = 28;
  localparam int unsigned Slots = 32;        // more than the spans that can be inside

  typedef logic signed [35:0] coordinate_t;  // S1.34
  typedef logic signed [37:0] residue_t;     // S1.36
  typedef logic [$clog2(Slots)-1:0] slot_t;

  typedef struct packed {
    coordinate_t x;
    coordinate_t y;
    residue_t    z;                          // angle still to turn
    slot_t       slot;
  } turn_t;

  typedef struct packed {
    span_normal_t [Components-1:0] start;
    span_normal_t [Components-1:0] side;
  } axes_t;

  // Product of 1/sqrt(1 + 4^-k), k = 0..27: x and y after the first rotation, by atan(1).
  localparam coordinate_t Start = 36'h26dd3b6a1;
  localparam residue_t    EighthTurn = 38'hc90fdaa22;
  // atan(2^-k), k = 1..27.
  localparam residue_t Turn [Rotations-1] = '{
    38'h76b19c158, 38'h3eb6ebf26, 38'h1fd5ba9ab, 38'hffaaddb9, 38'h7ff556ef, 38'h3ffeaab7,
    38'h1fffd556, 38'hffffaab, 38'h7ffff55, 38'h3ffffeb, 38'h1fffffd, 38'h1000000,
    38'h800000, 38'h400000, 38'h200000, 38'h100000, 38'h80000, 38'h40000,
    38'h20000, 38'h10000, 38'h8000, 38'h4000, 38'h2000, 38'h1000,
    38'h800, 38'h400, 38'h200
  };

  ///////////
  // Angle //
  ///////////

  angle_t angle_q, stride_q;
  slot_t  slot_q;                            // where the axes of this span are
  axes_t  axes_q [Slots];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)     slot_q <= '0;
    else if (load_i) slot_q <= slot_q + slot_t'(1);
  end
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      angle_q  <= angle_t'(arc_i.step * Lane);
      stride_q <= angle_t'(arc_i.step * Lanes);
      axes_q[slot_q + slot_t'(1)] <= '{start: arc_i.start, side: arc_i.side};
    end else if (step_i) begin
      angle_q <= angle_q + stride_q;
    end
  end

  ///////////////
  // Rotations //
  ///////////////

  logic [Latency-1:0] valid_q;
  turn_t              turn [Rotations];      // [k]: after the rotation by atan(2^-k)

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  residue_t angle;                           // U1.36, rounds halves up
  assign angle   = residue_t'({1'b0, angle_q[40:4]}) + residue_t'({37'd0, angle_q[3]});
  assign turn[0] = '{x: Start, y: Start, z: angle - EighthTurn, slot: slot_q};
  for (genvar k = 1; k < Rotations; k++) begin : gen_rotation
    turn_t       turn_q;
    coordinate_t x, y, dx, dy;
    residue_t    z;
    assign x  = turn[k-1].x;
    assign y  = turn[k-1].y;
    assign z  = turn[k-1].z;
    assign dx = y >>> k;
    assign dy = x >>> k;
    always_ff @(posedge clk_i) begin
      if (k == 1 ? valid_i : valid_q[k == 1 ? 0 : k - 2]) begin
        turn_q.x    <= z[37] ? x + dx : x - dx;
        turn_q.y    <= z[37] ? y - dy : y + dy;
        turn_q.z    <= z[37] ? z + Turn[k-1] : z - Turn[k-1];
        turn_q.slot <= turn[k-1].slot;
      end
    end
    assign turn[k] = turn_q;
  end

  ////////////
  // Normal //
  ////////////

  // S1.34 -> S1.28: rounds halves up.
  function automatic s1_28_t to_cosine_of_turn(coordinate_t value);
    to_cosine_of_turn = s1_28_t'((value + 36'sd32) >>> 6);
  endfunction

  typedef logic signed [61:0] product_t;     // S3.58

  s1_28_t                        cosine_q, sine_q;
  axes_t                         axes_read_q;
  product_t [Components-1:0]     along_q, across_q;
  pixel_normal_t [Components-1:0] normal_q;

  // S4.58 -> S1.24: rounds halves up, saturates.
  function automatic pixel_normal_t to_normal(logic signed [62:0] sum);
    logic signed [28:0] rounded;
    rounded = 29'((sum + (63'sd1 <<< 33)) >>> 34);
    if (rounded[28:25] == {4{rounded[28]}}) to_normal = rounded[25:0];
    else                                    to_normal = {rounded[28], {25{!rounded[28]}}};
  endfunction

  always_ff @(posedge clk_i) begin
    if (valid_q[Latency-4]) begin
      cosine_q    <= to_cosine_of_turn(turn[Rotations-1].x);
      sine_q      <= to_cosine_of_turn(turn[Rotations-1].y);
      axes_read_q <= axes_q[turn[Rotations-1].slot];
    end
    for (int unsigned i = 0; i < Components; i++) begin
      if (valid_q[Latency-3]) begin
        along_q[i]  <= product_t'($signed(axes_read_q.start[i])) * product_t'(cosine_q);
        across_q[i] <= product_t'($signed(axes_read_q.side[i])) * product_t'(sine_q);
      end
      if (valid_q[Latency-2]) begin
        normal_q[i] <= to_normal(63'($signed(along_q[i])) + 63'($signed(across_q[i])));
      end
    end
  end

  assign valid_o  = valid_q[Latency-1];
  assign normal_o = normal_q;
endmodule
