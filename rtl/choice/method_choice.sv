// SPDX-License-Identifier: Apache-2.0
//
// The cheapest method of a triangle whose error against exact Blinn-Phong of the linear normal is
// at most the tolerance T on every pixel, and at most T / 2 on its edges:
//
//   2^Ld + 2^Ls <= 1,  Ld >= log2(Ed / T),  Ls >= log2(Es / T)
//
// of the diffuse and the specular light, both sums of logarithms of the material, of the turn l of
// the normals, of n and of the brightest highlight on the triangle. First of flat, gouraud, quad,
// quad-cosine; else one that is exact, phong-surface up to 104 degrees, phong-duff beyond.
//
// Timing    Combinational.
// Formats   turn U2.22, cosines S1.16, logarithms S6.5 in and S8.5 inside, rounded up.
// Error     Chosen methods stay within the tolerance, without their own arithmetic.
// Bad input None: what is chosen for it has no meaning.
// Model     model/choice/method_choice.h      Doc  docs/units/choice/method_choice.md
module method_choice
  import fixed_pkg::*;
  import light_pkg::*;
  import method_pkg::*;
(
  input  light_range_t  range_i,
  input  choice_limit_t limit_i,
  input  lighting_e     lighting_i,
  output choice_t       choice_o
);
  localparam int unsigned Latency = 0;

  typedef logic signed [13:0] sum_t;           // S8.5
  localparam sum_t OneLog  = 14'sd32;
  localparam sum_t ZeroLog = -14'sd1024;
  localparam sum_t DarkLog = -14'sd96;         // a highlight of at most T / 8 does not show

  // Twins of the constants in model/choice/method_choice_table.h.
  localparam sum_t FlatDiffuse    = 14'sd19;
  localparam sum_t GouraudDiffuse = -14'sd55;
  localparam sum_t GouraudKink    = -14'sd26;
  localparam sum_t QuadDiffuse    = -14'sd129;
  localparam sum_t QuadKink       = -14'sd61;
  localparam sum_t CosineDiffuse  = -14'sd127;
  localparam sum_t Reflected      = 14'sd32;
  localparam sum_t Wide           = 14'sd20;

  localparam u2_22_t SurfaceTurn = 24'ha00000;  // 2.5: |N|^2 is at least 1/6

  localparam int unsigned Candidates = 4;
  localparam method_e Candidate [Candidates] = '{
    MethodFlat, MethodGouraud, MethodQuad, MethodQuadCosine};

  function automatic sum_t larger(sum_t a, sum_t b);
    larger = a > b ? a : b;
  endfunction

  function automatic sum_t half_up(sum_t value);
    half_up = (value + 14'sd1) >>> 1;
  endfunction

  // log2 rounded up: log2(1 + m) <= m + 0.0861.
  function automatic sum_t turn_log(u2_22_t turn);
    logic [4:0] exponent, fraction;
    exponent = '0;
    for (int unsigned k = 0; k < 24; k++) begin
      if (turn[k]) exponent = 5'(k);
    end
    fraction = 5'({turn, 5'd0} >> exponent);   // drops the leading 1
    turn_log = sum_t'({4'd0, exponent, fraction}) - 14'(22 * 32 - 4);
  endfunction

  // -log2 of the highlight's maximum over the triangle, rounded down: n t,
  //   t = 23/16 (1 - cosine) - c l^2,  c = 65/256 for l^2 < 1/4, else 5/16
  // with c = 0 for the bound of R.V, which holds for the whole triangle.
  function automatic logic [9:0] highlight_log(u2_22_t turn, s1_16_t cosine, shininess_t shininess,
                                               lighting_e lighting);
    logic        [19:0] square;                // 16 fraction bits, rounded up
    logic signed [19:0] below, dilation;
    logic signed [24:0] scaled;
    logic signed [25:0] t;
    u1_16_t             clamped;
    logic        [14:0] product;
    square   = 20'((26'(turn) + 26'd63) >> 6);
    dilation = (square >> 2) + (square < 20'h4000 ? square >> 8 : square >> 4) + 20'd2;
    below    = 20'sh10000 - 20'(cosine);
    scaled   = 25'((25'(below) * 25'sd23) >>> 4);
    t        = 26'(scaled) - (lighting == LightingPhong ? '0 : 26'(dilation));
    clamped  = t < 0 ? '0 : t > 26'sh1ffff ? '1 : t[16:0];
    product  = 15'((33'(shininess) * 33'(clamped)) >> 18);
    highlight_log = product[14:10] != '0 ? '1 : product[9:0];
  endfunction

  // log2(1 + 2^-d), d in quarters, rounded up.
  function automatic logic [5:0] sum_log(logic [4:0] d);
    localparam logic [5:0] Sum [32] = '{
      6'd32, 6'd29, 6'd25, 6'd22, 6'd19, 6'd17, 6'd14, 6'd13, 6'd11, 6'd9, 6'd8,
      6'd7, 6'd6, 6'd5, 6'd4, 6'd4, 6'd3, 6'd3, 6'd2, 6'd2, 6'd2, 6'd2, 6'd2,
      6'd1, 6'd1, 6'd1, 6'd1, 6'd1, 6'd1, 6'd1, 6'd1, 6'd1};
    sum_log = Sum[d];
  endfunction

  // log2(2^a + 2^b) <= 0.
  function automatic logic is_within(sum_t a, sum_t b);
    logic [10:0] distance;                     // in quarters
    sum_t        sum;
    distance = 11'((a > b ? a - b : b - a) >> 3);
    sum = larger(a, b);
    if (distance[10:5] == '0) sum += sum_t'({8'd0, sum_log(distance[4:0])});
    is_within = sum <= 0;
  endfunction

  sum_t turn, diffuse, specular, shininess, highlight;
  logic [9:0] faint;
  logic none, straight, blinn, black, dark, lit, terminator, smooth, whole;

  assign turn       = turn_log(range_i.turn);
  assign none       = range_i.turn == '0;
  assign straight   = range_i.turn <= 24'h400000;
  assign blinn      = lighting_i == LightingBlinn;
  assign diffuse    = sum_t'(limit_i.diffuse);
  assign shininess  = sum_t'(limit_i.shininess_log);
  assign black      = sum_t'(limit_i.specular) == ZeroLog || range_i.specular_high <= 0;
  assign specular   = black ? ZeroLog : sum_t'(limit_i.specular);
  assign faint      = highlight_log(range_i.turn, range_i.specular_high, limit_i.shininess,
                                    lighting_i);
  assign highlight  = straight ? sum_t'({4'd0, faint}) : '0;
  assign dark       = black || specular - highlight <= DarkLog;
  assign lit        = range_i.n_dot_l_high > 0 && diffuse != ZeroLog;
  assign terminator = lit && range_i.n_dot_l_low < 0;
  // Below n = 4 a highlight has no smooth end: only its steady part is looked at.
  assign smooth     = limit_i.shininess >= 16'd512 || range_i.specular_low >= 18'sh8000;
  assign whole      = straight &&
                      (dark ? limit_i.below_full_dark : limit_i.below_full && smooth && blinn);

  // Logarithms of l, l^2, l^3; of w = sqrt(n) l, w^2, w^3; of sqrt(n) l^3. From n = 4 down the
  // slope of a highlight falls less than sqrt(n).
  sum_t l1, l3, few, w1, w2, w3, root, wide, bend, dropped;
  assign l1      = half_up(turn);
  assign l3      = half_up(turn + (turn <<< 1));
  assign few     = larger('0, half_up(14'sd64 - shininess));
  assign w2      = turn + shininess;
  assign w1      = half_up(w2);
  assign w3      = half_up(w2 + (w2 <<< 1));
  assign root    = half_up(shininess) + l3 + few + (blinn ? '0 : Reflected);
  // The bend of N.H under the peak, n l^4.
  assign wide    = larger('0, w1 + (blinn ? '0 : Reflected) - Wide);
  assign bend    = highlight < OneLog ? wide : '0;
  // A dropped highlight may be missing on one side of an edge.
  assign dropped = larger(specular - highlight + OneLog, ZeroLog);

  sum_t flat, gouraud, quad, cosine;
  method_choice_table u_table (
    .highlight_i(highlight[9:0]), .flat_o(flat), .gouraud_o(gouraud), .quad_o(quad),
    .cosine_o(cosine));

  sum_t diffuse_log [Candidates];
  sum_t specular_log [Candidates];
  logic [Candidates-1:0] good, allowed;

  assign allowed = {straight, whole, whole, straight && (blinn || dark)};
  always_comb begin
    diffuse_log[0] = diffuse + l1 + FlatDiffuse;
    diffuse_log[1] = diffuse + (terminator ? l1 + GouraudKink : turn + GouraudDiffuse);
    diffuse_log[2] = diffuse + (terminator ? l1 + QuadKink : l3 + QuadDiffuse);
    diffuse_log[3] = larger(diffuse + l3 + CosineDiffuse, ZeroLog);
    specular_log[0] = specular + w1 + few + flat;
    specular_log[1] = specular + w2 + gouraud;
    specular_log[2] = specular + w3 + few + quad;
    specular_log[3] = specular + root + bend + cosine;
    for (int unsigned k = 0; k < Candidates; k++) begin
      good[k] = allowed[k] &&
                is_within(lit || Candidate[k] == MethodQuadCosine ? diffuse_log[k] : ZeroLog,
                       dark ? dropped : specular_log[k]);
    end
  end

  always_comb begin
    choice_o.dark     = dark;
    choice_o.ambient  = dark && !lit;
    choice_o.channels = limit_i.channels;
    choice_o.method   = range_i.turn <= SurfaceTurn ? MethodPhongSurface : MethodPhongDuff;
    for (int k = int'(Candidates) - 1; k >= 0; k--) begin
      if (good[k]) choice_o.method = Candidate[k];
    end
    if (none || choice_o.ambient) choice_o.method = MethodFlat;
  end
endmodule
