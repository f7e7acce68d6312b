module memory (
  input  logic clk_i,
  input  logic x_i,
  output logic x_o
);
  pineda_pkg::pair_t pairs_mem [4];
  always_ff @(posedge clk_i) pairs_mem[0].x <= x_i;
  assign x_o = pairs_mem[0].x;
endmodule
