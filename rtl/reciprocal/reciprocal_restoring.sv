// Schemes restoring2 and restoring4 of the reciprocal: the quotient of the whole area by restoring
// division, RECIPROCAL_RADIX_BITS of it a cycle.
//
// Bits     quotient() in model/core/reciprocal.cpp. Where the area is a power of two the quotient is
//          one unit short of 1, which rounds to the same.
// In       aligned_i: the area with its leading one at the top, in the cycle of start_i.
// Out      x_o: 1/(2m) in UQ0.(k+1), truncated, from 2 + STEPS cycles after start_i on.
// Rate     one result every 2 + STEPS enabled cycles.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_RESTORING
module reciprocal_restoring (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  enable_i,

  input  logic                                  start_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]     aligned_i,

  output logic [pineda_pkg::RECIPROCAL_BITS:0]  x_o
);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned AREA_BITS = pineda_pkg::AREA2_BITS - 1;
  localparam int unsigned RADIX_BITS = pineda_pkg::RECIPROCAL_RADIX_BITS;
  localparam int unsigned STEPS = (K + RADIX_BITS - 1) / RADIX_BITS;
  localparam int unsigned STEP_BITS = $clog2(STEPS + 2);
  localparam int unsigned QUOTIENT_BITS = STEPS * RADIX_BITS; // after the first, which is 1
  localparam int unsigned SHIFTED_BITS = AREA_BITS + RADIX_BITS;

  logic [STEP_BITS-1:0] step_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
    end else if (enable_i) begin
      if (start_i) step_q <= STEP_BITS'(STEPS + 1);
      else if (step_q != '0) step_q <= step_q - STEP_BITS'(1);
    end
  end

  // remainder <= divisor throughout, equal only where the divisor is a power of two.
  logic [AREA_BITS-1:0] divisor_q, remainder_q;
  logic [QUOTIENT_BITS-1:0] quotient_q;
  logic [SHIFTED_BITS-1:0] shifted;
  logic [RADIX_BITS-1:0] digit;
  logic [SHIFTED_BITS-1:0] multiple; // digit * divisor
  assign shifted = {remainder_q, {RADIX_BITS{1'b0}}};

  if (RADIX_BITS == 1) begin : g_radix2
    assign digit = shifted >= SHIFTED_BITS'(divisor_q);
    assign multiple = digit == '0 ? '0 : SHIFTED_BITS'(divisor_q);
  end else begin : g_radix4
    logic [SHIFTED_BITS-1:0] one, two, three_q;
    assign one = SHIFTED_BITS'(divisor_q);
    assign two = one << 1;
    always_ff @(posedge clk_i) begin
      if (enable_i && step_q == STEP_BITS'(STEPS + 1)) three_q <= one + two;
    end
    always_comb begin
      if (shifted >= three_q)  begin digit = 2'd3; multiple = three_q; end
      else if (shifted >= two) begin digit = 2'd2; multiple = two; end
      else if (shifted >= one) begin digit = 2'd1; multiple = one; end
      else                     begin digit = 2'd0; multiple = '0; end
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (start_i) divisor_q <= aligned_i;
      // The first bit of the quotient: 2^AREA_BITS less the divisor.
      if (step_q == STEP_BITS'(STEPS + 1)) remainder_q <= -divisor_q;
      else if (step_q != '0) begin
        remainder_q <= AREA_BITS'(shifted - multiple);
        quotient_q <= {quotient_q[QUOTIENT_BITS-RADIX_BITS-1:0], digit};
      end
    end
  end

  assign x_o = {1'b1, quotient_q[QUOTIENT_BITS-1 -: K]};
endmodule
`endif
