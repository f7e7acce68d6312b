// Planes through three vertices, one an enabled cycle: a pipeline of 4 + 3 * MULTIPLIER_STAGES stages.
//
// Bits     core::setup() defines them. Gradients and references wrap by design.
// In       With M = MULTIPLIER_STAGES: values in canonical order (anchor first) in stage 0; dx1_i to
//          dy2_i in stage 1, mantissa_i in stage 2 + M, length_i in 2 + 2M, ref_x_i and ref_y_i in
//          3 + 2M. valid_i: which stages are taken.
// Out      dx_o, dy_o, ref_o after the last stage; cut_x_o and cut_y_o in stage 2 + 2M: the gradients
//          as setup_gradient has them.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_SETUP_PIPELINED
`ifdef PINEDA_PLANES
module setup_plane #(
  parameter int unsigned ValueBits = pineda_pkg::VALUE_BITS,
  parameter int unsigned FractionBits = pineda_pkg::VALUE_FRACTION_BITS,
  parameter int unsigned NumeratorBits = pineda_pkg::NUMERATOR_BITS,
  parameter int unsigned PlaneBits = pineda_pkg::PLANE_BITS
) (
  input  logic                                           clk_i,
  input  logic                                           enable_i,
  input  logic [3+3*pineda_pkg::MULTIPLIER_STAGES:0]     valid_i,

  input  logic [3*ValueBits-1:0]                         values_i, // the anchor's lowest
  // Vertices 1 and 2 from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS-1:0]         mantissa_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]       length_i,
  // The first sample from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_y_i,

  output logic signed [NumeratorBits+pineda_pkg::RECIPROCAL_BITS-1:0]  cut_x_o,
  output logic signed [NumeratorBits+pineda_pkg::RECIPROCAL_BITS-1:0]  cut_y_o,
  output logic signed [PlaneBits-1:0]                    dx_o,
  output logic signed [PlaneBits-1:0]                    dy_o,
  output logic signed [PlaneBits-1:0]                    ref_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned F = pineda_pkg::GRADIENT_FRACTION_BITS;
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned PRODUCT_BITS = NumeratorBits + K;
  // The reference lies a fraction of a pixel from the anchor: S more high bits before the wrap.
  localparam int unsigned WIDE_BITS = PlaneBits + S;

  // ---- Stages: differences, products, numerators, times the mantissa, gradients, times the offset of
  // the first sample, reference
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;
  localparam int unsigned PRODUCTS = 1;
  localparam int unsigned NUMERATORS = PRODUCTS + M;
  localparam int unsigned QUOTIENTS = NUMERATORS + 1;
  localparam int unsigned GRADIENTS = QUOTIENTS + M;
  localparam int unsigned OFFSETS = GRADIENTS + 1;
  localparam int unsigned REFERENCE = OFFSETS + M;

  logic [ValueBits-1:0] value0, value1, value2;
  assign {value2, value1, value0} = values_i;

  // Four products
  logic signed [ValueBits:0] d1_q, d2_q;
  logic signed [NumeratorBits:0] p1y2, p2y1, p2x1, p1x2;
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(ValueBits + 1), .ProductBits(NumeratorBits + 1)
  ) u_p1y2 (
    .clk_i, .enable_i, .valid_i(valid_i[PRODUCTS +: M]),
    .a_i(dy2_i), .b_i(d1_q), .addend_i('0), .product_o(p1y2)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(ValueBits + 1), .ProductBits(NumeratorBits + 1)
  ) u_p2y1 (
    .clk_i, .enable_i, .valid_i(valid_i[PRODUCTS +: M]),
    .a_i(dy1_i), .b_i(d2_q), .addend_i('0), .product_o(p2y1)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(ValueBits + 1), .ProductBits(NumeratorBits + 1)
  ) u_p2x1 (
    .clk_i, .enable_i, .valid_i(valid_i[PRODUCTS +: M]),
    .a_i(dx1_i), .b_i(d2_q), .addend_i('0), .product_o(p2x1)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(ValueBits + 1), .ProductBits(NumeratorBits + 1)
  ) u_p1x2 (
    .clk_i, .enable_i, .valid_i(valid_i[PRODUCTS +: M]),
    .a_i(dx2_i), .b_i(d1_q), .addend_i('0), .product_o(p1x2)
  );

  // Times the mantissa, then shifted
  logic signed [NumeratorBits-1:0] numerator_x_q, numerator_y_q;
  logic signed [PRODUCT_BITS-1:0] product_x, product_y;
  multiplier_pipelined #(
    .ABits(NumeratorBits), .BBits(K + 1), .ProductBits(PRODUCT_BITS)
  ) u_product_x (
    .clk_i, .enable_i, .valid_i(valid_i[QUOTIENTS +: M]),
    .a_i(numerator_x_q), .b_i(signed'({1'b0, mantissa_i})), .addend_i('0), .product_o(product_x)
  );
  multiplier_pipelined #(
    .ABits(NumeratorBits), .BBits(K + 1), .ProductBits(PRODUCT_BITS)
  ) u_product_y (
    .clk_i, .enable_i, .valid_i(valid_i[QUOTIENTS +: M]),
    .a_i(numerator_y_q), .b_i(signed'({1'b0, mantissa_i})), .addend_i('0), .product_o(product_y)
  );
  logic signed [WIDE_BITS-1:0] gradient_x, gradient_y, gradient_x_q, gradient_y_q;
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FractionBits), .WideBits(WIDE_BITS)
  ) u_gradient_x (.product_i(product_x), .length_i, .cut_o(cut_x_o), .gradient_o(gradient_x));
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FractionBits), .WideBits(WIDE_BITS)
  ) u_gradient_y (.product_i(product_y), .length_i, .cut_o(cut_y_o), .gradient_o(gradient_y));

  // Times the offset
  logic signed [WIDE_BITS-1:0] at_ref_x, at_ref_y;
  multiplier_pipelined #(
    .ABits(WIDE_BITS), .BBits(COEFF_BITS), .ProductBits(WIDE_BITS)
  ) u_at_ref_x (
    .clk_i, .enable_i, .valid_i(valid_i[OFFSETS +: M]),
    .a_i(gradient_x_q), .b_i(ref_x_i), .addend_i('0), .product_o(at_ref_x)
  );
  multiplier_pipelined #(
    .ABits(WIDE_BITS), .BBits(COEFF_BITS), .ProductBits(WIDE_BITS)
  ) u_at_ref_y (
    .clk_i, .enable_i, .valid_i(valid_i[OFFSETS +: M]),
    .a_i(gradient_y_q), .b_i(ref_y_i), .addend_i('0), .product_o(at_ref_y)
  );
  logic [ValueBits-1:0] base;
  logic signed [PlaneBits-1:0] dx, dy;
  delay_line #(.Width(ValueBits), .Depth(REFERENCE)) u_base (
    .clk_i, .enable_i, .data_i(value0), .data_o(base)
  );
  delay_line #(.Width(2*PlaneBits), .Depth(M)) u_gradients (
    .clk_i, .enable_i,
    .data_i({gradient_x_q[PlaneBits-1:0], gradient_y_q[PlaneBits-1:0]}), .data_o({dx, dy})
  );

  // The reference: S fraction bits too many, rounded away, halves up.
  logic signed [WIDE_BITS-1:0] at_ref;
  assign at_ref = (WIDE_BITS'(base) << (F - FractionBits + S)) + at_ref_x + at_ref_y +
                  WIDE_BITS'(1 << (S - 1));

  logic signed [PlaneBits-1:0] dx_q, dy_q, ref_q;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) begin
        d1_q <= signed'({1'b0, value1}) - signed'({1'b0, value0});
        d2_q <= signed'({1'b0, value2}) - signed'({1'b0, value0});
      end
      if (valid_i[NUMERATORS]) begin
        numerator_x_q <= NumeratorBits'(p1y2 - p2y1);
        numerator_y_q <= NumeratorBits'(p2x1 - p1x2);
      end
      if (valid_i[GRADIENTS]) {gradient_x_q, gradient_y_q} <= {gradient_x, gradient_y};
      if (valid_i[REFERENCE]) {dx_q, dy_q, ref_q} <= {dx, dy, at_ref[WIDE_BITS-1:S]};
    end
  end
  assign dx_o = dx_q;
  assign dy_o = dy_q;
  assign ref_o = ref_q;
endmodule
`endif
`endif
