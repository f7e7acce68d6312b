// The planes of a triangle through one pipeline: depth, then the attributes. Depth goes through it in
// two halves, so that the multipliers need be no wider than for attributes.
//
// Bits     core::setup() defines them. Gradients and references wrap by design.
// In       Slot s, from 0, is in stage t of the pipeline s + t cycles after start_i. Slots 0 and 1
//          are the low and the high half of depth, if there is any; each other is an attribute.
//          tri_i in canonical order (anchor first) in stage 0, dx1_i to dy2_i in stage 1; the others
//          are taken over with factors_i, offsets_i and base_i, 3, 7 and 8 cycles after start_i.
// Out      valid_o for PLANES cycles, in order: index_o; the last one SLOTS + 8 cycles after start_i.
//          bias_o and steep_o are those of depth while index_o is 0.
// Rate     a slot every enabled cycle.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_SETUP_STEPPED
`ifdef PINEDA_PLANES
module setup_planes (
  input  logic                                           clk_i,
  input  logic                                           rst_ni,
  input  logic                                           enable_i,
`ifdef PINEDA_DEPTH
  input  pineda_pkg::frame_t                             frame_i,
`endif

  input  logic                                           start_i,
  input  pineda_pkg::triangle_t                          tri_i,
  // Vertices 1 and 2 from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_i,
  input  logic                                           factors_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS-1:0]         mantissa_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]       length_i,
  // The first sample from the anchor
  input  logic                                           offsets_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_y_i,
  // The triangle once more, for the anchor's values
  input  logic                                           base_i,
  input  pineda_pkg::triangle_t                          base_tri_i,

  output logic                                           valid_o,
  output logic [$clog2(pineda_pkg::PLANES+1)-1:0]        index_o,
`ifdef PINEDA_DEPTH
  output logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]  bias_o,
`ifdef PINEDA_HIERARCHICAL_Z
  output logic                                           steep_o,
`endif
`endif
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       dx_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       dy_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       ref_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned F = pineda_pkg::GRADIENT_FRACTION_BITS;
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned LENGTH_BITS = pineda_pkg::AREA2_LENGTH_BITS;
  localparam int unsigned PLANES = pineda_pkg::PLANES;
  localparam int unsigned PLANE_BITS = pineda_pkg::PLANE_BITS;
  localparam int unsigned FRACTION = pineda_pkg::VALUE_FRACTION_BITS;
  localparam int unsigned PRODUCT_BITS = pineda_pkg::NUMERATOR_BITS + K;
  // The reference lies a fraction of a pixel from the anchor: S more high bits before the wrap.
  localparam int unsigned WIDE_BITS = PLANE_BITS + S;
`ifdef PINEDA_DEPTH
  localparam int unsigned SLOTS = PLANES + 1;
  localparam int unsigned NUMERATOR_BITS = pineda_pkg::DEPTH_NUMERATOR_BITS;
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_IN_BITS + 1; // a difference
`else
  localparam int unsigned SLOTS = PLANES;
  localparam int unsigned NUMERATOR_BITS = pineda_pkg::ATTR_NUMERATOR_BITS;
`endif
`ifdef PINEDA_AFFINE
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_BITS;
  localparam int unsigned ATTR_NUMERATOR_BITS = pineda_pkg::ATTR_NUMERATOR_BITS;
  localparam int unsigned ATTR_WIDE_BITS = pineda_pkg::ATTR_PLANE_BITS + S;
`endif

  // ---- Widths of factors: of a half of depth, with a sign, or of an attribute
  function automatic int unsigned greatest(input int unsigned low, input int unsigned high,
                                           input int unsigned attribute);
    greatest = low > high ? low : high;
    if (attribute > greatest) greatest = attribute;
  endfunction
`ifdef PINEDA_DEPTH
  localparam int unsigned D_LOW = Z_BITS / 2;
  localparam int unsigned N_LOW = NUMERATOR_BITS / 2;
  localparam int unsigned G_LOW = WIDE_BITS / 2;
`ifdef PINEDA_AFFINE
  localparam int unsigned D_BITS = greatest(D_LOW + 1, Z_BITS - D_LOW, ATTR_BITS + 1);
  localparam int unsigned N_BITS =
      greatest(N_LOW + 1, NUMERATOR_BITS - N_LOW, ATTR_NUMERATOR_BITS);
  localparam int unsigned G_BITS = greatest(G_LOW + 1, WIDE_BITS - G_LOW, ATTR_WIDE_BITS);
