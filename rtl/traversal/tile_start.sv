// Edges of a tile at the first sample of the first group of stamps in its box: a multiple of a group from
// the tile's first sample. No state.
module tile_start (
  input  pineda_pkg::tile_t                         tile_i,
  output logic [3*pineda_pkg::TILE_EDGE_BITS-1:0]   start_e_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::TILE_EDGE_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2 + pineda_pkg::TESTED_STAMPS_LOG2;
  localparam int unsigned HEIGHT_LOG2 = pineda_pkg::STAMP_HEIGHT_LOG2;
  for (genvar i = 0; i < 3; i++) begin : gen_edges
    logic signed [EDGE_BITS-1:0] a, b;
    assign a = EDGE_BITS'(signed'(tile_i.a[i*COEFF_BITS +: COEFF_BITS]));
    assign b = EDGE_BITS'(signed'(tile_i.b[i*COEFF_BITS +: COEFF_BITS]));
    always_comb begin
      start_e_o[i*EDGE_BITS +: EDGE_BITS] = tile_i.e[i*EDGE_BITS +: EDGE_BITS];
      for (int unsigned k = WIDTH_LOG2; k < TILE_LOG2; k++) begin
        start_e_o[i*EDGE_BITS +: EDGE_BITS] =
            start_e_o[i*EDGE_BITS +: EDGE_BITS] + (tile_i.x0[k] ? a << k : '0);
      end
      for (int unsigned k = HEIGHT_LOG2; k < TILE_LOG2; k++) begin
        start_e_o[i*EDGE_BITS +: EDGE_BITS] =
            start_e_o[i*EDGE_BITS +: EDGE_BITS] + (tile_i.y0[k] ? b << k : '0);
      end
    end
  end
endmodule
