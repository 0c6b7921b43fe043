// SPDX-License-Identifier: Apache-2.0
//
// Largest errors of a highlight of at most 2^-k, by method, as found by search with a margin: a part
// of method_choice.
//
// Timing    Combinational.
// Formats   highlight U5.5, -log2 of its maximum; logarithms S8.5. From k = 4 on 3/4 of the fraction
//           of highlight come off, for the errors fall by more than that.
// Model     model/choice/method_choice_table.h      Doc  docs/units/choice/method_choice.md
module method_choice_table (
  input  logic        [ 9:0] highlight_i,
  output logic signed [13:0] flat_o,       // over 255 ks sqrt(n) l
  output logic signed [13:0] gouraud_o,    // over 255 ks n l^2
  output logic signed [13:0] quad_o,       // over 255 ks (sqrt(n) l)^3
  output logic signed [13:0] cosine_o,     // over 255 ks sqrt(n) l^3
  output logic signed [13:0] slerp_o       // over 255 ks sqrt(n) l^3
);
  typedef logic signed [13:0] sum_t;

  localparam sum_t Flat [16] = '{
    -14'sd1, -14'sd2, -14'sd23, -14'sd50, -14'sd76, -14'sd106, -14'sd136, -14'sd168,
    -14'sd200, -14'sd231, -14'sd262, -14'sd294, -14'sd327, -14'sd363, -14'sd391, -14'sd427};
  localparam sum_t Gouraud [16] = '{
    -14'sd55, -14'sd80, -14'sd80, -14'sd94, -14'sd119, -14'sd143, -14'sd169, -14'sd196,
    -14'sd225, -14'sd254, -14'sd284, -14'sd314, -14'sd346, -14'sd376, -14'sd407, -14'sd439};
  localparam sum_t Quad [16] = '{
    -14'sd161, -14'sd163, -14'sd202, -14'sd202, -14'sd202, -14'sd232, -14'sd253, -14'sd276,
    -14'sd300, -14'sd326, -14'sd352, -14'sd379, -14'sd407, -14'sd435, -14'sd464, -14'sd494};
  localparam sum_t Cosine [16] = '{
    -14'sd146, -14'sd155, -14'sd175, -14'sd201, -14'sd228, -14'sd256, -14'sd286, -14'sd316,
    -14'sd347, -14'sd378, -14'sd410, -14'sd441, -14'sd473, -14'sd507, -14'sd538, -14'sd573};
  localparam sum_t Slerp [16] = '{
    -14'sd151, -14'sd162, -14'sd182, -14'sd208, -14'sd235, -14'sd264, -14'sd295, -14'sd325,
    -14'sd356, -14'sd387, -14'sd418, -14'sd452, -14'sd485, -14'sd518, -14'sd548, -14'sd581};

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
  assign slerp_o   = Slerp[entry] - fall;
endmodule
