// Scheme quadratic of the reciprocal: a ROM of parabolas, evaluated by squarer and two multipliers.
//
// Bits     quadratic() in model/core/reciprocal.cpp.
// In       aligned_i: the number with its leading one at the top, in the cycle of start_i.
// Out      x_o: 1/(2m) in UQ0.(k+1), truncated, from 4 cycles after start_i on.
// Rate     a pipeline: one result an enabled cycle; x_o stays until the next one.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_QUADRATIC
module reciprocal_quadratic #(
  parameter int unsigned Width = pineda_pkg::AREA2_BITS - 1
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

  // Stages: m, coefficients and square, products, sum
  logic [2:0] valid_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (enable_i) valid_q <= {valid_q[1:0], start_i};
  end

  // m = 1 index t, from the top.
  logic [W-2:0] m_q;
  logic [T_BITS-1:0] t;
  assign t = m_q[T_BITS-1:0];
  logic [2*T_BITS-1:0] square;
  assign square = (2*T_BITS)'(t) * (2*T_BITS)'(t);

  logic [C0_BITS-1:0] c0_q, base_q;
  logic [C1_BITS-1:0] c1_q;
  logic [C2_BITS-1:0] c2_q;
  logic [T_BITS-1:0] t_q, square_q;
  logic [C1_BITS+T_BITS-1:0] linear;
  logic [C2_BITS+T_BITS-1:0] curve;
  assign linear = (C1_BITS+T_BITS)'(c1_q) * (C1_BITS+T_BITS)'(t_q);
  assign curve = (C2_BITS+T_BITS)'(c2_q) * (C2_BITS+T_BITS)'(square_q);

  logic [C1_BITS-1:0] linear_q;
  logic [C2_BITS-1:0] curve_q;
  logic [W-1:0] sum;
  assign sum = {1'b1, base_q} - W'(linear_q) + W'(curve_q);

  logic [K:0] x_q;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (start_i) m_q <= m;
      if (valid_q[0]) begin
        {c0_q, c1_q, c2_q} <= pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS]);
        t_q <= t;
        square_q <= square[2*T_BITS-1:T_BITS];
      end
      if (valid_q[1]) begin
        base_q <= c0_q;
        linear_q <= linear[C1_BITS+T_BITS-1:T_BITS];
        curve_q <= curve[C2_BITS+T_BITS-1:T_BITS];
      end
      if (valid_q[2]) x_q <= sum[W-1:1];
    end
  end

  assign x_o = x_q;
endmodule
`endif
