// Scheme newton of the reciprocal: a ROM, then Newton steps.
//
// Bits     newton() in model/core/reciprocal.cpp.
// In       aligned_i: the area with its leading one at the top, in the cycle of start_i.
// Out      x_o: 1/(2m) in UQ0.(k+1), truncated, from 2 + 2*RECIPROCAL_NEWTON_STEPS cycles after
//          start_i on.
// Rate     one result every 2 + 2*RECIPROCAL_NEWTON_STEPS enabled cycles.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_NEWTON
module reciprocal_newton (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  enable_i,

  input  logic                                  start_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]     aligned_i,

  output logic [pineda_pkg::RECIPROCAL_BITS:0]  x_o
);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned W = K + 2; // two guard bits while iterating
  localparam int unsigned AREA_BITS = pineda_pkg::AREA2_BITS - 1;
  localparam int unsigned LUT_BITS = pineda_pkg::RECIPROCAL_LUT_BITS;
  localparam int unsigned ROM_BITS = pineda_pkg::RECIPROCAL_ROM_BITS;
  localparam int unsigned STEPS = 1 + 2 * pineda_pkg::RECIPROCAL_NEWTON_STEPS;
  localparam int unsigned STEP_BITS = $clog2(STEPS + 1);

  // m in [1/2, 1): what falls below W bits is cut off.
  logic [W-1:0] m;
  if (AREA_BITS >= W) begin : g_cut
    assign m = aligned_i[AREA_BITS-1 -: W];
  end else begin : g_whole
    assign m = {aligned_i, {(W-AREA_BITS){1'b0}}};
  end

  logic [W-1:0] m_q;
  logic [W-1:0] x_q;
  logic [STEP_BITS-1:0] step_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
    end else if (enable_i) begin
      if (start_i) step_q <= STEP_BITS'(STEPS);
      else if (step_q != '0) step_q <= step_q - STEP_BITS'(1);
    end
  end

  logic [W-1:0] guess;
  assign guess = W'({1'b1, pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS])}) << (W - 1 - ROM_BITS);

  if (pineda_pkg::RECIPROCAL_NEWTON_STEPS == 0) begin : g_rom
    always_ff @(posedge clk_i) begin
      if (enable_i) begin
        if (start_i) m_q <= m;
        if (step_q != '0) x_q <= guess;
      end
    end
  end else begin : g_steps
    // |1 - 2mx| < 2^-LUT_BITS after the ROM, and smaller after each step. What is kept is one less in
    // the last of W fraction bits: the complement of 2mx, truncated to them.
    localparam int unsigned ERROR_BITS = W - LUT_BITS + 1;
    logic signed [ERROR_BITS-1:0] error_less_1_q;

    // One multiplier takes turns: x times m; then 2x(1 - mx) = x + x(1 - 2mx), truncated, with the
    // last bit of the error times x added as well.
    logic signed [W:0] factor;
    logic [2*W+1:0] addend;
    logic signed [2*W+1:0] product;
    assign factor = step_q[0] ? (W+1)'(error_less_1_q) : signed'({1'b0, m_q});
    assign addend = step_q[0] ? {2'b00, x_q, x_q} : '0;
    multiplier #(.ABits(W + 1), .BBits(W + 1)) u_product (
      .a_i(signed'({1'b0, x_q})), .b_i(factor), .addend_i(addend), .product_o(product)
    );

    always_ff @(posedge clk_i) begin
      if (enable_i) begin
        if (start_i) m_q <= m;
        if (step_q == STEP_BITS'(STEPS)) x_q <= guess;
        else if (step_q != '0) begin
          if (step_q[0]) x_q <= product[2*W-1:W];
          else error_less_1_q <= ~product[W-1 +: ERROR_BITS];
        end
      end
    end
  end

  assign x_o = x_q[W-1:1];
endmodule
`endif
