// Magnitude of a depth gradient for the depth bias: rounded half up, saturated. In two parts, so that
// a register fits between them. No state.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       cut_i: the gradient, not wrapped, truncated one bit below F fraction bits.
// Out      UQ<depth_bits+3>.8: from -2^n to 2^n - 1 before its sign was dropped.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_magnitude #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS
) (
  input  logic signed [CutBits-1:0]                         cut_i,
  output logic signed [pineda_pkg::BIAS_MAGNITUDE_BITS+1:0] saturated_o, // two bits too many

  input  logic signed [pineda_pkg::BIAS_MAGNITUDE_BITS+1:0] saturated_i, // of a cycle before
  output logic [pineda_pkg::BIAS_MAGNITUDE_BITS-1:0]        magnitude_o
);
  localparam int unsigned BITS = pineda_pkg::BIAS_MAGNITUDE_BITS;
  localparam int unsigned DROPPED_BITS =
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::BIAS_FACTOR_FRACTION_BITS;
  localparam int unsigned WIDE_BITS = CutBits > BITS + 2 ? CutBits : BITS + 3;
  logic signed [WIDE_BITS-1:0] cut;
  assign cut = WIDE_BITS'(cut_i >>> DROPPED_BITS);
  assign saturated_o =
      cut[WIDE_BITS-1:BITS+1] == '0 || cut[WIDE_BITS-1:BITS+1] == '1
          ? cut[BITS+1:0] : {cut[WIDE_BITS-1], {(BITS+1){!cut[WIDE_BITS-1]}}};

  // Whether the rounded number is a signed one of BITS bits
  logic signed [BITS+2:0] rounded;
  logic fits;
  assign rounded = ((BITS+3)'(saturated_i) + (BITS+3)'(1)) >>> 1;
  assign fits = rounded[BITS+2:BITS-1] == '0 || rounded[BITS+2:BITS-1] == '1;
  always_comb begin
    if (!fits) magnitude_o = {rounded[BITS+2], {(BITS-1){!rounded[BITS+2]}}};
    else magnitude_o = rounded[BITS+2] ? -rounded[BITS-1:0] : rounded[BITS-1:0];
  end
endmodule
`endif
