// Interpolation and depth test on all legal inputs, and what can be seen of them. For the prover of
// pineda vectors score.
//
// In       reset in the first cycle. depth_func_i, depth_write_i, frame size: one state from then on.
//          offer_i, stamp_i: a stamp that is offered stays until it is taken; its mask is not empty, the
//          first stamp of all is the first one of its tile. respond_i, data_i: what is read is answered
//          in order, with anything, at any time from the next cycle on, and an answer stays until it is
//          taken. rd_ready_i, depth_ready_i, color_ready_i: at any time.
// Out      *_seen_o: the handshakes, and the payload of an output that is valid.
module interp_ztest_legal (
  input  logic                       clk_i,
  input  logic                       offer_i,
  input  pineda_pkg::stamp_t         stamp_i,
`ifdef PINEDA_DEPTH
  input  logic [3:0]                 depth_func_i,
  input  logic                       depth_write_i,
`ifdef PINEDA_HIERARCHICAL_Z
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] frame_width_i,
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] frame_height_i,
  output logic [pineda_pkg::DEPTH_MAX_BITS:0]    max_seen_o,
`endif
  input  logic                       rd_ready_i,
  input  logic                       depth_ready_i,
  input  logic                       respond_i,
  input  pineda_pkg::depth_data_t    data_i,
  output logic [pineda_pkg::DEPTH_READ_BITS:0]   read_seen_o,
  output logic [pineda_pkg::DEPTH_WRITE_BITS:0]  depth_seen_o,
  output logic                       rsp_ready_o,
`endif
  input  logic                       color_ready_i,
  output logic [pineda_pkg::COLOR_WRITE_BITS:0]  color_seen_o,
  output logic                       ready_o,
  output logic                       idle_o
);
  logic rst_n_q, waits_q, begun_q, valid, stamp_ready, color_valid, idle;
  logic [15:0] mutant_q;
  pineda_pkg::stamp_t stamp, stamp_q;
  pineda_pkg::color_write_t color;
  always_comb begin
    valid = waits_q || (offer_i && stamp_i.mask != '0);
    stamp = waits_q ? stamp_q : stamp_i;
    if (!begun_q) stamp.first = 1'b1;
  end
  always_ff @(posedge clk_i) begin
    rst_n_q <= 1'b1;
    mutant_q <= mutant_q;
    waits_q <= rst_n_q && valid && !stamp_ready;
    stamp_q <= stamp;
    begun_q <= begun_q || (rst_n_q && valid && stamp_ready);
  end
`ifdef PINEDA_DEPTH
  localparam int unsigned COUNT_BITS = $clog2(pineda_pkg::INFLIGHT_STAMPS + 2);
  logic rd_valid, rsp_valid, rsp_ready, rsp_waits_q, depth_valid, write_q;
  logic [COUNT_BITS-1:0] asked_q; // reads without an answer
  logic [3:0] func_q;
  pineda_pkg::depth_data_t data, data_q;
  pineda_pkg::depth_read_t read;
  pineda_pkg::depth_write_t depth;
  always_comb begin
    rsp_valid = rsp_waits_q || (respond_i && asked_q != '0);
    data = rsp_waits_q ? data_q : data_i;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_n_q) begin
      func_q <= depth_func_i;
      write_q <= depth_write_i;
      asked_q <= '0;
    end else begin
      asked_q <= asked_q + COUNT_BITS'(rd_valid && rd_ready_i) - COUNT_BITS'(rsp_valid && rsp_ready);
    end
    rsp_waits_q <= rst_n_q && rsp_valid && !rsp_ready;
    data_q <= data;
  end
`ifdef PINEDA_HIERARCHICAL_Z
  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] width_q, height_q;
  logic max_valid;
  pineda_pkg::depth_max_t max;
  always_ff @(posedge clk_i) begin
    if (!rst_n_q) begin
      width_q <= frame_width_i;
      height_q <= frame_height_i;
    end
  end
  assign max_seen_o = {rst_n_q && max_valid, {pineda_pkg::DEPTH_MAX_BITS{rst_n_q && max_valid}} & max};
`endif
  assign read_seen_o = {rst_n_q && rd_valid, {pineda_pkg::DEPTH_READ_BITS{rst_n_q && rd_valid}} & read};
  assign depth_seen_o =
      {rst_n_q && depth_valid, {pineda_pkg::DEPTH_WRITE_BITS{rst_n_q && depth_valid}} & depth};
  assign rsp_ready_o = rst_n_q && rsp_valid && rsp_ready;
`endif
  interp_ztest_unit u_unit (
    .clk_i(clk_i), .rst_ni(rst_n_q), .mutant_i(mutant_q),
    .stamp_valid_i(valid), .stamp_ready_o(stamp_ready), .stamp_i(stamp),
`ifdef PINEDA_DEPTH
    .depth_func_i(func_q), .depth_write_i(write_q),
`ifdef PINEDA_HIERARCHICAL_Z
    .frame_width_i(width_q), .frame_height_i(height_q), .depth_max_valid_o(max_valid), .depth_max_o(max),
`endif
    .depth_rd_valid_o(rd_valid), .depth_rd_ready_i(rd_ready_i), .depth_rd_o(read),
    .depth_rsp_valid_i(rsp_valid), .depth_rsp_ready_o(rsp_ready), .depth_rsp_i(data),
    .depth_wr_valid_o(depth_valid), .depth_wr_ready_i(depth_ready_i), .depth_wr_o(depth),
`endif
    .color_wr_valid_o(color_valid), .color_wr_ready_i(color_ready_i), .color_wr_o(color),
    .idle_o(idle)
  );
  assign color_seen_o =
      {rst_n_q && color_valid, {pineda_pkg::COLOR_WRITE_BITS{rst_n_q && color_valid}} & color};
  assign ready_o = rst_n_q && stamp_ready;
  assign idle_o = rst_n_q && idle;
endmodule
