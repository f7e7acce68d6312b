// Whether a triangle ends in setup, and its area and direction. No state.
//
// Bits     core::setup().
// Drops    area2 = 0, culled by facing, box empty.
// Twin     model/core/setup.cpp.
module setup_drop (
`ifdef PINEDA_COUNTERS
  input  logic                                      clk_i,
  input  logic                                      count_i,     // a triangle is here
  input  logic                                      no_sample_i, // its box is empty, unclipped
`endif
  input  pineda_pkg::frame_t                        frame_i,
  input  logic signed [pineda_pkg::AREA2_BITS-1:0]  area2_i,
  input  logic                                      empty_i,

  output logic                                      drop_o,
  output logic                                      clockwise_o,
  output logic [pineda_pkg::AREA2_BITS-2:0]         abs_area2_o
);
  logic culled;
  assign clockwise_o = !area2_i[pineda_pkg::AREA2_BITS-1];
  assign culled = (frame_i.cull == pineda_pkg::CULL_BACK && clockwise_o) ||
                  (frame_i.cull == pineda_pkg::CULL_FRONT && !clockwise_o);
  assign drop_o = area2_i == '0 || culled || empty_i;
  assign abs_area2_o = (pineda_pkg::AREA2_BITS-1)'(clockwise_o ? area2_i : -area2_i);

`ifdef PINEDA_COUNTERS
  // Numbered as core::Drop; the first cause in that order counts.
  logic [2:0] cause;
  assign cause = area2_i == '0 ? 3'd1 : culled ? 3'd2 : no_sample_i ? 3'd3 : empty_i ? 3'd4 : 3'd0;
  cycle_counters #(.Kinds(5)) u_drops (.clk_i, .count_i, .kind_i(cause));
`endif
endmodule
