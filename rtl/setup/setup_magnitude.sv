// Magnitude of a depth gradient for the depth bias: rounded half up, saturated. No state.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       cut_i: the gradient, not wrapped, truncated one bit below F fraction bits.
// Out      UQ<depth_bits+3>.8: from -2^n to 2^n - 1 before its sign was dropped.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_magnitude #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS
) (
  input  logic signed [CutBits-1:0]                  cut_i,
  output logic [pineda_pkg::BIAS_MAGNITUDE_BITS-1:0] magnitude_o
);
  localparam int unsigned BITS = pineda_pkg::BIAS_MAGNITUDE_BITS;
  localparam int unsigned DROPPED_BITS =
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::BIAS_FACTOR_FRACTION_BITS;
  logic signed [CutBits-1:0] rounded;
  assign rounded = ((cut_i >>> DROPPED_BITS) + CutBits'(1)) >>> 1;

  // Whether `rounded` is a signed number of BITS bits.
  logic fits;
  assign fits = rounded[CutBits-1:BITS-1] == '0 || rounded[CutBits-1:BITS-1] == '1;
  always_comb begin
    if (!fits) magnitude_o = {rounded[CutBits-1], {(BITS-1){!rounded[CutBits-1]}}};
    else magnitude_o = rounded[CutBits-1] ? -rounded[BITS-1:0] : rounded[BITS-1:0];
  end
endmodule
`endif
