// Reciprocal of the doubled area: a ROM, then Newton steps.
//
// Bits     core::reciprocal() defines them: 1/area2 = mantissa * 2^(1 - k - length).
// In       area2_i > 0, held from start_i until the result is used.
// Out      length_o from the cycle after start_i on; mantissa_o, UQ0.k in [1/2, 1), from
//          2 + 2*RECIPROCAL_NEWTON_STEPS cycles after it on; both until the next start_i.
// Rate     one result every 2 + 2*RECIPROCAL_NEWTON_STEPS enabled cycles.
// Twin     model/core/setup.cpp.
module reciprocal (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  input  logic                                      enable_i,

  input  logic                                      start_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]         area2_i,

  output logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]  length_o,
  output logic [pineda_pkg::RECIPROCAL_BITS-1:0]    mantissa_o
);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned W = K + 2; // two guard bits while iterating
  localparam int unsigned AREA_BITS = pineda_pkg::AREA2_BITS - 1;
  localparam int unsigned LUT_BITS = pineda_pkg::RECIPROCAL_LUT_BITS;
  localparam int unsigned ROM_BITS = pineda_pkg::RECIPROCAL_ROM_BITS;
  localparam int unsigned LENGTH_BITS = pineda_pkg::AREA2_LENGTH_BITS;
  localparam int unsigned STEPS = 1 + 2 * pineda_pkg::RECIPROCAL_NEWTON_STEPS;
  localparam int unsigned STEP_BITS = $clog2(STEPS + 1);
  // |1 - 2mx| < 2^-LUT_BITS after the ROM, and smaller after each step.
  localparam int unsigned ERROR_BITS = W - LUT_BITS + 1;

  logic [LENGTH_BITS-1:0] length;
  logic [AREA_BITS-1:0] aligned;
  logic [LENGTH_BITS-1:0] length_q;
  logic [W-1:0] m_q;
  logic [W-1:0] x_q;
  logic signed [ERROR_BITS-1:0] error_q;
  logic [STEP_BITS-1:0] step_q;

  // 'x while nothing starts costs no gate and saves the simulator the work.
  always_comb begin
    length = 'x;
    if (start_i) begin
      length = '0;
      for (int unsigned i = 0; i < AREA_BITS; i++) begin
        if (area2_i[i]) length = LENGTH_BITS'(i + 1);
      end
    end
  end
  // The leading one at the top; what falls below W bits is cut off.
  assign aligned = area2_i << (LENGTH_BITS'(AREA_BITS) - length);

  // 1 - 2mx, from the product truncated to W fraction bits.
  logic [2*W-1:0] mx;
  logic [W:0] mx2;
  logic [W:0] one_minus;
  assign mx = (2*W)'(m_q) * (2*W)'(x_q);
  assign mx2 = mx[2*W-1:W-1];
  assign one_minus = {1'b1, {W{1'b0}}} - mx2;

  // 2x(1 - mx) = x + x(1 - 2mx), truncated.
  logic signed [W+ERROR_BITS:0] correction;
  logic [W-1:0] refined;
  assign correction = (W+ERROR_BITS+1)'(signed'({1'b0, x_q})) * (W+ERROR_BITS+1)'(error_q);
  assign refined = x_q + W'(correction >>> W);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
    end else if (enable_i) begin
      if (start_i) step_q <= STEP_BITS'(STEPS);
      else if (step_q != '0) step_q <= step_q - STEP_BITS'(1);
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (start_i) begin
        length_q <= length;
        m_q <= aligned[AREA_BITS-1 -: W];
      end
      if (step_q == STEP_BITS'(STEPS)) begin
        x_q <= {1'b1, pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS]), {(W-1-ROM_BITS){1'b0}}};
      end else if (step_q != '0) begin
        if (step_q[0]) x_q <= refined;
        else error_q <= one_minus[ERROR_BITS-1:0];
      end
    end
  end

  logic [K:0] rounded;
  assign rounded = {1'b0, x_q[W-1:2]} + (K+1)'(x_q[1]);
  assign length_o = length_q;
  assign mantissa_o = rounded[K] ? '1 : rounded[K-1:0];
endmodule