`else
  localparam int unsigned D_BITS = greatest(D_LOW + 1, Z_BITS - D_LOW, 0);
  localparam int unsigned N_BITS = greatest(N_LOW + 1, NUMERATOR_BITS - N_LOW, 0);
  localparam int unsigned G_BITS = greatest(G_LOW + 1, WIDE_BITS - G_LOW, 0);
`endif
`else
  localparam int unsigned D_BITS = ATTR_BITS + 1;
  localparam int unsigned N_BITS = ATTR_NUMERATOR_BITS;
  localparam int unsigned G_BITS = ATTR_WIDE_BITS;
`endif

  // ---- Control: the slot in stage 0, and which stages have one. first[t]: slot 0 is in stage t. Then
  // slot 1 is in stage t - 1.
  localparam int unsigned STAGES = 10;
  localparam int unsigned SLOT_BITS = $clog2(SLOTS + 1);
  logic [SLOT_BITS-1:0] slot_q;
  logic [STAGES-1:0] valid;
  logic [STAGES-1:1] valid_q;
  logic [STAGES:0] first;
  logic [STAGES:1] first_q;
  assign valid = {valid_q, start_i || slot_q != '0};
  assign first = {first_q, start_i};
`ifdef PINEDA_DEPTH
  logic [STAGES-1:0] low, high; // the halves of depth
  assign low = first[STAGES-1:0];
  assign high = first[STAGES:1];
  assign valid_o = valid[STAGES-1] && !low[STAGES-1];
`else
  assign valid_o = valid[STAGES-1];
`endif
  logic [$clog2(PLANES+1)-1:0] index_q;
  assign index_o = index_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      slot_q <= '0;
      valid_q <= '0;
      first_q <= '0;
      index_q <= '0;
    end else if (enable_i) begin
      if (valid[0]) slot_q <= slot_q == SLOT_BITS'(SLOTS - 1) ? '0 : slot_q + SLOT_BITS'(1);
      valid_q <= valid[STAGES-2:0];
      first_q <= first[STAGES-1:0];
      if (valid_o) begin
        index_q <= 32'(index_q) == PLANES - 1 ? '0 : index_q + 1'b1;
      end
    end
  end

  // ---- Stage 0: differences from the anchor
  logic signed [D_BITS-1:0] d1, d2, d1_q, d2_q;
`ifdef PINEDA_DEPTH
  logic signed [Z_BITS-1:0] z0, z1, z2, z_d1, z_d2;
  assign z0 = signed'({1'b0, tri_i.z[0 +: Z_BITS-1]});
  assign z1 = signed'({1'b0, tri_i.z[Z_BITS-1 +: Z_BITS-1]});
  assign z2 = signed'({1'b0, tri_i.z[2*(Z_BITS-1) +: Z_BITS-1]});
  assign z_d1 = z1 - z0;
  assign z_d2 = z2 - z0;
`endif
  always_comb begin
    d1 = 'x;
    d2 = 'x;
`ifdef PINEDA_DEPTH
    if (low[0]) begin
      d1 = D_BITS'({1'b0, z_d1[D_LOW-1:0]});
      d2 = D_BITS'({1'b0, z_d2[D_LOW-1:0]});
    end
    if (high[0]) begin
      d1 = D_BITS'(signed'(z_d1[Z_BITS-1:D_LOW]));
      d2 = D_BITS'(signed'(z_d2[Z_BITS-1:D_LOW]));
    end
