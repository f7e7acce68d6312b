// The rasterizer: setup -> traversal -> interpolation and depth test, one frame after the other.
//
// Bits     core::Renderer defines every write.
// In       frame_i opens a frame (raster state, sampled), then its triangles, then end_valid_i
//          closes it: taken once every write is accepted. Triangles and the end never at once.
// Out      clear_valid_o asks the memories to clear depth to clear_depth_o and colour to zero;
//          nothing is read before it is taken. Then depth reads, depth writes, colour writes, in
//          order.
// Rate     see the units. The frame's start costs 2 cycles, one to be taken and one to clear.
// Drops    see setup_unit.
// Errors   none. A reset in the middle of a frame leaves an idle, empty pipeline.
// Twin     model/timing/raster_top.h.
module raster_top (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  // Frame protocol
  input  logic                      frame_valid_i,
  output logic                      frame_ready_o,
  input  pineda_pkg::frame_t        frame_i,
  input  logic                      end_valid_i,
  output logic                      end_ready_o,
  output logic                      clear_valid_o,
  input  logic                      clear_ready_i,
`ifdef PINEDA_DEPTH
  output logic [pineda_pkg::DEPTH_BITS-1:0] clear_depth_o,
`endif
  output logic                      idle_o,

  // Snapped triangles
  input  logic                      tri_valid_i,
  output logic                      tri_ready_o,
  input  pineda_pkg::triangle_t     tri_i,

  // Depth and colour memories, addressed by stamp
`ifdef PINEDA_DEPTH
  output logic                      depth_rd_valid_o,
  input  logic                      depth_rd_ready_i,
  output pineda_pkg::depth_read_t   depth_rd_o,
  input  logic                      depth_rsp_valid_i,
  output logic                      depth_rsp_ready_o,
  input  pineda_pkg::depth_data_t   depth_rsp_i,
  output logic                      depth_wr_valid_o,
  input  logic                      depth_wr_ready_i,
  output pineda_pkg::depth_write_t  depth_wr_o,
`endif
  output logic                      color_wr_valid_o,
  input  logic                      color_wr_ready_i,
  output pineda_pkg::color_write_t  color_wr_o
);
  localparam logic [1:0] IDLE  = 2'd0;
  localparam logic [1:0] CLEAR = 2'd1;
  localparam logic [1:0] RUN   = 2'd2;

  logic [1:0] state_q;
  pineda_pkg::frame_t frame_q;
  logic drained, setup_ready;
  logic prim_valid, prim_ready, queued_prim_valid, queued_prim_ready;
  pineda_pkg::setup_prim_t prim, queued_prim;
  logic stamp_valid, stamp_ready;
  pineda_pkg::stamp_t stamp;
  logic setup_idle, traversal_idle, interp_ztest_idle;

  assign frame_ready_o = state_q == IDLE;
  assign clear_valid_o = state_q == CLEAR;
`ifdef PINEDA_DEPTH
  assign clear_depth_o = frame_q.clear_depth;
`endif
  assign tri_ready_o = state_q == RUN && setup_ready;
  assign drained = setup_idle && !queued_prim_valid && traversal_idle && interp_ztest_idle;
  assign end_ready_o = state_q == RUN && drained;
  assign idle_o = state_q == IDLE;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= IDLE;
    end else begin
      case (state_q)
        IDLE:    if (frame_valid_i) state_q <= CLEAR;
        CLEAR:   if (clear_ready_i) state_q <= RUN;
        default: if (end_valid_i && end_ready_o) state_q <= IDLE;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (frame_valid_i && frame_ready_o) frame_q <= frame_i;
  end

  setup_unit u_setup (
    .clk_i, .rst_ni,
    .frame_i(frame_q),
    .tri_valid_i(tri_valid_i && state_q == RUN), .tri_ready_o(setup_ready), .tri_i,
    .prim_valid_o(prim_valid), .prim_ready_i(prim_ready), .prim_o(prim),
    .idle_o(setup_idle)
  );

  stream_fifo #(
    .Width(pineda_pkg::SETUP_PRIM_BITS), .Depth(pineda_pkg::PRIM_FIFO_DEPTH)
  ) u_prims (
    .clk_i, .rst_ni,
    .in_valid_i(prim_valid), .in_ready_o(prim_ready), .in_data_i(prim),
    .out_valid_o(queued_prim_valid), .out_ready_i(queued_prim_ready), .out_data_o(queued_prim)
  );

