// SPDX-License-Identifier: Apache-2.0
//
// Quadratics of normal_setup's third stage: kappa / phi^2 and sin(phi) / phi.
//
// Timing    Combinational.
// Formats   value U1.34, slope S-6.34 (29 bits), curvature U-14.34 (20 bits), for t in [0, 1) along
//           the segment: value + t (slope + t curvature).
// Model     model/normal/normal_setup_table.h       Doc  docs/units/normal/normal_setup.md
module normal_setup_angle_table (
  input  logic               table_i,      // 0 Chord, 1 SineOverAngle
  input  logic [3:0]         segment_i,    // 0..9
  output logic        [34:0] value_o,
  output logic signed [28:0] slope_o,
  output logic        [19:0] curvature_o
);
  // K(x) = 4 sin^2(sqrt(x) / 2) / x, 10 segments of 1/16.
  localparam logic [83:0] Chord [10] = '{
    84'h800000001aaaab042d70c, 84'h7f55b0411ab058ef2d49e, 84'h7eac15f1bab601fe2d231,
    84'h7e0330769abba6332cfc6, 84'h7d5aff34bac145922cd5c, 84'h7cb381917ac6e01e2caf5,
    84'h7c0cb6f2dacc75dc2c88f, 84'h7b669ebf3ad206ce2c62b, 84'h7ac1385d5ad792f72c3c8,
    84'h7a1c83343add1a5c2c168
  };
  // S(x) = sin(sqrt(x)) / sqrt(x), 10 segments of 1/16.
  localparam logic [83:0] SineOverAngle [10] = '{
    84'h80000000155556bb88403, 84'h7eabbb53d5665e0e87a4b, 84'h7d59965af57751f08709b,
    84'h7c098ea855883273866f4, 84'h7abba1d13598ffa985d56, 84'h796fcd6d35a9b9a3853c0,
    84'h78260f1595ba607284a32, 84'h76de646635caf427840ae, 84'h7598cafcd5db74d283731,
    84'h7455407975ebe28682dbd
  };

  assign {value_o, slope_o, curvature_o} = table_i ? SineOverAngle[segment_i] : Chord[segment_i];
endmodule