`endif
`ifdef PINEDA_AFFINE
    for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
      if (32'(slot_q) == SLOTS - ATTRIBUTES + i) begin
        d1 = D_BITS'(signed'({1'b0, tri_i.attr[(ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS]})) -
             D_BITS'(signed'({1'b0, tri_i.attr[i*ATTR_BITS +: ATTR_BITS]}));
        d2 = D_BITS'(signed'({1'b0, tri_i.attr[(2*ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS]})) -
             D_BITS'(signed'({1'b0, tri_i.attr[i*ATTR_BITS +: ATTR_BITS]}));
      end
    end
`endif
  end

  // ---- Stage 1: four products. Stage 2: numerators
  localparam int unsigned P_BITS = D_BITS + COEFF_BITS;
  logic signed [P_BITS-1:0] p1y2, p2y1, p2x1, p1x2, p1y2_q, p2y1_q, p2x1_q, p1x2_q;
  multiplier #(.ABits(COEFF_BITS), .BBits(D_BITS)) u_p1y2 (
    .a_i(dy2_i), .b_i(d1_q), .addend_i('0), .product_o(p1y2)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(D_BITS)) u_p2y1 (
    .a_i(dy1_i), .b_i(d2_q), .addend_i('0), .product_o(p2y1)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(D_BITS)) u_p2x1 (
    .a_i(dx1_i), .b_i(d2_q), .addend_i('0), .product_o(p2x1)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(D_BITS)) u_p1x2 (
    .a_i(dx2_i), .b_i(d1_q), .addend_i('0), .product_o(p1x2)
  );
  logic signed [NUMERATOR_BITS-1:0] n_x, n_y, n_x_q, n_y_q;
`ifdef PINEDA_DEPTH
  assign n_x = high[2] ? ((NUMERATOR_BITS'(p1y2_q) - NUMERATOR_BITS'(p2y1_q)) <<< D_LOW) + n_x_q
                       : NUMERATOR_BITS'(p1y2_q) - NUMERATOR_BITS'(p2y1_q);
  assign n_y = high[2] ? ((NUMERATOR_BITS'(p2x1_q) - NUMERATOR_BITS'(p1x2_q)) <<< D_LOW) + n_y_q
                       : NUMERATOR_BITS'(p2x1_q) - NUMERATOR_BITS'(p1x2_q);
`else
  assign n_x = NUMERATOR_BITS'(p1y2_q - p2y1_q);
  assign n_y = NUMERATOR_BITS'(p2x1_q - p1x2_q);
`endif

  // ---- Stage 3: one cycle more, so that both halves of depth are there when the low one goes on.
  // Stage 4: times the mantissa
  logic signed [N_BITS-1:0] n_x3, n_y3, n_x3_q, n_y3_q, n_x4, n_y4;
`ifdef PINEDA_DEPTH
  assign n_x3 = high[3] ? N_BITS'(signed'(n_x_q[NUMERATOR_BITS-1:N_LOW])) : N_BITS'(n_x_q);
  assign n_y3 = high[3] ? N_BITS'(signed'(n_y_q[NUMERATOR_BITS-1:N_LOW])) : N_BITS'(n_y_q);
  assign n_x4 = low[4] ? N_BITS'({1'b0, n_x_q[N_LOW-1:0]}) : n_x3_q;
  assign n_y4 = low[4] ? N_BITS'({1'b0, n_y_q[N_LOW-1:0]}) : n_y3_q;
`else
  assign n_x3 = n_x_q;
  assign n_y3 = n_y_q;
  assign n_x4 = n_x3_q;
  assign n_y4 = n_y3_q;
`endif
  logic [K-1:0] mantissa_q;
  logic [LENGTH_BITS-1:0] length4_q, length6_q;
  logic signed [N_BITS+K:0] g_product_x, g_product_y, g_product_x_q, g_product_y_q;
  multiplier #(.ABits(N_BITS), .BBits(K + 1)) u_gradient_x_product (
    .a_i(n_x4), .b_i({1'b0, mantissa_q}), .addend_i('0), .product_o(g_product_x)
  );
  multiplier #(.ABits(N_BITS), .BBits(K + 1)) u_gradient_y_product (
    .a_i(n_y4), .b_i({1'b0, mantissa_q}), .addend_i('0), .product_o(g_product_y)
  );

  // ---- Stage 5: the halves together, attributes in units of 2^-FRACTION. Stage 6: shifted, rounded
  localparam int unsigned DROPPED = FRACTION + K > F + S + 2 ? FRACTION + K - F - S - 2 : 0;
  logic signed [PRODUCT_BITS-1:0] sum_x, sum_y, sum_x_q, sum_y_q;
  always_comb begin
    sum_x = PRODUCT_BITS'(g_product_x_q) <<< FRACTION;
    sum_y = PRODUCT_BITS'(g_product_y_q) <<< FRACTION;
`ifdef PINEDA_DEPTH
    if (low[5]) begin
      sum_x = PRODUCT_BITS'(g_product_x_q);
      sum_y = PRODUCT_BITS'(g_product_y_q);
    end
    if (high[5]) begin
      sum_x = (PRODUCT_BITS'(g_product_x_q) <<< N_LOW) + sum_x_q;
      sum_y = (PRODUCT_BITS'(g_product_y_q) <<< N_LOW) + sum_y_q;
    end
`endif
    // What setup_gradient does not read
    sum_x = (sum_x >>> DROPPED) <<< DROPPED;
    sum_y = (sum_y >>> DROPPED) <<< DROPPED;
  end
  logic signed [PRODUCT_BITS-1:0] cut_x, cut_y;
  logic signed [WIDE_BITS-1:0] g_x, g_y, g_x_q, g_y_q, g_x7_q, g_y7_q;
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FRACTION), .WideBits(WIDE_BITS)
  ) u_gradient_x (.product_i(sum_x_q), .length_i(length6_q), .cut_o(cut_x), .gradient_o(g_x));
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(FRACTION), .WideBits(WIDE_BITS)
  ) u_gradient_y (.product_i(sum_y_q), .length_i(length6_q), .cut_o(cut_y), .gradient_o(g_y));
`ifdef PINEDA_DEPTH
  setup_plane_bias #(.CutBits(PRODUCT_BITS)) u_bias (
    .clk_i, .enable_i, .valid_i(high[8:6]), .frame_i, .cut_x_i(cut_x), .cut_y_i(cut_y),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o,
`endif
    .bias_o
  );
`endif

  // ---- Stage 7: one cycle more, as in stage 3. Stage 8: times the offset of the first sample
  logic signed [COEFF_BITS-1:0] ref_x_q, ref_y_q;
  logic signed [G_BITS-1:0] g_x8, g_y8;
`ifdef PINEDA_DEPTH
  always_comb begin
    g_x8 = G_BITS'(g_x7_q);
    g_y8 = G_BITS'(g_y7_q);
    if (low[8]) begin
      g_x8 = G_BITS'({1'b0, g_x_q[G_LOW-1:0]});
      g_y8 = G_BITS'({1'b0, g_y_q[G_LOW-1:0]});
    end
    if (high[8]) begin
      g_x8 = G_BITS'(signed'(g_x7_q[WIDE_BITS-1:G_LOW]));
      g_y8 = G_BITS'(signed'(g_y7_q[WIDE_BITS-1:G_LOW]));
    end
  end
`else
  assign g_x8 = g_x7_q;
  assign g_y8 = g_y7_q;
`endif
  logic signed [G_BITS+COEFF_BITS-1:0] at_ref_x, at_ref_y;
  logic signed [WIDE_BITS-1:0] at_ref_x_q, at_ref_y_q;
  multiplier #(.ABits(G_BITS), .BBits(COEFF_BITS)) u_at_ref_x (
    .a_i(g_x8), .b_i(ref_x_q), .addend_i('0), .product_o(at_ref_x)
  );
  multiplier #(.ABits(G_BITS), .BBits(COEFF_BITS)) u_at_ref_y (
    .a_i(g_y8), .b_i(ref_y_q), .addend_i('0), .product_o(at_ref_y)
  );
  logic signed [PLANE_BITS-1:0] dx_q, dy_q;
  assign dx_o = dx_q;
  assign dy_o = dy_q;

  // ---- Stage 9: the reference, S fraction bits too many, rounded away, halves up
  logic [pineda_pkg::VALUE_BITS-1:0] base;
  logic signed [WIDE_BITS-1:0] at_ref, at_ref_low_q;
  always_comb begin
    at_ref = (WIDE_BITS'(base) <<< (F - FRACTION + S)) + WIDE_BITS'(1 << (S - 1)) +
             at_ref_x_q + at_ref_y_q;
`ifdef PINEDA_DEPTH
    if (high[9]) at_ref = ((at_ref_x_q + at_ref_y_q) <<< G_LOW) + at_ref_low_q;
`endif
  end
  assign ref_o = at_ref[WIDE_BITS-1:S];

  logic [3*pineda_pkg::VALUE_BITS-1:0] base_values;
  pineda_pkg::triangle_t base_tri_q;
  setup_values u_base (
    .valid_i(valid[9]), .index_i(index_q), .tri_i(base_tri_q), .values_o(base_values)
  );
  assign base = base_values[pineda_pkg::VALUE_BITS-1:0];

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (factors_i) {mantissa_q, length4_q} <= {mantissa_i, length_i};
      if (offsets_i) {ref_x_q, ref_y_q} <= {ref_x_i, ref_y_i};
      if (base_i) base_tri_q <= base_tri_i;
      if (valid[0]) {d1_q, d2_q} <= {d1, d2};
      if (valid[1]) {p1y2_q, p2y1_q, p2x1_q, p1x2_q} <= {p1y2, p2y1, p2x1, p1x2};
      if (valid[2]) {n_x_q, n_y_q} <= {n_x, n_y};
      if (valid[3]) {n_x3_q, n_y3_q} <= {n_x3, n_y3};
      if (valid[4]) {g_product_x_q, g_product_y_q} <= {g_product_x, g_product_y};
      if (valid[5]) {sum_x_q, sum_y_q} <= {sum_x, sum_y};
      if (first[5]) length6_q <= length4_q;
      if (valid[6]) {g_x_q, g_y_q} <= {g_x, g_y};
      if (valid[7]) {g_x7_q, g_y7_q} <= {g_x_q, g_y_q};
      if (valid[8]) begin
        at_ref_x_q <= WIDE_BITS'(at_ref_x);
        at_ref_y_q <= WIDE_BITS'(at_ref_y);
        dx_q <= g_x7_q[PLANE_BITS-1:0];
        dy_q <= g_y7_q[PLANE_BITS-1:0];
      end
`ifdef PINEDA_DEPTH
      if (valid[9]) at_ref_low_q <= at_ref;
`endif
    end
  end
endmodule
`endif
`endif
