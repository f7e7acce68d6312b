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
  // product * 2^-shift, rounded half up: shifted by one bit less, one added, halved. DROPPED bits
  // fall off whatever the length is.
  localparam int LEAST_SHIFT = pineda_pkg::RECIPROCAL_BITS + FractionBits - 2 -
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned DROPPED = LEAST_SHIFT > 0 ? LEAST_SHIFT : 0;
  localparam int unsigned SHIFT_BITS = pineda_pkg::AREA2_LENGTH_BITS;
  logic [SHIFT_BITS-1:0] shift;
  assign shift = LEAST_SHIFT < 0 ? length_i - SHIFT_BITS'(1) : length_i;
  assign cut_o = (product_i >>> DROPPED) >>> shift;

  logic signed [WideBits:0] cut, rounded;
  assign cut = (WideBits+1)'(cut_o);
  assign rounded = cut + (WideBits+1)'(1);
  assign gradient_o = rounded[WideBits:1];
endmodule
`endif
