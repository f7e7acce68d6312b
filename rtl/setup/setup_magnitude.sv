// Magnitude of a depth gradient for the depth bias: rounded half up, saturated. In two parts, so that
// a register, and the choice of the greater one, fit between them. No state.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       cut_i: the gradient, not wrapped, truncated one bit below F fraction bits.
// Out      magnitude_o: UQ<depth_bits+3>.8, from -2^n to 2^n - 1 before its sign was dropped.
//          part_o: of two gradients the one with the greater part has the greater magnitude.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_magnitude #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS
) (
  input  logic signed [CutBits-1:0]                  cut_i,
  output logic [pineda_pkg::BIAS_MAGNITUDE_BITS:0]   part_o,

  input  logic [pineda_pkg::BIAS_MAGNITUDE_BITS:0]   part_i, // that, or of a cycle before
  output logic [pineda_pkg::BIAS_MAGNITUDE_BITS-1:0] magnitude_o
);
  // Rounded half up, a negative c is -floor((c + 1) / 2) = floor((~c + 1) / 2), as c >= 0 is
  // floor((c + 1) / 2). So what is below its sign, inverted where that is set, decides. The sign
  // stands at the bottom, since 2^n is reached by a negative gradient alone.
  localparam int unsigned BITS = pineda_pkg::BIAS_MAGNITUDE_BITS;
  localparam int unsigned DROPPED_BITS =
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::BIAS_FACTOR_FRACTION_BITS;
  localparam int unsigned WIDE_BITS = CutBits > BITS + 1 ? CutBits : BITS + 2;
  logic signed [WIDE_BITS-1:0] cut;
  logic negative;
  assign cut = WIDE_BITS'(cut_i >>> DROPPED_BITS);
  assign negative = cut[WIDE_BITS-1];
  assign part_o[0] = negative;
  assign part_o[BITS:1] = (cut[BITS-1:0] ^ {BITS{negative}}) |
                          {BITS{cut[WIDE_BITS-1:BITS] != {(WIDE_BITS-BITS){negative}}}};

  logic [BITS-1:0] rounded;
  assign rounded = BITS'(part_i[BITS:2]) + BITS'(part_i[1]);
  assign magnitude_o = part_i == {{BITS{1'b1}}, 1'b0} ? {1'b0, {(BITS-1){1'b1}}} : rounded;
endmodule
`endif
