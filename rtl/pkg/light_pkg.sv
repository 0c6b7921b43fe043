// SPDX-License-Identifier: Apache-2.0
//
// Vocabulary of lighting: vectors, cosines, materials. model/light/light_types.h is the C++ twin.
package light_pkg;
  import fixed_pkg::*;

  localparam int unsigned Channels = 3;      // index 0 red, 1 green, 2 blue
  localparam int unsigned Components = 3;    // index 0 x, 1 y, 2 z

  typedef u8_0_t  code_t;                    // displayed intensity, round(255 I)
  typedef s1_22_t direction_t;               // component of light, half and view vector
  typedef s1_24_t pixel_normal_t;            // component of the normal of a pixel
  typedef s1_30_t cosine_t;                  // N.L, N.H, N.V, R.V
  typedef u1_17_t diffuse_t;                 // N.L clamped to 0..1
  typedef u1_16_t reflectance_t;             // coefficient times light colour, 0..1
  typedef u9_7_t  shininess_t;               // exponent n, 1..256
  typedef u1_16_t highlight_t;               // (N.H)^n, 0..1

  typedef enum logic {
    LightingBlinn = 1'b0,                    // specular cosine N.H
    LightingPhong = 1'b1                     // specular cosine R.V = 2 (N.L)(N.V) - L.V
  } lighting_e;

  // Light and viewer are at infinity: constants of a frame.
  typedef struct packed {
    lighting_e                   lighting;
    direction_t [Components-1:0] light;
    direction_t [Components-1:0] half_or_view;   // H for Blinn, V for Phong
    cosine_t                     l_dot_v;        // used by Phong
  } light_t;

  // What a normal contributes to lighting.
  typedef struct packed {
    cosine_t n_dot_l;
    cosine_t n_dot_h_or_v;
  } cosines_t;

  typedef struct packed {
    reflectance_t [Channels-1:0] ambient;
    reflectance_t [Channels-1:0] diffuse;
    reflectance_t [Channels-1:0] specular;
    shininess_t                  shininess;
  } material_t;

  localparam int unsigned NumMaterials = 256;
  typedef logic [7:0] material_index_t;

  // S4.30 -> S1.30: saturates.
  function automatic cosine_t to_cosine(logic signed [34:0] cosine);
    if (cosine[34:31] == {4{cosine[34]}}) to_cosine = cosine[31:0];
    else                                  to_cosine = {cosine[34], {31{!cosine[34]}}};
  endfunction

  // S1.30 -> U1.17: clamps to [0, 1], rounds halves up.
  function automatic diffuse_t to_diffuse(cosine_t cosine);
    if (cosine[31])      to_diffuse = '0;
    else if (cosine[30]) to_diffuse = 18'h20000;
    else                 to_diffuse = {1'b0, cosine[29:13]} + 18'(cosine[12]);
  endfunction
endpackage
