// The traversal unit on all legal inputs, and what can be seen of it. For the prover of pineda vectors score.
//
// In       reset in the first cycle. offer_i, prim_i: a setup_prim that is offered stays until it is
//          taken; its box has x0 <= x1 and y0 <= y1. ready_i: at any time.
// Out      seen_o: the handshakes, and the payload of an output that is valid.
module traversal_legal (
  input  logic                     clk_i,
  input  logic                     offer_i,
  input  pineda_pkg::setup_prim_t  prim_i,
  input  logic                     ready_i,
`ifdef PINEDA_HIERARCHICAL_Z
  input  logic                                        hides_i,
  input  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0]  z_max_i,
  output logic [2*pineda_pkg::TILE_INDEX_BITS-1:0]    tile_o,
`endif
  output logic [pineda_pkg::STAMP_BITS+2:0] seen_o
);
  logic rst_n_q, waits_q, valid, prim_ready, stamp_valid, idle;
  logic [15:0] mutant_q;
  pineda_pkg::setup_prim_t prim, prim_q;
  pineda_pkg::stamp_t stamp;
  always_comb begin
    valid = waits_q || (offer_i && prim_i.x0 <= prim_i.x1 && prim_i.y0 <= prim_i.y1);
    prim = waits_q ? prim_q : prim_i;
  end
  always_ff @(posedge clk_i) begin
    rst_n_q <= 1'b1;
    mutant_q <= mutant_q;
    waits_q <= rst_n_q && valid && !prim_ready;
    prim_q <= prim;
  end
`ifdef PINEDA_HIERARCHICAL_Z
  logic hides_q;
  always_ff @(posedge clk_i) if (!rst_n_q) hides_q <= hides_i;
`endif
  traversal_unit u_unit (
    .clk_i(clk_i), .rst_ni(rst_n_q), .mutant_i(mutant_q),
    .prim_valid_i(valid), .prim_ready_o(prim_ready), .prim_i(prim),
`ifdef PINEDA_HIERARCHICAL_Z
    .hides_i(hides_q), .z_max_i(z_max_i), .tile_x_o(tile_o[pineda_pkg::TILE_INDEX_BITS-1:0]),
    .tile_y_o(tile_o[2*pineda_pkg::TILE_INDEX_BITS-1:pineda_pkg::TILE_INDEX_BITS]),
`endif
    .stamp_valid_o(stamp_valid), .stamp_ready_i(ready_i), .stamp_o(stamp), .idle_o(idle)
  );
  assign seen_o = {pineda_pkg::STAMP_BITS+3{rst_n_q}} &
                  {prim_ready, idle, stamp_valid, {pineda_pkg::STAMP_BITS{stamp_valid}} & stamp};
endmodule
