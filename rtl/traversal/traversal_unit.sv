// Traversal: the tiles of a triangle's box, in those that are not rejected the covered samples, and
// of these the stamps.
//
// Bits     core::TileWalk and core::StampWalk define every output bit.
// In       prim_i: edges and planes at the first sample of the box's first tile.
// Out      stamp_o: coverage mask and planes of one stamp; never empty.
// Rate     side by side, each a cycle: a tile tested, TESTED_STAMPS stamps tested, a stamp sent.
//          Latency 4 cycles from a triangle to its first stamp.
// Drops    tiles that an edge rejects or that are hidden, stamps without a covered sample.
// Errors   none.
// Twin     model/core/traversal.cpp. Source: Pineda, SIGGRAPH 1988.
module traversal_unit (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  // Triangles set up, from setup_unit
  input  logic                     prim_valid_i,
  output logic                     prim_ready_o,
  input  pineda_pkg::setup_prim_t  prim_i,

`ifdef PINEDA_HIERARCHICAL_Z
  // The greatest depth stored in a tile, from hierarchical_z, in the same cycle; hides_i: the frame's
  // depth function lets tiles be hidden
  input  logic                                        hides_i,
  input  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0]  z_max_i,
  output logic [pineda_pkg::TILE_INDEX_BITS-1:0]      tile_x_o,
  output logic [pineda_pkg::TILE_INDEX_BITS-1:0]      tile_y_o,
`endif

  // Stamps, to interp_ztest_unit; stable while stamp_valid_o && !stamp_ready_i
  output logic                     stamp_valid_o,
  input  logic                     stamp_ready_i,
  output pineda_pkg::stamp_t       stamp_o,

  output logic                     idle_o
);
  logic walked_valid, walked_ready, tile_valid, tile_ready, tiles_busy, stamps_idle;
  pineda_pkg::tile_t walked, tile;

  tile_walker u_tiles (
    .clk_i, .rst_ni,
    .prim_valid_i, .prim_ready_o, .prim_i,
`ifdef PINEDA_HIERARCHICAL_Z
    .hides_i, .z_max_i, .tile_x_o, .tile_y_o,
`endif
    .tile_valid_o(walked_valid), .tile_ready_i(walked_ready), .tile_o(walked),
    .busy_o(tiles_busy)
  );

  // Rejected tiles are passed over while the stamps of earlier ones are sent. Perspective alone needs
  // edges at the tile's first sample behind the FIFO.
  localparam int unsigned E_BITS = 3 * pineda_pkg::TILE_EDGE_BITS;
  logic [E_BITS-1:0] walked_start_e, start_e;
  tile_start u_start (.tile_i(walked), .start_e_o(walked_start_e));
`ifdef PINEDA_PERSPECTIVE
  stream_fifo #(
    .Width(E_BITS + pineda_pkg::TILE_BITS), .Depth(pineda_pkg::TILE_FIFO_DEPTH)
  ) u_fifo (
    .clk_i, .rst_ni,
    .in_valid_i(walked_valid), .in_ready_o(walked_ready), .in_data_i({walked_start_e, walked}),
    .out_valid_o(tile_valid), .out_ready_i(tile_ready), .out_data_o({start_e, tile})
  );
`else
  pineda_pkg::tile_t started;
  always_comb begin
    started = walked;
    started.e = walked_start_e;
  end
  stream_fifo #(.Width(pineda_pkg::TILE_BITS), .Depth(pineda_pkg::TILE_FIFO_DEPTH)) u_fifo (
    .clk_i, .rst_ni,
    .in_valid_i(walked_valid), .in_ready_o(walked_ready), .in_data_i(started),
    .out_valid_o(tile_valid), .out_ready_i(tile_ready), .out_data_o(tile)
  );
  assign start_e = tile.e;
`endif

  logic group_valid, group_ready, coverage_busy;
  logic [(pineda_pkg::LANES<<pineda_pkg::TESTED_STAMPS_LOG2)-1:0] group;
  pineda_pkg::stamp_t found;
  coverage_finder u_coverage (
    .clk_i, .rst_ni,
    .tile_valid_i(tile_valid), .tile_ready_o(tile_ready), .tile_i(tile), .start_e_i(start_e),
    .group_valid_o(group_valid), .group_ready_i(group_ready), .group_o(group),
    .stamp_o(found),
    .busy_o(coverage_busy)
  );
  stamp_sender u_stamps (
    .clk_i, .rst_ni,
    .group_valid_i(group_valid), .group_ready_o(group_ready), .group_i(group),
    .stamp_i(found),
    .stamp_valid_o, .stamp_ready_i, .stamp_o,
    .idle_o(stamps_idle)
  );

  assign idle_o = !tiles_busy && !tile_valid && !coverage_busy && stamps_idle;

`ifdef PINEDA_COUNTERS
  cycle_counters #(.Kinds(pineda_pkg::TILE_FIFO_DEPTH + 1)) u_levels (
    .clk_i, .count_i(1'b1), .kind_i(u_fifo.count_q)
  );
`endif
endmodule
