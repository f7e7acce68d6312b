// Reciprocal of any number, one a cycle: aligned, taken by the scheme of the design, rounded once.
// Division by digits has no such module: it takes many cycles.
//
// Bits     core::reciprocal() defines them: 1/value = mantissa * 2^(1 - k - length).
// In       value_i > 0, with valid_i.
// Out      length_o and mantissa_o, UQ0.k in [1/2, 1): PIPELINED_RECIPROCAL_CYCLES after valid_i.
// Rate     one result an enabled cycle.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_RECIPROCAL_NEWTON
`define PINEDA_RECIPROCAL_PIPELINED reciprocal_newton_pipelined
`elsif PINEDA_RECIPROCAL_QUADRATIC
`define PINEDA_RECIPROCAL_PIPELINED reciprocal_quadratic
`endif
`ifdef PINEDA_RECIPROCAL_PIPELINED
module reciprocal_pipelined #(
  parameter int unsigned Width = pineda_pkg::AREA2_BITS - 1,
  parameter int unsigned LengthBits = $clog2(Width + 1)
) (
  input  logic                                    clk_i,
  input  logic                                    rst_ni,
  input  logic                                    enable_i,

  input  logic                                    valid_i,
  input  logic [Width-1:0]                        value_i,

  output logic [LengthBits-1:0]                   length_o,
  output logic [pineda_pkg::RECIPROCAL_BITS-1:0]  mantissa_o
);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned CYCLES = pineda_pkg::PIPELINED_RECIPROCAL_CYCLES;
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;

  logic [LengthBits-1:0] length;
  logic [Width-1:0] aligned, start_aligned;
  logic start;
  reciprocal_align #(.Width(Width), .LengthBits(LengthBits)) u_align (
    .valid_i, .value_i, .length_o(length), .aligned_o(aligned)
  );

  // Alignment takes M cycles; the scheme has a register for the last of them.
  logic [M-1:0] valid;
  assign valid[0] = valid_i;
  if (M > 1) begin : g_valid
    logic [M-1:1] valid_q;
    assign valid[M-1:1] = valid_q;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) valid_q <= '0;
      else if (enable_i) valid_q <= valid[M-2:0];
    end
  end
  assign start = valid[M-1];
  delay_line #(.Width(Width), .Depth(M - 1)) u_aligned (
    .clk_i, .enable_i, .data_i(aligned), .data_o(start_aligned)
  );

  logic [CYCLES*LengthBits-1:0] length_q; // the newest lowest
  always_ff @(posedge clk_i) begin
    if (enable_i) length_q <= {length_q[(CYCLES-1)*LengthBits-1:0], length};
  end

  logic [K:0] x;
  `PINEDA_RECIPROCAL_PIPELINED #(.Width(Width), .Stages(M)) u_scheme (
    .clk_i, .rst_ni, .enable_i, .start_i(start), .aligned_i(start_aligned), .x_o(x)
  );

  logic [K:0] rounded;
  assign rounded = {1'b0, x[K:1]} + (K+1)'(x[0]);
  assign length_o = length_q[(CYCLES-1)*LengthBits +: LengthBits];
  assign mantissa_o = rounded[K] ? '1 : rounded[K-1:0];
endmodule
`endif
