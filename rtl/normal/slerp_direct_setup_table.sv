// SPDX-License-Identifier: Apache-2.0
//
// Quadratics of slerp_direct_setup: the angle over its chord and the chord over its sine, for
// x = kappa in [0, 0.625).
//
// Timing    Combinational.
// Formats   value U1.34, slope U-8.34 (26 bits), curvature U-16.34 (18 bits), for t in [0, 1) along
//           the segment: value + t (slope + t curvature).
// Model     model/normal/slerp_direct_setup_table.h
// Doc       docs/units/normal/slerp_direct_setup.md
module slerp_direct_setup_table (
  input  logic        table_i,      // 0 AngleOverChord, 1 ChordOverSine
  input  logic [5:0]  segment_i,    // 0..39
  output logic [34:0] value_o,
  output logic [25:0] slope_o,
  output logic [17:0] curvature_o
);
  // 2 asin(sqrt(x) / 2) / sqrt(x), 40 segments of 1/64.
  localparam logic [78:0] AngleOverChord [40] = '{
    79'h4000000002aaaa5c4d0d, 79'h400aaf7a52ad12e84d97, 79'h4015689f82af7fc84e23,
    79'h40202b80f2b1f10c4eb1, 79'h402af83052b466b84f40, 79'h4035cebf52b6e0e04fd1,
    79'h4040af3ff2b95f905063, 79'h404b99c482bbe2d050f7, 79'h40568e5f42be6aac518c,
    79'h40618d22d2c0f7385223, 79'h406c962202c3887c52bc, 79'h4077a96fd2c61e885356,
    79'h4082c71f82c8b96853f3, 79'h408def4462cb59285491, 79'h409921f232cdfddc5530,
    79'h40a45f3cc2d0a78c55d2, 79'h40afa73832d356485675, 79'h40baf9f8c2d60a20571b,
    79'h40c6579312d8c32457c2, 79'h40d1c01be2db8160586b, 79'h40dd33a832de44e85916,
    79'h40e8b24d52e10dc459c3, 79'h40f43c20b2e3dc0c5a72, 79'h40ffd13822e6afcc5b23,
    79'h410b71a992e989145bd6, 79'h41171d8b72ec67f45c8b, 79'h4122d4f412ef4c805d42,
    79'h412e97fa72f236c85dfc, 79'h413a66b582f526e05eb8, 79'h4146413c92f81cd45f76,
    79'h415227a762fb18b86036, 79'h415e1a0dd2fe1aa060f9, 79'h416a18880301229c61be,
    79'h4176232e730430c06285, 79'h41823a19f3074524634f, 79'h418e5d63930a5fd4641b,
    79'h419a8d24c30d80e864ea, 79'h41a6c9773310a87465bb, 79'h41b31274e313d68c668f,
    79'h41bf683833170b446766
  };
  // 1 / sqrt(1 - x / 4), 40 segments of 1/64.
  localparam logic [78:0] ChordOverSine [40] = '{
    79'h4000000007fffdd581bf, 79'h40201814180c0ce1858c, 79'h404060a128183a558966,
    79'h4060da21a824869d8d4e, 79'h40818511c830f22d9144, 79'h40a261ef883d7d6d9548,
    79'h40c3713a884a28d1995b, 79'h40e4b3744856f4d19d7c, 79'h410629202863e1dda1ac,
    79'h4127d2c33870f071a5ec, 79'h4149b0e4887e2105aa3b, 79'h416bc40d288b7415ae9a,
    79'h418e0cc80898ea21b309, 79'h41b08ba208a683adb789, 79'h41d3412a38b44139bc19,
    79'h41f62df198c2234dc0ba, 79'h4219528b58d02a6dc56d, 79'h423caf8cd8de5729ca31,
    79'h4260458d88ecaa0dcf08, 79'h4284152738fb23add3f1, 79'h42a81ef5f909c495d8ec,
    79'h42cc639809188d5dddfb, 79'h42f0e3ae39277ea1e31d, 79'h43159fdb993698fde853,
    79'h433a98c5c945dd0ded9d, 79'h435fcf14e9554b75f2fc, 79'h438543739964e4d9f870,
    79'h43aaf68f0974a9e1fdf9, 79'h43d0e91739849b3a0398, 79'h43f71bbec994b992094d,
    79'h441d8f3b19a5059e0f1a, 79'h4444444449b5800e14fd, 79'h446b3b9589c629a21af8,
    79'h449275ecc9d70316210c, 79'h44b9f40b19e80d2a2737, 79'h44e1b6b479f948a62d7d,
    79'h4509beb02a0ab65233db, 79'h45320cc86a1c56fa3a54, 79'h455aa1cada2e2b7240e8,
    79'h45837e887a40348e4797
  };

  assign {value_o, slope_o, curvature_o} = table_i ? ChordOverSine[segment_i]
                                                   : AngleOverChord[segment_i];
endmodule
