// Reciprocal of the doubled area: aligned, taken by the scheme of the design, rounded once.
//
// Bits     core::reciprocal() defines them: 1/area2 = mantissa * 2^(1 - k - length).
// In       area2_i > 0, held in the cycle of start_i.
// Out      length_o from the cycle after start_i on; mantissa_o, UQ0.k in [1/2, 1), from
//          spec::reciprocal_cycles() after it on; both until the next start_i.
// Rate     one result every spec::reciprocal_cycles() enabled cycles.
// Twin     model/core/reciprocal.cpp.
`ifdef PINEDA_PLANES
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
  localparam int unsigned AREA_BITS = pineda_pkg::AREA2_BITS - 1;
  localparam int unsigned LENGTH_BITS = pineda_pkg::AREA2_LENGTH_BITS;

  logic [LENGTH_BITS-1:0] length;
  logic [AREA_BITS-1:0] aligned;
  reciprocal_align #(.Width(AREA_BITS), .LengthBits(LENGTH_BITS)) u_align (
    .valid_i(start_i), .value_i(area2_i), .length_o(length), .aligned_o(aligned)
  );

  logic [LENGTH_BITS-1:0] length_q;
  always_ff @(posedge clk_i) begin
    if (enable_i && start_i) length_q <= length;
  end

  logic [K:0] x;
`ifdef PINEDA_RECIPROCAL_NEWTON
  reciprocal_newton
`elsif PINEDA_RECIPROCAL_QUADRATIC
  reciprocal_quadratic
`elsif PINEDA_RECIPROCAL_RESTORING
  reciprocal_restoring
`endif
  u_scheme (.clk_i, .rst_ni, .enable_i, .start_i, .aligned_i(aligned), .x_o(x));

  logic [K:0] rounded;
  assign rounded = {1'b0, x[K:1]} + (K+1)'(x[0]);
  assign length_o = length_q;
  assign mantissa_o = rounded[K] ? '1 : rounded[K-1:0];
endmodule
`endif
