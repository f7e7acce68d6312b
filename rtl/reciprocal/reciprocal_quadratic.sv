// Scheme quadratic of the reciprocal: a ROM of parabolas, evaluated by squarer and two multipliers.
//
// Bits     quadratic() in model/core/reciprocal.cpp.
// In       aligned_i: the number with its leading one at the top, in the cycle of start_i.
// Out      x_o: 1/(2m) in UQ0.(k+1), truncated, from 2 + 2*Stages cycles after start_i on.
// Rate     a pipeline: one result an enabled cycle; x_o stays until the next one.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_QUADRATIC
module reciprocal_quadratic #(
  parameter int unsigned Width = pineda_pkg::AREA2_BITS - 1,
  parameter int unsigned Stages = 1 // of a product
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  enable_i,

  input  logic                                  start_i,
  input  logic [Width-1:0]                      aligned_i,

  output logic [pineda_pkg::RECIPROCAL_BITS:0]  x_o
);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned W = K + 2; // two guard bits while computing
  localparam int unsigned LUT_BITS = pineda_pkg::RECIPROCAL_LUT_BITS;
  localparam int unsigned C0_BITS = pineda_pkg::RECIPROCAL_C0_BITS; // the leading 1 is implied
  localparam int unsigned C1_BITS = pineda_pkg::RECIPROCAL_C1_BITS;
  localparam int unsigned C2_BITS = pineda_pkg::RECIPROCAL_C2_BITS;
  localparam int unsigned T_BITS = W - 1 - LUT_BITS;

  // m in [1/2, 1), its leading one left out: what falls below W bits is cut off.
  logic [W-2:0] m;
  if (Width >= W) begin : g_cut
    assign m = aligned_i[Width-2 -: W-1];
  end else begin : g_whole
    assign m = {aligned_i[Width-2:0], {(W-Width){1'b0}}};
  end

  // Stages: m; coefficients and square; products; sum. Bit i: stage i is taken.
  localparam int unsigned SQUARE = 1;
  localparam int unsigned PRODUCTS = SQUARE + Stages;
  localparam int unsigned SUM = PRODUCTS + Stages;
  logic [SUM:0] valid;
  logic [SUM:1] valid_q;
  assign valid = {valid_q, start_i};
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (enable_i) valid_q <= valid[SUM-1:0];
  end

  // m = 1 index t, from the top.
  logic [W-2:0] m_q;
  logic [T_BITS-1:0] t1, t2;
  logic [C0_BITS-1:0] c0, base;
  logic [C1_BITS-1:0] c1;
  logic [C2_BITS-1:0] c2;
  assign t1 = m_q[T_BITS-1:0];
  delay_line #(.Width(T_BITS + C0_BITS + C1_BITS + C2_BITS), .Depth(Stages)) u_products (
    .clk_i, .enable_i,
    .data_i({t1, pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS])}), .data_o({t2, c0, c1, c2})
  );
  delay_line #(.Width(C0_BITS), .Depth(Stages)) u_base (
    .clk_i, .enable_i, .data_i(c0), .data_o(base)
  );

  logic [2*T_BITS-1:0] square;
  logic [C1_BITS+T_BITS-1:0] linear;
  logic [C2_BITS+T_BITS-1:0] curve;
  multiplier_pipelined #(
    .ABits(T_BITS + 1), .BBits(T_BITS + 1), .ProductBits(2*T_BITS), .Stages(Stages)
  ) u_square (
    .clk_i, .enable_i, .valid_i(valid[SQUARE +: Stages]),
    .a_i(signed'({1'b0, t1})), .b_i(signed'({1'b0, t1})), .addend_i('0), .product_o(square)
  );
  multiplier_pipelined #(
    .ABits(T_BITS + 1), .BBits(C1_BITS + 1), .ProductBits(C1_BITS + T_BITS), .Stages(Stages)
  ) u_linear (
    .clk_i, .enable_i, .valid_i(valid[PRODUCTS +: Stages]),
    .a_i(signed'({1'b0, t2})), .b_i(signed'({1'b0, c1})), .addend_i('0), .product_o(linear)
  );
  multiplier_pipelined #(
    .ABits(T_BITS + 1), .BBits(C2_BITS + 1), .ProductBits(C2_BITS + T_BITS), .Stages(Stages)
  ) u_curve (
    .clk_i, .enable_i, .valid_i(valid[PRODUCTS +: Stages]),
    .a_i(signed'({1'b0, square[2*T_BITS-1:T_BITS]})), .b_i(signed'({1'b0, c2})), .addend_i('0),
    .product_o(curve)
  );

  logic [W-1:0] sum;
  assign sum = {1'b1, base} - W'(linear[C1_BITS+T_BITS-1:T_BITS]) +
               W'(curve[C2_BITS+T_BITS-1:T_BITS]);

  logic [K:0] x_q;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (start_i) m_q <= m;
      if (valid[SUM]) x_q <= sum[W-1:1];
    end
  end

  assign x_o = x_q;
endmodule
`endif
