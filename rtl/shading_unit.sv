// SPDX-License-Identifier: Apache-2.0
//
// Shading unit: triangles and their spans in, shaded pixels out.
//
//   triangle, span -> span_setup -> pixel_walker + (flat_color | gouraud_interpolator |
//                                                   quad_surface) x 3 -> pixel
//
// Methods   A build holds only the hardware of the methods in Methods; a frame names one of them.
// Timing    1 pixel per cycle. Span set-up overlaps the previous span: no bubble between spans of
//           5 pixels or more. First pixel of an idle unit: span_setup latency + 1 after its span.
// Streams   ready/valid; valid does not wait for ready, a payload holds until taken. A frame is
//           taken when the unit is empty; while one waits, no further triangle is taken.
// Formats   shading_pkg. Pixels leave in the order of the spans, left to right.
// Model     model/shading_unit.h      Doc  docs/units/shading_unit.md
module shading_unit
  import light_pkg::*;
  import shading_pkg::*;
#(
  parameter methods_t Methods = AllMethods
) (
  input  logic      clk_i,
  input  logic      rst_ni,

  input  logic      frame_valid_i,
  output logic      frame_ready_o,
  input  frame_t    frame_i,

  input  logic      triangle_valid_i,
  output logic      triangle_ready_o,
  input  triangle_t triangle_i,

  input  logic      span_valid_i,
  output logic      span_ready_o,
  input  span_t     span_i,

  output logic      pixel_valid_o,
  input  logic      pixel_ready_i,
  output pixel_t    pixel_o,

  output counters_t counters_o    // of the current frame
);
  logic   frame_valid_q;
  frame_t frame_q;
  logic   take_frame;

  ////////////
  // Set-up //
  ////////////

  logic  triangle_gate, setup_triangle_ready, setup_busy, span_inside;
  logic  seed_valid, seed_ready;
  seed_t seed;
  assign triangle_gate    = frame_valid_q && !frame_valid_i;
  assign triangle_ready_o = setup_triangle_ready && triangle_gate;

  span_setup #(.Methods(Methods)) u_span_setup (
    .clk_i, .rst_ni,
    .method_i        (frame_q.method),
    .triangle_valid_i(triangle_valid_i && triangle_gate),
    .triangle_ready_o(setup_triangle_ready),
    .triangle_i,
    .span_valid_i, .span_ready_o, .span_i,
    .seed_valid_o    (seed_valid),
    .seed_ready_i    (seed_ready),
    .seed_o          (seed),
    .span_inside_o   (span_inside),
    .busy_o          (setup_busy)
  );

  ////////////
  // Pixels //
  ////////////

  logic load, step;
  pixel_walker u_pixel_walker (
    .clk_i, .rst_ni,
    .run_valid_i  (seed_valid),
    .run_ready_o  (seed_ready),
    .run_i        (seed.run),
    .pixel_valid_o, .pixel_ready_i,
    .pixel_x_o    (pixel_o.x),
    .pixel_y_o    (pixel_o.y),
    .pixel_z_o    (pixel_o.z),
    .pixel_last_o (pixel_o.last),
    .load_o       (load),
    .step_o       (step)
  );

  code_t [Channels-1:0] code;
  assign pixel_o.r = code[0];
  assign pixel_o.g = code[1];
  assign pixel_o.b = code[2];

  for (genvar ch = 0; ch < Channels; ch++) begin : gen_channel
    code_t [NumMethods-1:0] method_code;
    logic  [NumMethods-1:0] selected;
    for (genvar m = 0; m < NumMethods; m++) begin : gen_selected
      assign selected[m] = Methods == methods_t'(1 << m) || frame_q.method == method_e'(m);
    end

    if (Methods[MethodFlat]) begin : gen_flat
      flat_color u_flat_color (
        .clk_i, .load_i(load && selected[MethodFlat]),
        .seed_i(seed.channel[ch]), .code_o(method_code[MethodFlat]));
    end else begin : gen_no_flat
      assign method_code[MethodFlat] = '0;
    end

    if (Methods[MethodGouraud]) begin : gen_gouraud
      gouraud_interpolator u_gouraud_interpolator (
        .clk_i, .load_i(load && selected[MethodGouraud]), .step_i(step && selected[MethodGouraud]),
        .seed_i(seed.channel[ch]), .code_o(method_code[MethodGouraud]));
    end else begin : gen_no_gouraud
      assign method_code[MethodGouraud] = '0;
    end

    if (Methods[MethodQuad]) begin : gen_quad
      quad_surface u_quad_surface (
        .clk_i, .load_i(load && selected[MethodQuad]), .step_i(step && selected[MethodQuad]),
        .seed_i(seed.channel[ch]), .code_o(method_code[MethodQuad]));
    end else begin : gen_no_quad
      assign method_code[MethodQuad] = '0;
    end

    always_comb begin
      code[ch] = '0;
      for (int m = 0; m < NumMethods; m++) begin
        if (Methods[m] && selected[m]) code[ch] = method_code[m];
      end
    end
  end

  ////////////////////////
  // Frame and counters //
  ////////////////////////

  counters_t counters_q;
  assign counters_o    = counters_q;
  assign frame_ready_o = !setup_busy && !pixel_valid_o;
  assign take_frame    = frame_valid_i && frame_ready_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni)         frame_valid_q <= 1'b0;
    else if (take_frame) frame_valid_q <= 1'b1;
  end

  always_ff @(posedge clk_i) begin
    if (take_frame) begin
      frame_q    <= frame_i;
      counters_q <= '0;
    end else begin
      if (pixel_valid_o && pixel_ready_i)  counters_q.pixels <= counters_q.pixels + 1'b1;
      if (pixel_valid_o && !pixel_ready_i) counters_q.stall  <= counters_q.stall + 1'b1;
      if (!pixel_valid_o && span_inside)   counters_q.setup  <= counters_q.setup + 1'b1;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (take_frame) begin
      assert (Methods[frame_i.method]) else $error("shading_unit: method is not in this build");
    end
  end
`endif
endmodule