`ifdef PINEDA_HIERARCHICAL_Z
  // Where depths only become less, what lies behind all of them is hidden.
  logic hides, depth_max_valid;
  logic [pineda_pkg::TILE_INDEX_BITS-1:0] tile_x, tile_y;
  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0] z_max;
  pineda_pkg::depth_max_t depth_max;
  assign hides = frame_q.depth == pineda_pkg::DEPTH_LESS ||
                 frame_q.depth == pineda_pkg::DEPTH_LEQUAL;
  hierarchical_z u_hierarchical_z (
    .clk_i, .rst_ni,
    .clear_i(clear_valid_o),
    .clear_depth_i(frame_q.clear_depth[
        pineda_pkg::DEPTH_BITS-1:pineda_pkg::DEPTH_BITS-pineda_pkg::HIERARCHICAL_Z_BITS]),
    .frame_width_i(frame_q.width), .frame_height_i(frame_q.height),
    .tile_x_i(tile_x), .tile_y_i(tile_y), .z_max_o(z_max),
    .update_valid_i(depth_max_valid), .update_i(depth_max)
  );
`endif

  traversal_unit u_traversal (
    .clk_i, .rst_ni,
`ifdef PINEDA_HIERARCHICAL_Z
    .hides_i(hides), .z_max_i(z_max), .tile_x_o(tile_x), .tile_y_o(tile_y),
`endif
    .prim_valid_i(queued_prim_valid), .prim_ready_o(queued_prim_ready), .prim_i(queued_prim),
    .stamp_valid_o(stamp_valid), .stamp_ready_i(stamp_ready), .stamp_o(stamp),
    .idle_o(traversal_idle)
  );

  interp_ztest_unit u_interp_ztest (
    .clk_i, .rst_ni,
    .stamp_valid_i(stamp_valid), .stamp_ready_o(stamp_ready), .stamp_i(stamp),
`ifdef PINEDA_DEPTH
    .depth_func_i(frame_q.depth), .depth_write_i(frame_q.depth_write),
`ifdef PINEDA_HIERARCHICAL_Z
    .frame_width_i(frame_q.width), .frame_height_i(frame_q.height),
    .depth_max_valid_o(depth_max_valid), .depth_max_o(depth_max),
`endif
    .depth_rd_valid_o, .depth_rd_ready_i, .depth_rd_o, .depth_rsp_valid_i, .depth_rsp_ready_o,
    .depth_rsp_i,
    .depth_wr_valid_o, .depth_wr_ready_i, .depth_wr_o,
`endif
    .color_wr_valid_o, .color_wr_ready_i, .color_wr_o,
    .idle_o(interp_ztest_idle)
  );

`ifdef PINEDA_COUNTERS
  // The cycles that begin at each level of the FIFO
  cycle_counters #(.Kinds(pineda_pkg::PRIM_FIFO_DEPTH + 1)) u_prim_levels (
    .clk_i, .count_i(1'b1), .kind_i(u_prims.count_q)
  );
`endif

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!tri_valid_i || !end_valid_i) else $error("a triangle at the end of the frame");
    end
    if (rst_ni && frame_valid_i) begin
      assert (frame_i.width != '0 && frame_i.height != '0) else $error("a frame without samples");
      assert (frame_i.cull <= pineda_pkg::CULL_FRONT) else $error("unknown cull state");
`ifdef PINEDA_DEPTH
      assert (frame_i.depth <= pineda_pkg::DEPTH_ALWAYS) else $error("unknown depth function");
`endif
    end
  end
`endif
endmodule
