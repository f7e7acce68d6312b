// One Newton step of the reciprocal, in two pipelined cycles: x <- 2x(1 - mx).
//
// Bits     the loop of newton() in model/core/reciprocal.cpp.
// In       m_i in [1/2, 1) and x_i, about 1/(2m) to LUT_BITS bits or better, UQ0.(k+2).
// Out      x_o and the same m, 2 enabled cycles later.
// Rate     one step an enabled cycle; registers move with the valid ones.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_NEWTON
module reciprocal_newton_step (
  input  logic                                    clk_i,
  input  logic                                    enable_i,

  input  logic [1:0]                              valid_i, // before each of the two stages
  input  logic [pineda_pkg::RECIPROCAL_BITS+1:0]  m_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS+1:0]  x_i,

  output logic [pineda_pkg::RECIPROCAL_BITS+1:0]  m_o,
  output logic [pineda_pkg::RECIPROCAL_BITS+1:0]  x_o
);
  localparam int unsigned W = pineda_pkg::RECIPROCAL_BITS + 2;
  // |1 - 2mx| < 2^-LUT_BITS after the ROM, and smaller after each step.
  localparam int unsigned ERROR_BITS = W - pineda_pkg::RECIPROCAL_LUT_BITS + 1;

  // 1 - 2mx, from the product truncated to W fraction bits.
  logic signed [2*W+1:0] mx;
  logic [W:0] one_minus;
  multiplier #(.ABits(W + 1), .BBits(W + 1)) u_mx (
    .a_i({1'b0, m_i}), .b_i({1'b0, x_i}), .addend_i('0), .product_o(mx)
  );
  assign one_minus = {1'b1, {W{1'b0}}} - mx[2*W-1:W-1];

  logic [W-1:0] m1_q, m2_q, x1_q, x2_q;
  logic signed [ERROR_BITS-1:0] error_q;

  // 2x(1 - mx) = x + x(1 - 2mx), truncated.
  logic signed [W+ERROR_BITS:0] correction;
  multiplier #(.ABits(W + 1), .BBits(ERROR_BITS)) u_correction (
    .a_i({1'b0, x1_q}), .b_i(error_q), .addend_i('0), .product_o(correction)
  );

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) begin
        m1_q <= m_i;
        x1_q <= x_i;
        error_q <= one_minus[ERROR_BITS-1:0];
      end
      if (valid_i[1]) begin
        m2_q <= m1_q;
        x2_q <= x1_q + W'(correction >>> W);
      end
    end
  end

  assign m_o = m2_q;
  assign x_o = x2_q;
endmodule
`endif
