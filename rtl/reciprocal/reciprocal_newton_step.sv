// One Newton step of the reciprocal, two pipelined products: x <- 2x(1 - mx).
//
// Bits     the loop of newton() in model/core/reciprocal.cpp.
// In       m_i in [1/2, 1) and x_i, about 1/(2m) to LUT_BITS bits or better, UQ0.(k+2); valid_i: which
//          of its cycles are taken.
// Out      x_o and the same m, 2*Stages enabled cycles later.
// Rate     one step an enabled cycle.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_NEWTON
module reciprocal_newton_step #(
  parameter int unsigned Stages = 1 // of a product
) (
  input  logic                                    clk_i,
  input  logic                                    enable_i,

  input  logic [2*Stages-1:0]                     valid_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS+1:0]  m_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS+1:0]  x_i,

  output logic [pineda_pkg::RECIPROCAL_BITS+1:0]  m_o,
  output logic [pineda_pkg::RECIPROCAL_BITS+1:0]  x_o
);
  localparam int unsigned W = pineda_pkg::RECIPROCAL_BITS + 2;
  // |1 - 2mx| < 2^-LUT_BITS after the ROM, and smaller after each step.
  localparam int unsigned ERROR_BITS = W - pineda_pkg::RECIPROCAL_LUT_BITS + 1;

  logic [W-1:0] m1, x1;
  delay_line #(.Width(2*W), .Depth(Stages)) u_m1_x1 (
    .clk_i, .enable_i, .data_i({m_i, x_i}), .data_o({m1, x1})
  );
  delay_line #(.Width(W), .Depth(Stages)) u_m2 (
    .clk_i, .enable_i, .data_i(m1), .data_o(m_o)
  );

  // 1 - 2mx, from the product truncated to W fraction bits. The complement of 2mx is one less in the
  // last of them: x is added once more.
  logic signed [2*W-1:0] mx, product;
  multiplier_pipelined #(.ABits(W + 1), .BBits(W + 1), .ProductBits(2*W), .Stages(Stages)) u_mx (
    .clk_i, .enable_i, .valid_i(valid_i[Stages-1:0]),
    .a_i(signed'({1'b0, m_i})), .b_i(signed'({1'b0, x_i})), .addend_i('0), .product_o(mx)
  );
  logic signed [ERROR_BITS-1:0] error_less_1;
  assign error_less_1 = ~mx[W-1 +: ERROR_BITS];

  // 2x(1 - mx) = x + x(1 - 2mx), truncated.
  multiplier_pipelined #(
    .ABits(W + 1), .BBits(ERROR_BITS), .ProductBits(2*W), .Stages(Stages)
  ) u_correction (
    .clk_i, .enable_i, .valid_i(valid_i[Stages +: Stages]),
    .a_i(signed'({1'b0, x1})), .b_i(error_less_1), .addend_i({x1, x1}), .product_o(product)
  );
  assign x_o = product[2*W-1:W];
endmodule
`endif
