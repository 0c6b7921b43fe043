// SPDX-License-Identifier: Apache-2.0
//
// Fixed-point formats. sI_F_t is signed SI.F: 1 sign, I integer and F fraction bits (1+I+F wide);
// uI_F_t is unsigned UI.F (I+F wide). model/fixed/fixed.h is the C++ twin (S<I, F>, U<I, F>).
package fixed_pkg;
  typedef logic signed [17:0] s1_16_t;
  typedef logic signed [23:0] s1_22_t;
  typedef logic signed [25:0] s1_24_t;
  typedef logic signed [29:0] s1_28_t;
  typedef logic signed [31:0] s1_30_t;
  typedef logic signed [35:0] s9_26_t;
  typedef logic signed [39:0] s1_38_t;
  typedef logic signed [45:0] s1_44_t;
  typedef logic        [ 7:0] u8_0_t;
  typedef logic        [15:0] u9_7_t;
  typedef logic        [16:0] u1_16_t;
  typedef logic        [17:0] u1_17_t;
  typedef logic        [23:0] u0_24_t;
  typedef logic        [24:0] u1_24_t;
  typedef logic        [28:0] u1_28_t;
  typedef logic        [30:0] u1_30_t;
  typedef logic        [32:0] u1_32_t;
  typedef logic        [40:0] u1_40_t;
  typedef logic        [23:0] u2_22_t;
  typedef logic        [45:0] u2_44_t;
endpackage
