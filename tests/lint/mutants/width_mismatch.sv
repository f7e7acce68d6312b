// Nine bits into eight.
module width_mismatch (
  input  logic [7:0] a_i,
  input  logic [7:0] b_i,
  output logic [7:0] q_o
);
  logic [8:0] sum;
  assign sum = {1'b0, a_i} + {1'b0, b_i};
  assign q_o = sum;
endmodule
