// SPDX-License-Identifier: Apache-2.0
//
// Joins the seeds of surfaces and of normals in the order of their spans, in frames where triangles
// have methods of their own. Seeds of surfaces wait here, so that the set-up of later spans goes on
// while normal_setup, which takes longer, works at an earlier one. A part of span_seeds; it has no
// page of its own.
//
// Timing    A seed of a surface is on offer a cycle after it was taken, one of normals at once,
//           both when the spans before have left. Depth seeds wait.
// Streams   ready/valid; a payload holds until taken.
// Formats   as span_setup.
// Error     None.
// Model     SeedQueue in model/choice/seed_queue.h      Doc  docs/units/shading_unit.md
module seed_queue
  import shading_pkg::*;
#(
  parameter int unsigned Width = 1,          // bits of a surface's seed
  parameter int unsigned Depth = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             span_i,           // a span is taken by a set-up
  input  logic             span_normal_i,    // by that of normals

  input  logic             surface_valid_i,
  output logic             surface_ready_o,
  input  logic [Width-1:0] surface_i,
  input  logic             normal_valid_i,
  output logic             normal_ready_o,

  output logic             seed_valid_o,
  input  logic             seed_ready_i,
  output logic             seed_normal_o,    // it is the one at the normals' port
  output logic [Width-1:0] surface_o,
  output logic             busy_o
);
  localparam int unsigned Spans = 32;        // more than the set-ups and the queue hold
  typedef logic [$clog2(Depth)-1:0] place_t;
  typedef logic [$clog2(Depth):0]   count_t;
  typedef logic [$clog2(Spans)-1:0] span_place_t;

  logic [Width-1:0] seed_mem [Depth];
  logic [Spans-1:0] normal_mem;              // of each span: its seed is one of normals
  count_t           write_q, read_q;         // seeds so far
  span_place_t      span_write_q, span_read_q;

  logic has_span, has_surface, write, read, leave;
  assign has_span        = span_write_q != span_read_q;
  assign has_surface     = write_q != read_q;
  assign seed_normal_o   = normal_mem[span_read_q];
  assign seed_valid_o    = has_span && (seed_normal_o ? normal_valid_i : has_surface);
  assign leave           = seed_valid_o && seed_ready_i;
  assign read            = leave && !seed_normal_o;
  assign normal_ready_o  = has_span && seed_normal_o && seed_ready_i;
  assign surface_ready_o = count_t'(write_q - read_q) != count_t'(Depth) || read;
  assign write           = surface_valid_i && surface_ready_o;
  assign surface_o       = seed_mem[place_t'(read_q)];
  assign busy_o          = has_span;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {write_q, read_q}           <= '0;
      {span_write_q, span_read_q} <= '0;
    end else begin
      if (write)  write_q      <= write_q + 1'b1;
      if (read)   read_q       <= read_q + 1'b1;
      if (span_i) span_write_q <= span_write_q + 1'b1;
      if (leave)  span_read_q  <= span_read_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (write)  seed_mem[place_t'(write_q)] <= surface_i;
    if (span_i) normal_mem[span_write_q]    <= span_normal_i;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    assert (!span_i || span_place_t'(span_write_q + 1'b1) != span_read_q || leave)
      else $error("seed_queue: too many spans");
  end
`endif
endmodule
