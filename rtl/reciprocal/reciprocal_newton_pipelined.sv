// Scheme newton of the reciprocal, a result a cycle: a ROM, then a pipeline of Newton steps.
//
// Bits     newton() in model/core/reciprocal.cpp.
// In       aligned_i: the value with its leading one at the top, with start_i.
// Out      x_o: 1/(2m) in UQ0.(k+1), truncated, 2 + 2*RECIPROCAL_NEWTON_STEPS*Stages cycles after
//          start_i.
// Rate     one result an enabled cycle; x_o stays until the next one.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_NEWTON
module reciprocal_newton_pipelined #(
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
  localparam int unsigned W = pineda_pkg::RECIPROCAL_BITS + 2; // two guard bits while iterating
  localparam int unsigned LUT_BITS = pineda_pkg::RECIPROCAL_LUT_BITS;
  localparam int unsigned ROM_BITS = pineda_pkg::RECIPROCAL_ROM_BITS;
  localparam int unsigned STEPS = pineda_pkg::RECIPROCAL_NEWTON_STEPS;
  localparam int unsigned STAGES = 2 + 2 * STEPS * Stages;

  // Bit i: stage i is taken.
  logic [STAGES-1:0] valid;
  logic [STAGES-2:0] valid_q;
  assign valid = {valid_q, start_i};
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (enable_i) valid_q <= valid[STAGES-2:0];
  end

  // m in [1/2, 1): what falls below W bits is cut off.
  logic [W-1:0] m;
  if (Width >= W) begin : g_cut
    assign m = aligned_i[Width-1 -: W];
  end else begin : g_whole
    assign m = {aligned_i, {(W-Width){1'b0}}};
  end

  logic [W-1:0] m1_q, m2_q, x2_q;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid[0]) m1_q <= m;
      if (valid[1]) begin
        m2_q <= m1_q;
        x2_q <= W'({1'b1, pineda_pkg::reciprocal_rom(m1_q[W-2 -: LUT_BITS])}) << (W - 1 - ROM_BITS);
      end
    end
  end

  // Before each step, and after the last; the first lowest.
  logic [(STEPS+1)*W-1:0] m_of, x_of;
  assign m_of[0 +: W] = m2_q;
  assign x_of[0 +: W] = x2_q;
  for (genvar i = 0; i < STEPS; i++) begin : g_step
    reciprocal_newton_step #(.Stages(Stages)) u_step (
      .clk_i, .enable_i, .valid_i(valid[2+2*Stages*i +: 2*Stages]),
      .m_i(m_of[i*W +: W]), .x_i(x_of[i*W +: W]),
      .m_o(m_of[(i+1)*W +: W]), .x_o(x_of[(i+1)*W +: W])
    );
  end

  assign x_o = x_of[STEPS*W+1 +: W-1];
endmodule
`endif
