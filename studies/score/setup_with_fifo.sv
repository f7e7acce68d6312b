// The setup unit and the FIFO behind it, which belongs to its producer.
module setup_with_fifo (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pineda_pkg::frame_t       frame_i,

  input  logic                     tri_valid_i,
  output logic                     tri_ready_o,
  input  pineda_pkg::triangle_t    tri_i,

  output logic                     prim_valid_o,
  input  logic                     prim_ready_i,
  output pineda_pkg::setup_prim_t  prim_o,

  output logic                     idle_o
);
  logic valid, ready, idle;
  pineda_pkg::setup_prim_t prim;
  setup_unit u_setup (
    .clk_i, .rst_ni, .frame_i, .tri_valid_i, .tri_ready_o, .tri_i,
    .prim_valid_o(valid), .prim_ready_i(ready), .prim_o(prim), .idle_o(idle)
  );
  stream_fifo #(
    .Width(pineda_pkg::SETUP_PRIM_BITS), .Depth(pineda_pkg::PRIM_FIFO_DEPTH)
  ) u_prims (
    .clk_i, .rst_ni,
    .in_valid_i(valid), .in_ready_o(ready), .in_data_i(prim),
    .out_valid_o(prim_valid_o), .out_ready_i(prim_ready_i), .out_data_o(prim_o)
  );
  assign idle_o = idle && !prim_valid_o;
endmodule
