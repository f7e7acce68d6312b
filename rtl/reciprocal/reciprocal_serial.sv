// Reciprocal of the doubled area by a multiplier that others share. Restoring division needs none.
//
// Bits     core::reciprocal() defines them: 1/area2 = mantissa * 2^(1 - k - length).
// In       area2_i > 0, held in the cycle of start_i. turn_i: this cycle's product is the module's,
//          in a row from 4 cycles after start_i on: for newton 2 of every 3 steps' cycles, for
//          quadratic 3; and one more, in which the last product is taken up. product_i: the factors'
//          product, a cycle after them.
// Out      length_o from the cycle after start_i on; mantissa_o from the cycle after the last turn
//          on, for restoring spec::reciprocal_cycles() after start_i; both until the next start_i.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_SETUP_SERIAL
`ifdef PINEDA_PLANES
module reciprocal_serial (
  input  logic                                               clk_i,
  input  logic                                               rst_ni,
  input  logic                                               enable_i,

  input  logic                                               start_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]                  area2_i,

  input  logic                                               turn_i,
  output logic signed [pineda_pkg::SETUP_FACTOR_A_BITS-1:0]  factor_a_o,
  output logic signed [pineda_pkg::SETUP_FACTOR_B_BITS-1:0]  factor_b_o,
  input  logic signed [pineda_pkg::SETUP_FACTOR_A_BITS+pineda_pkg::SETUP_FACTOR_B_BITS-1:0]
                                                             product_i,

  output logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]           length_o,
  output logic [pineda_pkg::RECIPROCAL_BITS-1:0]             mantissa_o
);
`ifdef PINEDA_RECIPROCAL_RESTORING
  reciprocal u_reciprocal (
    .clk_i, .rst_ni, .enable_i, .start_i, .area2_i, .length_o, .mantissa_o
  );
  assign factor_a_o = 'x;
  assign factor_b_o = 'x;
`else
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned W = K + 2; // two guard bits while computing
  localparam int unsigned AREA_BITS = pineda_pkg::AREA2_BITS - 1;
  localparam int unsigned LENGTH_BITS = pineda_pkg::AREA2_LENGTH_BITS;
  localparam int unsigned LUT_BITS = pineda_pkg::RECIPROCAL_LUT_BITS;
  localparam int unsigned A_BITS = pineda_pkg::SETUP_FACTOR_A_BITS;
  localparam int unsigned B_BITS = pineda_pkg::SETUP_FACTOR_B_BITS;

  logic [LENGTH_BITS-1:0] length, length_q;
  logic [AREA_BITS-1:0] aligned;
  reciprocal_align #(.Width(AREA_BITS), .LengthBits(LENGTH_BITS)) u_align (
    .valid_i(start_i), .value_i(area2_i), .length_o(length), .aligned_o(aligned)
  );

  // m in [1/2, 1): what falls below W bits is cut off.
  logic [W-1:0] m, m_q, x_q;
  if (AREA_BITS >= W) begin : g_cut
    assign m = aligned[AREA_BITS-1 -: W];
  end else begin : g_whole
    assign m = {aligned, {(W-AREA_BITS){1'b0}}};
  end

  logic started_q; // the cycle after start_i
  logic [1:0] turn_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      turn_q <= '0;
    end else if (enable_i) begin
      started_q <= start_i;
      if (start_i) turn_q <= '0;
      else if (turn_i) turn_q <= turn_q == LAST_TURN ? '0 : turn_q + 2'd1;
    end
  end

  // The first guess, and what each turn takes up.
  logic [W-1:0] first, next;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (start_i) begin
        length_q <= length;
        m_q <= m;
      end
      if (started_q) x_q <= first;
      else if (turn_i) x_q <= next;
    end
  end

`ifdef PINEDA_RECIPROCAL_NEWTON
  localparam logic [1:0] LAST_TURN = 2'd2;
  localparam int unsigned ROM_BITS = pineda_pkg::RECIPROCAL_ROM_BITS;
  // |1 - 2mx| < 2^-LUT_BITS after the ROM, and smaller after each step.
  localparam int unsigned ERROR_BITS = W - LUT_BITS + 1;
  assign first = W'({1'b1, pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS])}) << (W - 1 - ROM_BITS);

  // Turn 0 asks for mx; turn 1 for x(1 - 2mx), mx truncated to W fraction bits; turn 2 adds it.
  logic [W:0] one_minus;
  assign one_minus = {1'b1, {W{1'b0}}} - product_i[2*W-1:W-1];
  assign factor_a_o = A_BITS'(signed'({1'b0, x_q}));
  assign factor_b_o = turn_q == 2'd0 ? B_BITS'(signed'({1'b0, m_q}))
                                     : B_BITS'(signed'(one_minus[ERROR_BITS-1:0]));
  assign next = turn_q == LAST_TURN ? x_q + W'(product_i >>> W) : x_q;
`else
  localparam logic [1:0] LAST_TURN = 2'd3;
  localparam int unsigned C0_BITS = pineda_pkg::RECIPROCAL_C0_BITS; // the leading 1 is implied
  localparam int unsigned C1_BITS = pineda_pkg::RECIPROCAL_C1_BITS;
  localparam int unsigned C2_BITS = pineda_pkg::RECIPROCAL_C2_BITS;
  localparam int unsigned T_BITS = W - 1 - LUT_BITS;
  logic [C0_BITS-1:0] c0;
  logic [C1_BITS-1:0] c1;
  logic [C2_BITS-1:0] c2;
  logic [T_BITS-1:0] t, shifted, square_q;
  assign {c0, c1, c2} = pineda_pkg::reciprocal_rom(m_q[W-2 -: LUT_BITS]);
  assign t = m_q[T_BITS-1:0];
  assign shifted = product_i[2*T_BITS-1:T_BITS];
  assign first = {1'b1, c0};

  // Turns 0 to 2 ask for t^2, c1*t, c2*t^2; the last two products go into the sum.
  always_comb begin
    factor_a_o = A_BITS'(signed'({1'b0, t}));
    factor_b_o = B_BITS'(signed'({1'b0, t}));
    if (turn_q == 2'd1) factor_b_o = B_BITS'(signed'({1'b0, c1}));
    if (turn_q == 2'd2) begin
      factor_a_o = A_BITS'(signed'({1'b0, square_q}));
      factor_b_o = B_BITS'(signed'({1'b0, c2}));
    end
    case (turn_q)
      2'd2:    next = x_q - W'(product_i[C1_BITS+T_BITS-1:T_BITS]);
      2'd3:    next = x_q + W'(product_i[C2_BITS+T_BITS-1:T_BITS]);
      default: next = x_q;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (enable_i && turn_i && turn_q == 2'd1) square_q <= shifted;
  end
`endif

  logic [K:0] rounded;
  assign rounded = {1'b0, x_q[W-1:2]} + (K+1)'(x_q[1]);
  assign length_o = length_q;
  assign mantissa_o = rounded[K] ? '1 : rounded[K-1:0];
`endif
endmodule
`endif
`endif
