// Planes through three vertices, one an enabled cycle: a pipeline of seven stages.
//
// Bits     core::setup() defines them. Gradients and references wrap by design.
// In       values in canonical order (anchor first) in stage 0; dx1_i to dy2_i in stage 1,
//          mantissa_i in stage 3, length_i in 4, ref_x_i and ref_y_i in 5. valid_i: which stages
//          are taken.
// Out      dx_o, dy_o, ref_o after stage 6; cut_x_o and cut_y_o in stage 4: the gradients as
//          setup_gradient has them.
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
  input  logic [6:0]                                     valid_i,

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

  logic [ValueBits-1:0] value0, value1, value2;
  assign {value2, value1, value0} = values_i;

  logic signed [ValueBits:0] d1_q, d2_q;
  logic [ValueBits-1:0] base1_q, base2_q, base3_q, base4_q, base5_q;
  logic signed [NumeratorBits:0] p1y2_q, p2y1_q, p2x1_q, p1x2_q;
  logic signed [NumeratorBits-1:0] numerator_x_q, numerator_y_q;
  logic signed [PRODUCT_BITS-1:0] product_x_q, product_y_q;
  logic signed [WIDE_BITS-1:0] gradient_x, gradient_y, gradient_x_q, gradient_y_q;
  logic signed [PlaneBits-1:0] dx_q, dy_q;
  logic signed [WIDE_BITS-1:0] at_ref_x_q, at_ref_y_q, base_q;

  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FractionBits), .WideBits(WIDE_BITS)
  ) u_gradient_x (.product_i(product_x_q), .length_i, .cut_o(cut_x_o), .gradient_o(gradient_x));
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FractionBits), .WideBits(WIDE_BITS)
  ) u_gradient_y (.product_i(product_y_q), .length_i, .cut_o(cut_y_o), .gradient_o(gradient_y));

  // Products with all of their bits
  logic signed [COEFF_BITS+ValueBits:0] full_p1y2, full_p2y1, full_p2x1, full_p1x2;
  logic signed [NumeratorBits+K:0] full_product_x, full_product_y;
  logic signed [WIDE_BITS+COEFF_BITS-1:0] full_at_ref_x, full_at_ref_y;
  multiplier #(.ABits(COEFF_BITS), .BBits(ValueBits + 1)) u_p1y2 (
    .a_i(dy2_i), .b_i(d1_q), .addend_i('0), .product_o(full_p1y2)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(ValueBits + 1)) u_p2y1 (
    .a_i(dy1_i), .b_i(d2_q), .addend_i('0), .product_o(full_p2y1)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(ValueBits + 1)) u_p2x1 (
    .a_i(dx1_i), .b_i(d2_q), .addend_i('0), .product_o(full_p2x1)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(ValueBits + 1)) u_p1x2 (
    .a_i(dx2_i), .b_i(d1_q), .addend_i('0), .product_o(full_p1x2)
  );
  multiplier #(.ABits(NumeratorBits), .BBits(K + 1)) u_product_x (
    .a_i(numerator_x_q), .b_i({1'b0, mantissa_i}), .addend_i('0), .product_o(full_product_x)
  );
  multiplier #(.ABits(NumeratorBits), .BBits(K + 1)) u_product_y (
    .a_i(numerator_y_q), .b_i({1'b0, mantissa_i}), .addend_i('0), .product_o(full_product_y)
  );
  multiplier #(.ABits(WIDE_BITS), .BBits(COEFF_BITS)) u_at_ref_x (
    .a_i(gradient_x_q), .b_i(ref_x_i), .addend_i('0), .product_o(full_at_ref_x)
  );
  multiplier #(.ABits(WIDE_BITS), .BBits(COEFF_BITS)) u_at_ref_y (
    .a_i(gradient_y_q), .b_i(ref_y_i), .addend_i('0), .product_o(full_at_ref_y)
  );

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) begin
        d1_q <= signed'({1'b0, value1}) - signed'({1'b0, value0});
        d2_q <= signed'({1'b0, value2}) - signed'({1'b0, value0});
        base1_q <= value0;
      end
      if (valid_i[1]) begin // four products
        p1y2_q <= (NumeratorBits+1)'(full_p1y2);
        p2y1_q <= (NumeratorBits+1)'(full_p2y1);
        p2x1_q <= (NumeratorBits+1)'(full_p2x1);
        p1x2_q <= (NumeratorBits+1)'(full_p1x2);
        base2_q <= base1_q;
      end
      if (valid_i[2]) begin
        numerator_x_q <= NumeratorBits'(p1y2_q - p2y1_q);
        numerator_y_q <= NumeratorBits'(p2x1_q - p1x2_q);
        base3_q <= base2_q;
      end
      if (valid_i[3]) begin
        product_x_q <= PRODUCT_BITS'(full_product_x);
        product_y_q <= PRODUCT_BITS'(full_product_y);
        base4_q <= base3_q;
      end
      if (valid_i[4]) begin
        gradient_x_q <= gradient_x;
        gradient_y_q <= gradient_y;
        base5_q <= base4_q;
      end
      if (valid_i[5]) begin
        dx_q <= gradient_x_q[PlaneBits-1:0];
        dy_q <= gradient_y_q[PlaneBits-1:0];
        at_ref_x_q <= WIDE_BITS'(full_at_ref_x);
        at_ref_y_q <= WIDE_BITS'(full_at_ref_y);
        base_q <= WIDE_BITS'(base5_q) << (F - FractionBits + S);
      end
    end
  end

  // The reference: S fraction bits too many, rounded away, halves up.
  logic signed [WIDE_BITS-1:0] at_ref;
  assign at_ref = base_q + at_ref_x_q + at_ref_y_q + WIDE_BITS'(1 << (S - 1));
  logic signed [PlaneBits-1:0] dx6_q, dy6_q, ref6_q;
  always_ff @(posedge clk_i) begin
    if (enable_i && valid_i[6]) begin
      dx6_q <= dx_q;
      dy6_q <= dy_q;
      ref6_q <= at_ref[WIDE_BITS-1:S];
    end
  end
  assign dx_o = dx6_q;
  assign dy_o = dy6_q;
  assign ref_o = ref6_q;
endmodule
`endif
`endif
