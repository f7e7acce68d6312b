// For the prover of pineda vectors score: a product becomes free, and its factors can be seen. Two units
// that always have the same factors have the same products, whatever these are.
(* techmap_celltype = "$mul" *)
module cut_multiplier (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire [A_WIDTH-1:0] factor_a = A;
  wire [B_WIDTH-1:0] factor_b = B;
  (* anyseq *) wire [Y_WIDTH-1:0] product;
  assign Y = product;
endmodule
