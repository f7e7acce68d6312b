// Interpolation and depth test: one stamp in, its depth and colour writes out, in order.
//
// Bits     core::interpolate() and core::depth_test() define every output bit.
// In       stamp_i; depth_func_i: stable while any stamp of the frame is inside.
// Out      depth_wr_o, color_wr_o: the covered samples that pass; nothing if none does. With the
//          test off, colour only.
// Rate     a stamp a cycle at any read latency up to INFLIGHT_STAMPS - 4 cycles, as long as no
//          hazard and no port stalls it: a stamp whose address is in flight waits. In flight = from
//          the read accepted to the depth write accepted, or to the cycle in which that write would
//          have been offered: time does not depend on depth. A read of the address may be accepted
//          in the cycle after.
// Drops    samples that fail the test.
// Errors   none.
// Twin     model/core/interp.cpp.
module interp_ztest_unit (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic [1:0]                depth_func_i,

  // Stamps, from traversal_unit
  input  logic                      stamp_valid_i,
  output logic                      stamp_ready_o,
  input  pineda_pkg::stamp_t        stamp_i,

  // Depth memory, read: responses come in the order of the requests and are always taken
  output logic                      depth_rd_valid_o,
  input  logic                      depth_rd_ready_i,
  output pineda_pkg::depth_read_t   depth_rd_o,
  input  logic                      depth_rsp_valid_i,
  input  pineda_pkg::depth_data_t   depth_rsp_i,

  // Depth and colour memory, write; stable while valid && !ready
  output logic                      depth_wr_valid_o,
  input  logic                      depth_wr_ready_i,
  output pineda_pkg::depth_write_t  depth_wr_o,
  output logic                      color_wr_valid_o,
  input  logic                      color_wr_ready_i,
  output pineda_pkg::color_write_t  color_wr_o,

  output logic                      idle_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_BITS;
  localparam int unsigned ATTRS_BITS = pineda_pkg::ATTRIBUTES * pineda_pkg::ATTR_BITS;
  localparam int unsigned INFLIGHT = pineda_pkg::INFLIGHT_STAMPS;
  localparam int unsigned ADDRESS_BITS = pineda_pkg::STAMP_X_BITS + pineda_pkg::STAMP_Y_BITS;
  localparam int unsigned FRAGMENT_BITS =
      pineda_pkg::DEPTH_READ_BITS + LANES * (Z_BITS + ATTRS_BITS);

  logic test;
  assign test = depth_func_i != pineda_pkg::DEPTH_OFF;

  // ---- Issue: a stamp enters when nobody ahead of it can still write what it reads
  logic hazard, table_full, table_empty, accept, retire;
  assign depth_rd_valid_o = stamp_valid_i && test && !hazard && !table_full;
  assign stamp_ready_o = !hazard && !table_full && (!test || depth_rd_ready_i);
  assign accept = stamp_valid_i && stamp_ready_o;
  assign depth_rd_o.id = stamp_i.id;
  assign depth_rd_o.x = stamp_i.x;
  assign depth_rd_o.y = stamp_i.y;
  assign depth_rd_o.mask = stamp_i.mask;

  inflight_table #(.Width(ADDRESS_BITS), .Depth(INFLIGHT)) u_inflight (
    .clk_i, .rst_ni,
    .lookup_i(stamp_valid_i && test),
    .address_i({stamp_i.y, stamp_i.x}),
    .hit_o(hazard),
    .full_o(table_full),
    .empty_o(table_empty),
    .insert_i(accept),
    .remove_i(retire)
  );

  // ---- Interpolation while the read is under way. The table counts every stamp from here to its
  // write, and both FIFOs are as deep as the table, so neither can be full.
  logic fragment_valid, head_valid, rsp_valid, load;
  pineda_pkg::depth_read_t address, head;
  logic [LANES*Z_BITS-1:0] z, head_z;
  logic [LANES*ATTRS_BITS-1:0] attr, head_attr;
  pineda_pkg::depth_data_t stored;
  interpolator u_interpolator (
    .clk_i, .rst_ni,
    .stamp_valid_i(accept), .stamp_i,
    .fragment_valid_o(fragment_valid), .address_o(address), .z_o(z), .attr_o(attr)
  );

  logic fragments_ready, responses_ready;
  stream_fifo #(.Width(FRAGMENT_BITS), .Depth(INFLIGHT)) u_fragments (
    .clk_i, .rst_ni,
    .in_valid_i(fragment_valid), .in_ready_o(fragments_ready), .in_data_i({address, z, attr}),
    .out_valid_o(head_valid), .out_ready_i(load), .out_data_o({head, head_z, head_attr})
  );
  stream_fifo #(.Width(pineda_pkg::DEPTH_DATA_BITS), .Depth(INFLIGHT)) u_responses (
    .clk_i, .rst_ni,
    .in_valid_i(depth_rsp_valid_i), .in_ready_o(responses_ready), .in_data_i(depth_rsp_i),
    .out_valid_o(rsp_valid), .out_ready_i(load && test), .out_data_o(stored)
  );

  // ---- Depth test
  function automatic logic passes(input logic [Z_BITS-1:0] new_z, input logic [Z_BITS-1:0] old_z,
                                  input logic [1:0] func);
    passes = func == pineda_pkg::DEPTH_OFF || new_z < old_z ||
             (func == pineda_pkg::DEPTH_LEQUAL && new_z == old_z);
  endfunction
  logic [LANES-1:0] passed;
  always_comb begin
    passed = 'x;
    if (head_valid) begin
      for (int unsigned i = 0; i < LANES; i++) begin
        passed[i] = head.mask[i] && passes(head_z[i*Z_BITS +: Z_BITS],
                                           stored.z[i*Z_BITS +: Z_BITS], depth_func_i);
      end
    end
  end

  // ---- Write: depth and colour leave side by side, each when its port takes it
  logic depth_pending_q, color_pending_q, write_free;
  pineda_pkg::color_write_t write_q; // address, mask and attributes
  logic [LANES*Z_BITS-1:0] write_z_q;
  assign depth_wr_valid_o = depth_pending_q && test && write_q.mask != '0;
  assign color_wr_valid_o = color_pending_q;
  assign retire = depth_pending_q && (!depth_wr_valid_o || depth_wr_ready_i);
  assign write_free = (!depth_pending_q || retire) && (!color_pending_q || color_wr_ready_i);
  assign load = head_valid && (rsp_valid || !test) && write_free;
  assign depth_wr_o.id = write_q.id;
  assign depth_wr_o.x = write_q.x;
  assign depth_wr_o.y = write_q.y;
  assign depth_wr_o.mask = write_q.mask;
  assign depth_wr_o.z = write_z_q;
  assign color_wr_o = write_q;
  assign idle_o = table_empty && !color_pending_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      depth_pending_q <= 1'b0;
      color_pending_q <= 1'b0;
    end else if (load) begin
      depth_pending_q <= 1'b1;
      color_pending_q <= passed != '0;
    end else begin
      if (retire) depth_pending_q <= 1'b0;
      if (color_wr_ready_i) color_pending_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      write_q.id <= head.id;
      write_q.x <= head.x;
      write_q.y <= head.y;
      write_q.mask <= passed;
      for (int unsigned i = 0; i < LANES; i++) begin
        write_q.attr[i*ATTRS_BITS +: ATTRS_BITS] <=
            passed[i] ? head_attr[i*ATTRS_BITS +: ATTRS_BITS] : '0;
        write_z_q[i*Z_BITS +: Z_BITS] <= passed[i] ? head_z[i*Z_BITS +: Z_BITS] : '0;
      end
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!fragment_valid || fragments_ready) else $error("a fragment finds its FIFO full");
      assert (!depth_rsp_valid_i || responses_ready) else $error("a response nobody asked for");
      assert (!stamp_valid_i || stamp_i.mask != '0) else $error("an empty stamp");
    end
  end
`endif
endmodule
