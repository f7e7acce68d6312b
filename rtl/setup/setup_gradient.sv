// A gradient from its numerator times the reciprocal: shifted, rounded half up, wrapped. No state.
//
// Bits     core::setup() defines the gradients of its planes.
// Out      gradient_o with F fraction bits; cut_o, the whole value truncated one bit below that.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_PLANES
module setup_gradient #(
  parameter int unsigned ProductBits = 1,
  parameter int unsigned FractionBits = 1, // of the values at the vertices
  parameter int unsigned WideBits = 1
) (
  input  logic signed [ProductBits-1:0]            product_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0] length_i,
  output logic signed [ProductBits-1:0]            cut_o,
  output logic signed [WideBits-1:0]               gradient_o
);
  // product * 2^-shift, rounded half up: shifted by one bit less, one added, halved.
  localparam int unsigned SHIFT_BITS = 7;
  localparam int unsigned SHIFT_BASE = pineda_pkg::RECIPROCAL_BITS - 2 -
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::SUBPIXEL_BITS + FractionBits;
  logic [SHIFT_BITS-1:0] shift_less_1;
  assign shift_less_1 = SHIFT_BITS'(length_i) + SHIFT_BITS'(SHIFT_BASE);
  assign cut_o = product_i >>> shift_less_1;

  logic signed [WideBits:0] cut, rounded;
  assign cut = (WideBits+1)'(cut_o);
  assign rounded = cut + (WideBits+1)'(1);
  assign gradient_o = rounded[WideBits:1];
endmodule
`endif
