// The first sample of the box's first tile, from the anchor. No state.
module setup_reference (
  input  logic signed [pineda_pkg::COORD_BITS-1:0]       x_i, // the anchor
  input  logic signed [pineda_pkg::COORD_BITS-1:0]       y_i,
  input  logic [2*pineda_pkg::PIXEL_BITS-1:0]            box_i, // first column lowest, first row

  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_x_o,
  output logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_y_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;

  // The corner of the tile and half a pixel
  localparam logic signed [COEFF_BITS-1:0] HALF = COEFF_BITS'(1 << (S - 1));
  logic [PIXEL_BITS-1:0] column, row;
  assign {row, column} = box_i;
  assign ref_x_o = (COEFF_BITS'(column[PIXEL_BITS-1:TILE_LOG2]) << (TILE_LOG2 + S)) + HALF -
                   COEFF_BITS'(x_i);
  assign ref_y_o = (COEFF_BITS'(row[PIXEL_BITS-1:TILE_LOG2]) << (TILE_LOG2 + S)) + HALF -
                   COEFF_BITS'(y_i);
endmodule
