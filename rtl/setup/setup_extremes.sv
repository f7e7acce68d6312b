// The extremes of a triangle and its anchor: the topmost, then leftmost vertex. No state.
//
// Bits     core::setup() defines the anchor, the first vertex of its canonical order.
// Twin     model/core/setup.cpp.
module setup_extremes (
  input  logic [3*pineda_pkg::COORD_BITS-1:0]       x_i, // vertex 0 lowest
  input  logic [3*pineda_pkg::COORD_BITS-1:0]       y_i,

  output logic [1:0]                                anchor_o,
  output logic signed [pineda_pkg::COORD_BITS-1:0]  x_low_o,
  output logic signed [pineda_pkg::COORD_BITS-1:0]  x_high_o,
  output logic signed [pineda_pkg::COORD_BITS-1:0]  y_low_o,
  output logic signed [pineda_pkg::COORD_BITS-1:0]  y_high_o
);
  localparam int unsigned COORD_BITS = pineda_pkg::COORD_BITS;

  logic signed [COORD_BITS-1:0] x0, x1, x2, y0, y1, y2;
  assign {x2, x1, x0} = x_i;
  assign {y2, y1, y0} = y_i;

  logic before10, before20, before21;
  assign before10 = y1 < y0 || (y1 == y0 && x1 < x0);
  assign before20 = y2 < y0 || (y2 == y0 && x2 < x0);
  assign before21 = y2 < y1 || (y2 == y1 && x2 < x1);
  assign anchor_o = before20 && before21 ? 2'd2 : {1'b0, before10};

  assign x_low_o  = x0 < x1 ? (x0 < x2 ? x0 : x2) : (x1 < x2 ? x1 : x2);
  assign x_high_o = x0 > x1 ? (x0 > x2 ? x0 : x2) : (x1 > x2 ? x1 : x2);
  assign y_low_o  = y0 < y1 ? (y0 < y2 ? y0 : y2) : (y1 < y2 ? y1 : y2);
  assign y_high_o = y0 > y1 ? (y0 > y2 ? y0 : y2) : (y1 > y2 ? y1 : y2);
endmodule
