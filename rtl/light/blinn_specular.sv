// SPDX-License-Identifier: Apache-2.0
//
// The highlight of paper 000 (1), (12): a cosine, clamped to [0, 1], to the power of the shininess.
//
//   x^n = 2^-t,  t = n y,  y = -log2 x = z - log2(1 - u / 2)  with  x = (1 - u / 2) 2^-z
//   2^-t = 2^g 2^-octaves,  octaves = ceil t,  g = octaves - t
//
// Both functions are quadratics on segments, rising with u and g. Every truncation keeps the order.
//
// Timing    Latency 8 cycles, a pixel a cycle, never stalls.
// Formats   x S1.30, n U9.7, result U1.16 (halves up). u U0.29, y U5.30, t U14.23, 2^g U2.22.
// Error     < 0.65 ulp of U1.16 for every x, n = 1..256; 0^n = 0, 1^n = 1; rises with x, falls
//           with n. Other n are accepted: n = 0 gives 1, and the error grows with n.
// Gating    A stage is clocked for pixels whose result is not yet known to be 0.
// Model     model/light/blinn_specular.h      Doc  docs/units/light/blinn_specular.md
module blinn_specular
  import light_pkg::*;
  import specular_table_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       valid_i,
  input  logic       skip_i,        // no reflectance needs the highlight: 0
  input  cosine_t    cosine_i,
  input  shininess_t shininess_i,
  output logic       valid_o,
  output highlight_t highlight_o,
  output logic       skipped_o      // skip_i or cosine_i <= 0: the power was not computed
);
  localparam int unsigned Latency = 8;

  typedef struct packed {
    logic [29:0] less_one;          // x - 1 ulp, shifted left by zeros, ones shifted in
    logic [4:0]  zeros;
    shininess_t  shininess;
  } scaled_t;

  typedef struct packed {
    logic [28:0] u;                 // U0.29
    logic [4:0]  zeros;
    shininess_t  shininess;
  } mantissa_t;

  typedef struct packed {
    logic [34:0] start;             // U5.30, y at the start of the segment
    logic [23:0] slope;             // U2.22
    logic [21:0] distance;          // 2^-29, from the start of the segment
    shininess_t  shininess;
  } log_slope_t;

  typedef struct packed {
    logic [34:0] log;               // y, U5.30
    shininess_t  shininess;
  } log_t;

  typedef struct packed {
    logic [4:0]  octaves;           // 0..17
    logic [22:0] g;                 // U0.23
  } exponent_t;

  typedef struct packed {
    logic [4:0]  octaves;
    logic [22:0] start;             // U1.22
    logic [18:0] slope;             // U2.17
    logic [17:0] distance;          // 2^-23
  } exp_slope_t;

  typedef struct packed {
    logic [4:0]  octaves;
    logic [23:0] exp;               // 2^g, U2.22, 1..2
  } exp_t;

  // Whether a pixel is in a stage, whether its power was never wanted, and whether it is still
  // unknown. Stage k holds the pixel k + 1 cycles after it came.
  logic [Latency-1:0] valid_q;
  logic [Latency-1:0] skipped_q;
  logic [Latency-2:0] live_q;

  scaled_t    scaled_q,    scaled_d;
  mantissa_t  mantissa_q,  mantissa_d;
  log_slope_t log_slope_q, log_slope_d;
  log_t       log_q,       log_d;
  exponent_t  exponent_q,  exponent_d;
  exp_slope_t exp_slope_q, exp_slope_d;
  exp_t       exp_q,       exp_d;
  highlight_t highlight_q, highlight_d;

  // Leading zeros of x - 1 ulp, a number of 30 bits: first the multiples of 8.
  logic wanted;
  assign wanted = !skip_i && cosine_i > 0;

  always_comb begin
    scaled_d.shininess = shininess_i;
    scaled_d.less_one  = cosine_i[30] ? '1 : cosine_i[29:0] - 30'd1;
    scaled_d.zeros     = '0;
    if (scaled_d.less_one[29:14] == '0) begin
      scaled_d.less_one = {scaled_d.less_one[13:0], 16'hffff};
      scaled_d.zeros[4] = 1'b1;
    end
    if (scaled_d.less_one[29:22] == '0) begin
      scaled_d.less_one = {scaled_d.less_one[21:0], 8'hff};
      scaled_d.zeros[3] = 1'b1;
    end
  end

  // Then the rest. Below the leading one stands 1 - u - 1 ulp.
  logic [29:0] normalized;

  always_comb begin
    mantissa_d.shininess = scaled_q.shininess;
    mantissa_d.zeros     = scaled_q.zeros;
    normalized           = scaled_q.less_one;
    if (normalized[29:26] == '0) begin
      normalized          = {normalized[25:0], 4'hf};
      mantissa_d.zeros[2] = 1'b1;
    end
    if (normalized[29:28] == '0) begin
      normalized          = {normalized[27:0], 2'b11};
      mantissa_d.zeros[1] = 1'b1;
    end
    if (!normalized[29]) begin
      normalized          = {normalized[28:0], 1'b1};
      mantissa_d.zeros[0] = 1'b1;
    end
    mantissa_d.u = ~normalized[28:0];
  end

  // y = z + value + (slope + curvature d) d; d has 22 bits, 18 of them for the curvature.
  logic [6:0]  log_segment;
  logic [34:0] log_bend;            // U0.42
  logic [45:0] log_rise;            // U0.51

  assign log_segment = mantissa_q.u[28:22];
  assign log_bend    = 35'(LogCurvature[log_segment]) * 35'(mantissa_q.u[21:4]);
  assign log_rise    = 46'(log_slope_q.slope) * 46'(log_slope_q.distance);

  always_comb begin
    log_slope_d.shininess = mantissa_q.shininess;
    log_slope_d.distance  = mantissa_q.u[21:0];
    log_slope_d.start     = {mantissa_q.zeros, LogValue[log_segment]};
    log_slope_d.slope     = 24'(LogSlope[log_segment]) + 24'(log_bend >> 20);
    log_d.shininess       = log_slope_q.shininess;
    log_d.log             = log_slope_q.start + 35'(log_rise >> 21);
  end

  // t = n y in U14.23; from t > 17 on the result rounds to 0.
  logic [50:0] product;             // U14.37
  logic [13:0] octaves;
  logic        visible;

  assign product = 51'(log_q.log) * 51'(log_q.shininess);
  assign octaves = product[50:37] + 14'(product[36:14] != '0);
  assign visible = octaves < 14'd18;

  always_comb begin
    exponent_d.octaves = octaves[4:0];
    exponent_d.g       = -product[36:14];
  end

  // 2^g = value + (slope + curvature d) d; d has 18 bits, 13 of them for the curvature.
  logic [4:0]  exp_segment;
  logic [25:0] exp_bend;            // U0.31
  logic [36:0] exp_rise;            // U0.40

  assign exp_segment = exponent_q.g[22:18];
  assign exp_bend    = 26'(ExpCurvature[exp_segment]) * 26'(exponent_q.g[17:5]);
  assign exp_rise    = 37'(exp_slope_q.slope) * 37'(exp_slope_q.distance);

  always_comb begin
    exp_slope_d.octaves  = exponent_q.octaves;
    exp_slope_d.distance = exponent_q.g[17:0];
    exp_slope_d.start    = ExpValue[exp_segment];
    exp_slope_d.slope    = 19'(ExpSlope[exp_segment]) + 19'(exp_bend >> 14);
    exp_d.octaves        = exp_slope_q.octaves;
    exp_d.exp            = 24'(exp_slope_q.start) + 24'(exp_rise >> 18);
  end

  // 2^-octaves and the step from 22 to 16 fraction bits; a 17th one rounds.
  logic [18:0] doubled;
  assign doubled     = 19'(exp_q.exp >> 5 >> exp_q.octaves) + 19'd1;
  assign highlight_d = live_q[Latency-2] ? doubled[17:1] : '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= '0;
      live_q  <= '0;
    end else begin
      valid_q <= {valid_q[Latency-2:0], valid_i};
      live_q  <= {live_q[5:4], live_q[3] && visible, live_q[2:0], valid_i && wanted};
    end
  end

  always_ff @(posedge clk_i) begin
    skipped_q <= {skipped_q[Latency-2:0], !wanted};
    if (valid_i && wanted)    scaled_q    <= scaled_d;
    if (live_q[0])            mantissa_q  <= mantissa_d;
    if (live_q[1])            log_slope_q <= log_slope_d;
    if (live_q[2])            log_q       <= log_d;
    if (live_q[3] && visible) exponent_q  <= exponent_d;
    if (live_q[4])            exp_slope_q <= exp_slope_d;
    if (live_q[5])            exp_q       <= exp_d;
    if (valid_q[Latency-2])   highlight_q <= highlight_d;
  end

  assign valid_o     = valid_q[Latency-1];
  assign highlight_o = highlight_q;
  assign skipped_o   = skipped_q[Latency-1];
endmodule
