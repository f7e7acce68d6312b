// The setup unit on all legal inputs, and what can be seen of it. For the prover of pineda vectors score.
//
// In       reset in the first cycle. frame_i: one state from then on. offer_i, tri_i: a triangle that is
//          offered stays until it is taken. ready_i: at any time.
// Out      seen_o: the handshakes, and the payload of an output that is valid.
module setup_legal (
  input  logic                     clk_i,
  input  pineda_pkg::frame_t       frame_i,
  input  logic                     offer_i,
  input  pineda_pkg::triangle_t    tri_i,
  input  logic                     ready_i,
  output logic [pineda_pkg::SETUP_PRIM_BITS+2:0] seen_o
);
  logic rst_n_q, waits_q, valid, tri_ready, prim_valid, idle;
  logic [15:0] mutant_q;
  pineda_pkg::frame_t frame_q;
  pineda_pkg::triangle_t triangle, triangle_q;
  pineda_pkg::setup_prim_t prim;
  always_comb begin
    valid = waits_q || offer_i;
    triangle = waits_q ? triangle_q : tri_i;
  end
  always_ff @(posedge clk_i) begin
    rst_n_q <= 1'b1;
    mutant_q <= mutant_q;
    if (!rst_n_q) frame_q <= frame_i;
    waits_q <= rst_n_q && valid && !tri_ready;
    triangle_q <= triangle;
  end
  setup_unit u_unit (
    .clk_i(clk_i), .rst_ni(rst_n_q), .mutant_i(mutant_q), .frame_i(frame_q),
    .tri_valid_i(valid), .tri_ready_o(tri_ready), .tri_i(triangle),
    .prim_valid_o(prim_valid), .prim_ready_i(ready_i), .prim_o(prim), .idle_o(idle)
  );
  assign seen_o = {pineda_pkg::SETUP_PRIM_BITS+3{rst_n_q}} &
                  {tri_ready, idle, prim_valid, {pineda_pkg::SETUP_PRIM_BITS{prim_valid}} & prim};
endmodule
