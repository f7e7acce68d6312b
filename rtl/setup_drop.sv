// Whether a triangle ends in setup, and its area and direction. No state.
//
// Bits     core::setup().
// Drops    area2 = 0, culled by facing, box empty.
// Twin     model/core/setup.cpp.
module setup_drop (
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
endmodule
