// Vertices 1 and 2 from vertex 0. No state.
module setup_differences (
  input  logic [3*pineda_pkg::COORD_BITS-1:0]            x_i, // vertex 0 lowest
  input  logic [3*pineda_pkg::COORD_BITS-1:0]            y_i,

  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_o,
  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_o,
  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_o,
  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  logic signed [pineda_pkg::COORD_BITS-1:0] x0, x1, x2, y0, y1, y2;
  assign {x2, x1, x0} = x_i;
  assign {y2, y1, y0} = y_i;
  assign dx1_o = COEFF_BITS'(x1) - COEFF_BITS'(x0);
  assign dy1_o = COEFF_BITS'(y1) - COEFF_BITS'(y0);
  assign dx2_o = COEFF_BITS'(x2) - COEFF_BITS'(x0);
  assign dy2_o = COEFF_BITS'(y2) - COEFF_BITS'(y0);
endmodule
