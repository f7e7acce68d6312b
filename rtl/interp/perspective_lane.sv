// One sample's attributes, corrected by perspective: weights from E/w.
//
// Bits     core::perspective_attributes() defines them.
// In       valid_i: a sample in each stage, 0 = about to enter. In stage 0 the edges at the stamp's
//          first sample; in stage 1 inverse_w_i; MULTIPLIER_STAGES later its exponents;
//          MULTIPLIER_STAGES before the last one the vertices' attributes. All are the same for the
//          samples of a stamp.
// Out      attr_o in the last stage; 0 when it is empty.
// Rate     a sample a cycle.
// Twin     model/core/perspective.cpp.
`ifdef PINEDA_PERSPECTIVE
module perspective_lane #(
  parameter int unsigned Column = 0, // of the sample in its stamp
  parameter int unsigned Row = 0
) (
  input  logic                                                     clk_i,
  input  logic                                                     rst_ni,
  input  logic [pineda_pkg::ATTRIBUTE_CYCLES-1:0]                  valid_i,

  input  logic [3*pineda_pkg::EDGE_COEFF_BITS-1:0]                 a_i,
  input  logic [3*pineda_pkg::EDGE_COEFF_BITS-1:0]                 b_i,
  input  logic [3*pineda_pkg::EDGE_BITS-1:0]                       e_i,
  input  logic [3*pineda_pkg::SUBPIXEL_BITS-1:0]                   e_low_i,
  input  logic [3*pineda_pkg::INVERSE_W_BITS-1:0]                  inverse_w_i,
  input  logic [3*pineda_pkg::INVERSE_W_SHIFT_BITS-1:0]            inverse_w_shift_i,
  input  logic [3*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] vertex_attr_i,

  output logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0]  attr_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::EDGE_BITS;
  localparam int unsigned E_BITS = pineda_pkg::AREA2_BITS - 1; // E >= 0 at a covered sample
  localparam int unsigned INVERSE_BITS = pineda_pkg::INVERSE_W_BITS;
  localparam int unsigned SHIFT_BITS = pineda_pkg::INVERSE_W_SHIFT_BITS;
  localparam int unsigned EXACT_BITS = E_BITS + INVERSE_BITS;
  localparam int unsigned PRODUCT_BITS = pineda_pkg::WEIGHT_PRODUCT_BITS;
  localparam int unsigned SUM_BITS = PRODUCT_BITS + 2;
  localparam int unsigned LENGTH_BITS = $clog2(SUM_BITS + 1);
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned WEIGHT_BITS = pineda_pkg::WEIGHT_FRACTION_BITS + 1; // U1.24
  localparam int unsigned F = pineda_pkg::WEIGHT_FRACTION_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_BITS;
  // ---- Stages; a product takes M of them.
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;
  localparam int unsigned PRODUCTS = 1;
  localparam int unsigned LENGTHS = PRODUCTS + M;
  localparam int unsigned CUT = LENGTHS + 1;
  localparam int unsigned SUM = CUT + 1;
  localparam int unsigned RECIPROCAL = SUM + 1;
  localparam int unsigned SHARES = RECIPROCAL + pineda_pkg::PIPELINED_RECIPROCAL_CYCLES;
  localparam int unsigned WEIGHTS = SHARES + M;
  localparam int unsigned TERMS = WEIGHTS + 1;
  localparam int unsigned LAST = TERMS + M;

  // ---- E of each edge. Vertex v has that of the opposite one, (v + 1) % 3.
  logic [3*E_BITS-1:0] e_q; // by vertex
  for (genvar v = 0; v < 3; v++) begin : gen_edges
    localparam int unsigned EDGE = (v + 1) % 3;
    logic signed [COEFF_BITS-1:0] a, b;
    logic [EDGE_BITS-2:0] steps; // E' >= 0 too
    logic top_left;
    assign a = signed'(a_i[EDGE*COEFF_BITS +: COEFF_BITS]);
    assign b = signed'(b_i[EDGE*COEFF_BITS +: COEFF_BITS]);
    assign top_left = a > 0 || (a == 0 && b > 0);
    assign steps = (EDGE_BITS-1)'(e_i[EDGE*EDGE_BITS +: EDGE_BITS] +
                                  EDGE_BITS'(a) * EDGE_BITS'(Column) +
                                  EDGE_BITS'(b) * EDGE_BITS'(Row));
    always_ff @(posedge clk_i) begin
      if (valid_i[0]) begin
        e_q[v*E_BITS +: E_BITS] <=
            {steps, e_low_i[EDGE*S +: S]} + E_BITS'(!top_left);
      end
    end
  end

  // ---- PRODUCTS: E/w, exact but for the vertex's exponent
  logic [3*EXACT_BITS-1:0] exact;
  logic [EXACT_BITS-1:0] exact0, exact1, exact2;
  assign {exact2, exact1, exact0} = exact;
  for (genvar v = 0; v < 3; v++) begin : gen_products
    multiplier_pipelined #(
      .ABits(E_BITS + 1), .BBits(INVERSE_BITS + 1), .ProductBits(EXACT_BITS)
    ) u_exact (
      .clk_i, .enable_i(1'b1), .valid_i(valid_i[PRODUCTS +: M]),
      .a_i(signed'({1'b0, e_q[v*E_BITS +: E_BITS]})),
      .b_i(signed'({1'b0, inverse_w_i[v*INVERSE_BITS +: INVERSE_BITS]})), .addend_i('0),
      .product_o(exact[v*EXACT_BITS +: EXACT_BITS])
    );
  end

  // ---- LENGTHS: the units in which the greatest has PRODUCT_BITS bits
  localparam int unsigned TOP_BITS = SHIFT_BITS + 2;
  localparam logic signed [TOP_BITS-1:0] LEAST = {1'b1, {(TOP_BITS-1){1'b0}}};
  function automatic logic signed [TOP_BITS-1:0] bit_length(input logic [EXACT_BITS-1:0] value);
    bit_length = '0;
    for (int unsigned i = 0; i < EXACT_BITS; i++) begin
      if (value[i]) bit_length = TOP_BITS'(i + 1);
    end
  endfunction
  logic signed [TOP_BITS-1:0] shift0, shift1, shift2, length0, length1, length2, top01, top;
  assign shift0 = signed'({2'b0, inverse_w_shift_i[0 +: SHIFT_BITS]});
  assign shift1 = signed'({2'b0, inverse_w_shift_i[SHIFT_BITS +: SHIFT_BITS]});
  assign shift2 = signed'({2'b0, inverse_w_shift_i[2*SHIFT_BITS +: SHIFT_BITS]});
  always_comb begin
    {length0, length1, length2, top01, top} = 'x;
    if (valid_i[LENGTHS]) begin
      length0 = exact0 == '0 ? LEAST : bit_length(exact0) - shift0;
      length1 = exact1 == '0 ? LEAST : bit_length(exact1) - shift1;
      length2 = exact2 == '0 ? LEAST : bit_length(exact2) - shift2;
      top01 = length0 > length1 ? length0 : length1;
      top = top01 > length2 ? top01 : length2;
    end
  end

  // ---- CUT to these units. SUM
  function automatic logic [PRODUCT_BITS-1:0] cut(input logic [EXACT_BITS-1:0] value,
                                                  input logic signed [TOP_BITS-1:0] shift);
    cut = PRODUCT_BITS'({value, {PRODUCT_BITS{1'b0}}} >> unsigned'(shift));
  endfunction
  logic [EXACT_BITS-1:0] exact0_q, exact1_q, exact2_q;
  logic signed [TOP_BITS-1:0] cut0_q, cut1_q, cut2_q;
  logic [PRODUCT_BITS-1:0] product0_q, product1_q, product2_q, sum1_q, sum2_q;
  logic [SUM_BITS-1:0] sum_q;
  always_ff @(posedge clk_i) begin
    if (valid_i[LENGTHS]) begin
      {exact0_q, exact1_q, exact2_q} <= {exact0, exact1, exact2};
      {cut0_q, cut1_q, cut2_q} <= {top + shift0, top + shift1, top + shift2};
    end
    if (valid_i[CUT]) begin
      product0_q <= cut(exact0_q, cut0_q);
      product1_q <= cut(exact1_q, cut1_q);
      product2_q <= cut(exact2_q, cut2_q);
    end
    if (valid_i[SUM]) begin
      sum_q <= SUM_BITS'(product0_q) + SUM_BITS'(product1_q) + SUM_BITS'(product2_q);
      {sum1_q, sum2_q} <= {product1_q, product2_q};
    end
  end

  // ---- RECIPROCAL of the sum, beside two of the products
  logic [LENGTH_BITS-1:0] length;
  logic [K-1:0] mantissa;
  logic [PRODUCT_BITS-1:0] product1, product2;
  logic products_ready, products_valid;
  reciprocal_pipelined #(.Width(SUM_BITS), .LengthBits(LENGTH_BITS)) u_reciprocal (
    .clk_i, .rst_ni, .enable_i(1'b1),
    .valid_i(valid_i[RECIPROCAL]), .value_i(sum_q), .length_o(length), .mantissa_o(mantissa)
  );
  stream_fifo #(.Width(2*PRODUCT_BITS), .Depth(SHARES - RECIPROCAL + 1)) u_products (
    .clk_i, .rst_ni,
    .in_valid_i(valid_i[RECIPROCAL]), .in_ready_o(products_ready), .in_data_i({sum2_q, sum1_q}),
    .out_valid_o(products_valid), .out_ready_i(valid_i[SHARES]), .out_data_o({product2, product1})
  );

  // ---- SHARES of the sum, as products with its mantissa. WEIGHTS of vertices 1 and 2: shifted,
  // halves up, at most 1. The sum has PRODUCT_BITS bits or two more.
  localparam int unsigned SHARE_BITS = PRODUCT_BITS + K;
  localparam int unsigned SHARE_SHIFT_BITS = $clog2(K + SUM_BITS + 1);
  logic [SHARE_BITS-1:0] share1, share2;
  logic [LENGTH_BITS-1:0] share_length;
  logic [SHARE_SHIFT_BITS-1:0] share_shift;
  multiplier_pipelined #(
    .ABits(K + 1), .BBits(PRODUCT_BITS + 1), .ProductBits(SHARE_BITS)
  ) u_share1 (
    .clk_i, .enable_i(1'b1), .valid_i(valid_i[SHARES +: M]),
    .a_i(signed'({1'b0, mantissa})), .b_i(signed'({1'b0, product1})), .addend_i('0),
    .product_o(share1)
  );
  multiplier_pipelined #(
    .ABits(K + 1), .BBits(PRODUCT_BITS + 1), .ProductBits(SHARE_BITS)
  ) u_share2 (
    .clk_i, .enable_i(1'b1), .valid_i(valid_i[SHARES +: M]),
    .a_i(signed'({1'b0, mantissa})), .b_i(signed'({1'b0, product2})), .addend_i('0),
    .product_o(share2)
  );
  delay_line #(.Width(LENGTH_BITS), .Depth(M)) u_share_length (
    .clk_i, .enable_i(1'b1), .data_i(length), .data_o(share_length)
  );
  assign share_shift = SHARE_SHIFT_BITS'(share_length) + SHARE_SHIFT_BITS'(K) -
                       SHARE_SHIFT_BITS'(PRODUCT_BITS);
  function automatic logic [WEIGHT_BITS-1:0] weight(input logic [SHARE_BITS-1:0] share,
                                                    input logic [SHARE_SHIFT_BITS-1:0] shift);
    logic [PRODUCT_BITS:0] shifted, rounded;
    shifted = (PRODUCT_BITS+1)'(share >> shift);
    rounded = (shifted + (PRODUCT_BITS+1)'(1)) >> 1;
    weight = rounded > (PRODUCT_BITS+1)'(1 << F) ? WEIGHT_BITS'(1 << F)
                                                 : rounded[WEIGHT_BITS-1:0];
  endfunction
  logic [WEIGHT_BITS-1:0] weight1_q, weight2_q;
  always_ff @(posedge clk_i) begin
    if (valid_i[WEIGHTS]) begin
      weight1_q <= weight(share1, share_shift);
      weight2_q <= weight(share2, share_shift);
    end
  end

  // ---- TERMS: a0 + 1/2 + g1*(a1 - a0), and g2*(a2 - a0). LAST: attributes
  localparam int unsigned TERM_BITS = ATTR_BITS + F + 3;
  for (genvar n = 0; n < ATTRIBUTES; n++) begin : gen_attributes
    logic [ATTR_BITS-1:0] a0, a1, a2;
    logic signed [ATTR_BITS:0] d1, d2;
    logic signed [TERM_BITS-1:0] term1, term2, value;
    assign a0 = vertex_attr_i[n*ATTR_BITS +: ATTR_BITS];
    assign a1 = vertex_attr_i[(ATTRIBUTES+n)*ATTR_BITS +: ATTR_BITS];
    assign a2 = vertex_attr_i[(2*ATTRIBUTES+n)*ATTR_BITS +: ATTR_BITS];
    assign d1 = signed'({1'b0, a1}) - signed'({1'b0, a0});
    assign d2 = signed'({1'b0, a2}) - signed'({1'b0, a0});
    multiplier_pipelined #(
      .ABits(WEIGHT_BITS + 1), .BBits(ATTR_BITS + 1), .ProductBits(TERM_BITS)
    ) u_term1 (
      .clk_i, .enable_i(1'b1), .valid_i(valid_i[TERMS +: M]),
      .a_i(signed'({1'b0, weight1_q})), .b_i(d1),
      .addend_i((TERM_BITS'(a0) << F) + TERM_BITS'(1 << (F - 1))), .product_o(term1)
    );
    multiplier_pipelined #(
      .ABits(WEIGHT_BITS + 1), .BBits(ATTR_BITS + 1), .ProductBits(TERM_BITS)
    ) u_term2 (
      .clk_i, .enable_i(1'b1), .valid_i(valid_i[TERMS +: M]),
      .a_i(signed'({1'b0, weight2_q})), .b_i(d2), .addend_i('0), .product_o(term2)
    );
    always_comb begin
      value = '0;
      attr_o[n*ATTR_BITS +: ATTR_BITS] = '0;
      if (valid_i[LAST]) begin
        value = term1 + term2;
        if (value < 0) attr_o[n*ATTR_BITS +: ATTR_BITS] = '0;
        else if (value[TERM_BITS-1:F+ATTR_BITS] != '0) attr_o[n*ATTR_BITS +: ATTR_BITS] = '1;
        else attr_o[n*ATTR_BITS +: ATTR_BITS] = value[F +: ATTR_BITS];
      end
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!valid_i[RECIPROCAL] || products_ready) else $error("products find their FIFO full");
      assert (!valid_i[SHARES] || products_valid) else $error("a reciprocal without products");
    end
  end
`endif
endmodule
`endif
