// SPDX-License-Identifier: Apache-2.0
//
// Methods of shading, sets of them, and what the choice of a triangle's method goes by.
// model/shading_method.h and model/choice/choice_types.h are the C++ twins.
package method_pkg;
  import fixed_pkg::*;
  import light_pkg::*;

  typedef enum logic [4:0] {
    MethodFlat                = 5'd0,
    MethodGouraud             = 5'd1,
    MethodQuad                = 5'd2,
    MethodQuadPolynomial      = 5'd3,
    MethodQuadHorner          = 5'd4,
    MethodQuadStep            = 5'd5,
    MethodQuadMidpoint        = 5'd6,
    MethodQuadThreeTerm       = 5'd7,
    MethodQuadThirdDifference = 5'd8,
    MethodQuadSegment         = 5'd9,
    MethodQuadDifference      = 5'd10,
    MethodQuadFootprint       = 5'd11,
    MethodQuadSplit           = 5'd12,
    MethodQuadCosine          = 5'd13,
    MethodPhongSurface        = 5'd14,
    MethodPhong               = 5'd15,
    MethodPhongTaylor         = 5'd16,
    MethodPhongDuff           = 5'd17,
    MethodSlerp               = 5'd18,
    MethodSlerpPaper          = 5'd19,
    MethodSlerpIntensity      = 5'd20,
    MethodSlerpDirect         = 5'd21,
    MethodAdaptive            = 5'd22,
    MethodAdaptivePaper       = 5'd23,
    MethodAdaptiveChord       = 5'd24,
    MethodFootprint           = 5'd25,
    MethodFootprintPaper      = 5'd26,
    MethodAuto                = 5'd27         // of a frame: each triangle has its own
  } method_e;

  // Which methods a build contains: bit k stands for the method with value k.
  localparam int unsigned NumMethods = 28;
  typedef logic [NumMethods-1:0] methods_t;
  localparam methods_t AllMethods = '1;
  function automatic methods_t method_bit(method_e method);
    method_bit = methods_t'(1) << method;
  endfunction

  // Methods that interpolate along a surface, by span_setup; the others interpolate normals.
  localparam methods_t SurfaceMethods = 28'h0007fff;
  // Methods that light every pixel, by lit_pixels; the others interpolate intensities.
  localparam methods_t LitMethods = 28'h7ffe000;
  // Methods that show interpolated intensities, and methods that interpolate normals.
  localparam methods_t IntensityMethods = 28'h0001fff;
  localparam methods_t NormalMethods = 28'h7ff8000;
  // Methods whose normals come from adaptive_normalizer, not from recurrences of normal_setup.
  localparam methods_t AdaptiveMethods = 28'h1c00000;
  // Methods that light several samples of a pixel and show their mean.
  localparam methods_t FootprintMethods = 28'h6000000;
  // Methods whose surfaces are of cosines.
  localparam methods_t CurveMethods =
    method_bit(MethodQuadCosine) | method_bit(MethodPhongSurface);
  // Surfaces of second order whose spans start from differences of rows.
  localparam methods_t PointMethods =
    method_bit(MethodQuadPolynomial) | method_bit(MethodQuadHorner);
  localparam methods_t RowMethods = SurfaceMethods & ~PointMethods & ~method_bit(MethodFlat) &
                                    ~method_bit(MethodGouraud);

  // A method, of a frame or of a triangle, is of the set; a build without others need not look.
  function automatic logic is_any_of(methods_t built, method_e frame, methods_t set);
    is_any_of = (built & set) != '0 && ((built & ~set) == '0 || set[frame]);
  endfunction
  function automatic logic is_method(methods_t built, method_e frame, method_e method);
    is_method = is_any_of(built, frame, method_bit(method));
  endfunction

  // Methods that method_choice chooses from. MethodAuto belongs to none of the sets above.
  localparam methods_t ChosenMethods =
    method_bit(MethodFlat) | method_bit(MethodGouraud) | method_bit(MethodQuad) |
    method_bit(MethodQuadCosine) | method_bit(MethodPhongSurface) | method_bit(MethodPhongDuff);

  // How far the normals of a triangle turn, and the cosines at its vertices, rounded outwards.
  typedef struct packed {
    u2_22_t turn;                            // largest |Ni - Nj|^2
    s1_16_t n_dot_l_low;
    s1_16_t n_dot_l_high;
    s1_16_t specular_low;                    // N.H; R.V: bounds on the whole triangle
    s1_16_t specular_high;
  } light_range_t;

  // A binary logarithm. -32 stands for that of 0.
  typedef logic signed [11:0] log_t;         // S6.5

  // What the choice needs of a material, relative to the tolerance.
  typedef struct packed {
    log_t       diffuse;                     // log2 of 255 kd / tolerance, brightest channel
    log_t       specular;                    // log2 of 255 ks / tolerance
    log_t       shininess_log;               // log2 n
    shininess_t shininess;
    logic       below_full;                  // ambient + kd + ks <= 1 in every channel
    logic       below_full_dark;             // ambient + kd <= 1
    logic [Channels-1:0] channels;           // that are not black
  } choice_limit_t;

  // How a triangle is shaded.
  typedef struct packed {
    method_e method;
    logic    dark;                           // no highlight that would show
    logic    ambient;                        // nor diffuse light
    logic [Channels-1:0] channels;           // that are not black
  } choice_t;
endpackage
