// The box of samples that a triangle can cover, clipped by the scissor. No state.
//
// Bits     core::setup() defines the box of samples.
// Out      box_o: x0, y0, x1, y1, the first lowest; of no meaning where empty_o.
// Twin     model/core/setup.cpp.
module setup_box (
  input  pineda_pkg::frame_t                        frame_i,
  input  logic signed [pineda_pkg::COORD_BITS-1:0]  x_low_i,
  input  logic signed [pineda_pkg::COORD_BITS-1:0]  x_high_i,
  input  logic signed [pineda_pkg::COORD_BITS-1:0]  y_low_i,
  input  logic signed [pineda_pkg::COORD_BITS-1:0]  y_high_i,

  output logic                                      empty_o,
  output logic [4*pineda_pkg::PIXEL_BITS-1:0]       box_o
);
  logic [pineda_pkg::PIXEL_BITS-1:0] x0, y0, x1, y1;
  logic x_empty, y_empty;
  setup_range u_x (
    .low_i(x_low_i), .high_i(x_high_i),
    .clip_first_i(frame_i.clip_x0), .clip_end_i(frame_i.clip_x1),
    .empty_o(x_empty), .first_o(x0), .last_o(x1)
  );
  setup_range u_y (
    .low_i(y_low_i), .high_i(y_high_i),
    .clip_first_i(frame_i.clip_y0), .clip_end_i(frame_i.clip_y1),
    .empty_o(y_empty), .first_o(y0), .last_o(y1)
  );
  assign empty_o = x_empty || y_empty;
  assign box_o = {y1, x1, y0, x0};
endmodule
