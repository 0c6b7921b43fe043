// SPDX-License-Identifier: Apache-2.0
//
// Largest errors of a highlight of at most 2^-k, by method, as found by search with a margin: a
// part of method_choice.
//
// Timing    Combinational.
// Formats   highlight U5.5, -log2 of its maximum; logarithms S8.5. From k = 4 on 3/4 of the
//           fraction of highlight come off, for the errors fall by more than that.
// Model     model/choice/method_choice_table.h      Doc  docs/units/choice/method_choice.md
module method_choice_table (
  input  logic        [ 9:0] highlight_i,
  output logic signed [13:0] flat_o,       // over 255 ks sqrt(n) l
  output logic signed [13:0] gouraud_o,    // over 255 ks n l^2
  output logic signed [13:0] quad_o,       // over 255 ks (sqrt(n) l)^3
  output logic signed [13:0] cosine_o      // over 255 ks sqrt(n) l^3
);
  typedef logic signed [13:0] sum_t;

  localparam sum_t Flat [16] = '{
    -14'sd1, -14'sd2, -14'sd21, -14'sd42, -14'sd68, -14'sd95, -14'sd124, -14'sd153,
    -14'sd182, -14'sd213, -14'sd243, -14'sd274, -14'sd305, -14'sd337, -14'sd369, -14'sd400};
  localparam sum_t Gouraud [16] = '{
    -14'sd55, -14'sd79, -14'sd79, -14'sd91, -14'sd111, -14'sd134, -14'sd158, -14'sd183,
    -14'sd209, -14'sd235, -14'sd263, -14'sd291, -14'sd320, -14'sd350, -14'sd379, -14'sd409};
  localparam sum_t Quad [16] = '{
    -14'sd161, -14'sd163, -14'sd199, -14'sd199, -14'sd199, -14'sd226, -14'sd244, -14'sd265,
    -14'sd288, -14'sd311, -14'sd336, -14'sd361, -14'sd387, -14'sd414, -14'sd441, -14'sd470};
  localparam sum_t Cosine [16] = '{
    -14'sd146, -14'sd155, -14'sd174, -14'sd196, -14'sd222, -14'sd249, -14'sd278, -14'sd307,
    -14'sd337, -14'sd366, -14'sd397, -14'sd428, -14'sd459, -14'sd491, -14'sd522, -14'sd556};

  logic [3:0] entry;
  logic [4:0] fraction;
  sum_t       fall;

  assign entry    = highlight_i[9] ? 4'd15 : highlight_i[8:5];
  assign fraction = highlight_i[4:0];
  assign fall     = entry >= 4'd4 && entry != 4'd15 ? sum_t'({9'd0, fraction - 5'(fraction >> 2)})
                                                    : '0;

  assign flat_o    = Flat[entry] - fall;
  assign gouraud_o = Gouraud[entry] - fall;
  assign quad_o    = Quad[entry] - fall;
  assign cosine_o  = Cosine[entry] - fall;
endmodule
