// SPDX-License-Identifier: Apache-2.0
//
// First stage of adaptive_normalizer: how often a span is halved, and 1/z of every level.
//
//   x_0 = |Nb - Na|^2 / 2      1/z_j = 1/sqrt(4 - 2 x_j)      x_(j+1) = 1 - sqrt(1 - x_j / 2)
//   levels J: x_J <= limit, or AdaptiveLevels         inverse = 2^e / m
//   AdaptiveExtended: Nb <- normalise((Na + (Nb - Na) 2^k / m) / 2), m <- 2^k
//
// Timing    Taken in cycle a, on offer from a + 4 + 3 J; 19 more for an extended span. The next is
//           taken in the cycle in which this one passes on. Two multipliers, one table step each.
// Formats   x and 1/z U1.32, inverse U1.30; every product rounded half up. x saturates at 1.5.
// Model     model/normal/adaptive_normalizer.h     Doc  docs/units/normal/adaptive_normalizer.md
module adaptive_normalizer_setup
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
  input  span_normal_t [1:0][Components-1:0] normal_i,
  input  angle_limit_t   limit_i,

  // phong_direct, for the end of an extended span.
  output logic                           point_valid_o,
  output quantity_t     [Components-1:0] point_o,
  input  logic                           point_valid_i,
  input  pixel_normal_t [Components-1:0] point_i,

  output logic           valid_o,
  input  logic           ready_i,
  output lit_run_t       run_o,
  output adaptive_span_t span_o,
  output logic           busy_o
);
  typedef logic signed [32:0] factor_t;
  typedef logic signed [65:0] product_t;
  localparam u1_32_t MostAngle = 33'h1_8000_0000;      // 120 degrees

  typedef enum logic [3:0] {
    StepSquareXY, StepSquareZ, StepAngle,
    StepLevel, StepSlope, StepValue,                   // of both tables; StepLevel decides
    StepInverse, StepInverseSlope, StepInverseValue,   // extended spans alone, and so on
    StepExtendX, StepExtendY, StepExtendZ, StepExtendLast, StepPoint, StepWait
  } step_e;

  logic           busy_q;
  step_e          step_q;
  adaptive_span_t span_q;
  lit_run_t       run_q;
  u1_32_t         angle_q;                             // x of the level
  logic [63:0]    square_q;                            // of x and y, U4.60
  product_t       first_q, second_q;                   // one for each multiplier

  logic take, enough, is_extended;
  assign is_extended  = kind_i == AdaptiveExtended;
  assign enough       = kind_i == AdaptiveChord || span_q.levels == 4'(AdaptiveLevels) ||
                        angle_q <= {1'b0, span_q.limit, 2'd0};
  assign valid_o      = busy_q && step_q == StepLevel && enough;
  assign span_ready_o = !busy_q || (valid_o && ready_i);
  assign take         = span_valid_i && span_ready_o;
  assign busy_o       = busy_q;
  assign run_o        = run_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else         busy_q <= take || (busy_q && !(valid_o && ready_i));
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      step_q <= is_extended ? StepInverse : StepSquareXY;
    end else if (busy_q && !valid_o) begin
      case (step_q)
        StepValue: step_q <= StepLevel;
        StepWait:  if (point_valid_i) step_q <= StepSquareXY;
        default:   step_q <= step_e'(step_q + 4'd1);
      endcase
    end
  end

  ////////////
  // Tables //
  ////////////

  // 1/m of the span's own steps, whatever the kind.
  logic [11:0]        steps;
  logic [3:0]         log;                             // floor(log2 m)
  logic [10:0]        fraction;                        // of m 2^-log
  logic        [34:0] inverse_value;
  logic signed [28:0] inverse_slope;
  logic        [19:0] inverse_curvature;
  assign steps = span_q.last_pixel == '0 ? 12'd1 : span_q.last_pixel;
  always_comb begin
    log = '0;
    for (int unsigned i = 1; i < 12; i++) if (steps[i]) log = 4'(i);
  end
  assign fraction = 11'(steps << (4'd11 - log));       // drops the leading 1
  normal_setup_chord_table u_inverse (
    .table_i('0), .segment_i({1'b0, fraction[10:4]}),
    .value_o(inverse_value), .slope_o(inverse_slope), .curvature_o(inverse_curvature));

  logic [32:0] divisor_value, half_value;
  logic [25:0] divisor_slope, half_slope;
  logic [20:0] divisor_curvature, half_curvature;
  adaptive_normalizer_table u_divisor (
    .half_i(1'b0), .segment_i(angle_q[32:26]),
    .value_o(divisor_value), .slope_o(divisor_slope), .curvature_o(divisor_curvature));
  adaptive_normalizer_table u_half (
    .half_i(1'b1), .segment_i(angle_q[32:26]),
    .value_o(half_value), .slope_o(half_slope), .curvature_o(half_curvature));

  function automatic product_t round_off(product_t product, logic [5:0] shift);
    round_off = ((product >>> (shift - 6'd1)) + product_t'(1)) >>> 1;
  endfunction

  // The level's 1/z, the next level's x, and 1/m.
  u1_32_t      divisor, half;
  logic [34:0] inverse_sum;
  u1_30_t      inverse;
  assign divisor     = divisor_value + 33'(round_off(first_q, 6'd26));
  assign half        = half_value + 33'(round_off(second_q, 6'd26));
  assign inverse_sum = inverse_value + 35'(round_off(second_q, 6'd31));
  assign inverse     = 31'((inverse_sum + 35'd8) >> 4);

  /////////////////
  // Multipliers //
  /////////////////

  factor_t [Components-1:0] chord;
  for (genvar i = 0; i < Components; i++) begin : gen_chord
    assign chord[i] = factor_t'(signed'(span_q.normal[1][i])) -
                      factor_t'(signed'(span_q.normal[0][i]));
  end

  factor_t first_left, first_right, second_left, second_right, place, offset;
  assign place  = factor_t'({1'b0, angle_q[25:0]});
  assign offset = factor_t'({1'b0, fraction[3:0], 27'd0});
  always_comb begin
    case (step_q)
      StepSquareXY:             {first_left, first_right} = {chord[0], chord[0]};
      StepSquareZ:              {first_left, first_right} = {chord[2], chord[2]};
      StepLevel:                {first_left, first_right} = {12'd0, divisor_curvature, place};
      StepExtendX:              {first_left, first_right} = {chord[0], 2'd0, span_q.inverse};
      StepExtendY:              {first_left, first_right} = {chord[1], 2'd0, span_q.inverse};
      StepExtendZ:              {first_left, first_right} = {chord[2], 2'd0, span_q.inverse};
      default:                  {first_left, first_right} =
          {factor_t'({1'b0, divisor_slope}) + factor_t'(round_off(first_q, 6'd26)), place};
    endcase
    case (step_q)
      StepSquareXY:             {second_left, second_right} = {chord[1], chord[1]};
      StepSquareZ, StepInverse: {second_left, second_right} = {13'd0, inverse_curvature, offset};
      StepAngle, StepInverseSlope: {second_left, second_right} =
          {factor_t'(inverse_slope) + factor_t'(round_off(second_q, 6'd31)), offset};
      StepLevel:                {second_left, second_right} = {12'd0, half_curvature, place};
      default:                  {second_left, second_right} =
          {factor_t'({1'b0, half_slope}) + factor_t'(round_off(second_q, 6'd26)), place};
    endcase
  end

  logic [63:0] square;                                 // |Nb - Na|^2, halved when rounded
  logic [35:0] angle;
  assign square = square_q + first_q[63:0];
  assign angle  = 36'((65'(square) + (65'd1 << 28)) >> 29);

  logic multiply;
  assign multiply = busy_q && !valid_o && step_q != StepPoint && step_q != StepWait;
  always_ff @(posedge clk_i) begin
    if (multiply) begin
      first_q  <= product_t'(first_left) * product_t'(first_right);
      second_q <= product_t'(second_left) * product_t'(second_right);
    end
    if (busy_q && step_q == StepSquareZ) square_q <= 64'(first_q) + 64'(second_q);
    if (busy_q && step_q == StepAngle) begin
      angle_q <= angle > 36'(MostAngle) ? MostAngle : angle[32:0];
    end
    if (busy_q && step_q == StepValue) angle_q <= half;
  end

  ///////////////////
  // Extended span //
  ///////////////////

  // Half of it, since it may be longer than 2.
  logic                       more;                    // 2^k is above m
  logic [1:0]                 component;               // whose product first_q holds
  quantity_t                  extended;
  quantity_t [Components-1:0] point_q;
  assign more      = fraction != '0;
  assign component = step_q == StepExtendY ? 2'd0 : step_q == StepExtendZ ? 2'd1 : 2'd2;
  assign extended  = quantity_t'({span_q.normal[0][component][31], span_q.normal[0][component],
                                  7'd0}) +
                     quantity_t'(round_off(first_q, more ? 6'd22 : 6'd23));
  assign point_valid_o = busy_q && step_q == StepPoint;
  assign point_o       = point_q;
  always_ff @(posedge clk_i) begin
    if (busy_q && step_q >= StepExtendY && step_q <= StepExtendLast) point_q[component] <= extended;
  end

  //////////
  // Span //
  //////////

  // In the first StepLevel of other spans second_q holds 1/m.
  logic first_level;
  assign first_level = !is_extended && span_q.levels == '0;
  always_ff @(posedge clk_i) begin
    if (take) begin
      run_q             <= run_i;
      span_q.normal     <= normal_i;
      span_q.limit      <= limit_i;
      span_q.last_pixel <= 12'(run_i.run.length - 13'd1);
      span_q.width      <= run_i.run.length - 13'd1;
      span_q.levels     <= '0;
    end else if (busy_q) begin
      case (step_q)
        StepAngle: if (!is_extended) span_q.exponent <= log;
        StepInverseValue: span_q.inverse <= inverse;
        StepLevel: if (first_level) span_q.inverse <= inverse;
        StepValue: begin
          span_q.divisor[span_q.levels] <= divisor;
          span_q.levels                 <= span_q.levels + 4'd1;
        end
        StepWait: if (point_valid_i) begin
          for (int unsigned i = 0; i < Components; i++) begin
            span_q.normal[1][i] <= {point_i[i], 6'd0};
          end
          span_q.width    <= 13'd1 << (log + 4'(more));
          span_q.inverse  <= 31'h4000_0000;
          span_q.exponent <= log + 4'(more);
        end
        default: ;
      endcase
    end
  end
  always_comb begin
    span_o = span_q;
    if (first_level)             span_o.inverse = inverse;
    if (kind_i == AdaptiveChord) span_o.levels  = 4'(AdaptiveLevels);
  end
endmodule
