// One sample's attributes, corrected by perspective: weights from E/w.
//
// Bits     core::perspective_attributes() defines them.
// In       valid_i: a sample in each stage, 0 = about to enter. In stage 0 the edges at the stamp's
//          first sample; in stage 1 inverse_w_i; in stage 2 its exponents; in the last the
//          vertices' attributes, all the same for the samples of a stamp.
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
  localparam int unsigned LAST = pineda_pkg::ATTRIBUTE_CYCLES - 1;

  // ---- Stage 1: E of each edge. Vertex v has that of the opposite one, (v + 1) % 3.
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

  // ---- Stage 2: E/w, exact but for the vertex's exponent
  logic [3*EXACT_BITS-1:0] exact_q;
  always_ff @(posedge clk_i) begin
    if (valid_i[1]) begin
      for (int unsigned v = 0; v < 3; v++) begin
        exact_q[v*EXACT_BITS +: EXACT_BITS] <=
            EXACT_BITS'(e_q[v*E_BITS +: E_BITS]) *
            EXACT_BITS'(inverse_w_i[v*INVERSE_BITS +: INVERSE_BITS]);
      end
    end
  end

  // ---- Stage 3: cut to the units in which the greatest has PRODUCT_BITS bits
  localparam int unsigned TOP_BITS = SHIFT_BITS + 2;
  localparam logic signed [TOP_BITS-1:0] LEAST = {1'b1, {(TOP_BITS-1){1'b0}}};
  function automatic logic signed [TOP_BITS-1:0] bit_length(input logic [EXACT_BITS-1:0] value);
    bit_length = '0;
    for (int unsigned i = 0; i < EXACT_BITS; i++) begin
      if (value[i]) bit_length = TOP_BITS'(i + 1);
    end
  endfunction
  function automatic logic [PRODUCT_BITS-1:0] cut(input logic [EXACT_BITS-1:0] exact,
                                                  input logic signed [TOP_BITS-1:0] shift);
    cut = PRODUCT_BITS'({exact, {PRODUCT_BITS{1'b0}}} >> unsigned'(shift));
  endfunction

  logic signed [TOP_BITS-1:0] shift0, shift1, shift2, length0, length1, length2, top01, top;
  logic [EXACT_BITS-1:0] exact0, exact1, exact2;
  logic [PRODUCT_BITS-1:0] product0_q, product1_q, product2_q;
  assign {exact2, exact1, exact0} = exact_q;
  assign shift0 = signed'({2'b0, inverse_w_shift_i[0 +: SHIFT_BITS]});
  assign shift1 = signed'({2'b0, inverse_w_shift_i[SHIFT_BITS +: SHIFT_BITS]});
  assign shift2 = signed'({2'b0, inverse_w_shift_i[2*SHIFT_BITS +: SHIFT_BITS]});
  always_comb begin
    {length0, length1, length2, top01, top} = 'x;
    if (valid_i[2]) begin
      length0 = exact0 == '0 ? LEAST : bit_length(exact0) - shift0;
      length1 = exact1 == '0 ? LEAST : bit_length(exact1) - shift1;
      length2 = exact2 == '0 ? LEAST : bit_length(exact2) - shift2;
      top01 = length0 > length1 ? length0 : length1;
      top = top01 > length2 ? top01 : length2;
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_i[2]) begin
      product0_q <= cut(exact0, top + shift0);
      product1_q <= cut(exact1, top + shift1);
      product2_q <= cut(exact2, top + shift2);
    end
  end

  // ---- Then the reciprocal of their sum, beside two of the products
  logic [SUM_BITS-1:0] sum;
  logic [LENGTH_BITS-1:0] length;
  logic [K-1:0] mantissa;
  logic [PRODUCT_BITS-1:0] product1, product2;
  logic products_ready, products_valid;
  assign sum = SUM_BITS'(product0_q) + SUM_BITS'(product1_q) + SUM_BITS'(product2_q);
  reciprocal_pipelined #(.Width(SUM_BITS), .LengthBits(LENGTH_BITS)) u_reciprocal (
    .clk_i, .rst_ni, .enable_i(1'b1),
    .valid_i(valid_i[3]), .value_i(sum), .length_o(length), .mantissa_o(mantissa)
  );
  stream_fifo #(.Width(2*PRODUCT_BITS), .Depth(LAST-3)) u_products (
    .clk_i, .rst_ni,
    .in_valid_i(valid_i[3]), .in_ready_o(products_ready), .in_data_i({product2_q, product1_q}),
    .out_valid_o(products_valid), .out_ready_i(valid_i[LAST-1]), .out_data_o({product2, product1})
  );

  // ---- The last stage: weights of vertices 1 and 2, halves up, at most 1. The sum has
  // PRODUCT_BITS bits or two more.
  localparam int unsigned SHARE_SHIFT_BITS = $clog2(K + SUM_BITS + 1);
  logic [SHARE_SHIFT_BITS-1:0] share_shift;
  assign share_shift = SHARE_SHIFT_BITS'(length) + SHARE_SHIFT_BITS'(K) -
                       SHARE_SHIFT_BITS'(PRODUCT_BITS);
  function automatic logic [WEIGHT_BITS-1:0] weight(input logic [PRODUCT_BITS-1:0] product);
    logic [PRODUCT_BITS:0] share, rounded;
    share = (PRODUCT_BITS+1)'(((PRODUCT_BITS+K)'(product) * (PRODUCT_BITS+K)'(mantissa)) >>
                              share_shift);
    rounded = (share + (PRODUCT_BITS+1)'(1)) >> 1;
    weight = rounded > (PRODUCT_BITS+1)'(1 << F) ? WEIGHT_BITS'(1 << F)
                                                 : rounded[WEIGHT_BITS-1:0];
  endfunction
  logic [WEIGHT_BITS-1:0] weight1_q, weight2_q;
  always_ff @(posedge clk_i) begin
    if (valid_i[LAST-1]) begin
      weight1_q <= weight(product1);
      weight2_q <= weight(product2);
    end
  end

  // ---- Attributes: a0 + g1*(a1 - a0) + g2*(a2 - a0)
  localparam int unsigned VALUE_BITS = ATTR_BITS + F + 3;
  function automatic logic [ATTR_BITS-1:0] code(input logic [ATTR_BITS-1:0] a0,
                                                input logic [ATTR_BITS-1:0] a1,
                                                input logic [ATTR_BITS-1:0] a2);
    logic signed [VALUE_BITS-1:0] value;
    logic signed [VALUE_BITS-F:0] rounded;
    value = (VALUE_BITS'(a0) << F) +
            VALUE_BITS'(weight1_q) * (VALUE_BITS'(a1) - VALUE_BITS'(a0)) +
            VALUE_BITS'(weight2_q) * (VALUE_BITS'(a2) - VALUE_BITS'(a0));
    rounded = (VALUE_BITS-F+1)'(signed'(value[VALUE_BITS-1:F])) +
              (VALUE_BITS-F+1)'(signed'({1'b0, value[F-1]}));
    if (rounded < 0) code = '0;
    else if (rounded[VALUE_BITS-F:ATTR_BITS] != '0) code = '1;
    else code = rounded[ATTR_BITS-1:0];
  endfunction
  always_comb begin
    attr_o = '0;
    if (valid_i[LAST]) begin
      for (int unsigned n = 0; n < ATTRIBUTES; n++) begin
        attr_o[n*ATTR_BITS +: ATTR_BITS] =
            code(vertex_attr_i[n*ATTR_BITS +: ATTR_BITS],
                 vertex_attr_i[(ATTRIBUTES+n)*ATTR_BITS +: ATTR_BITS],
                 vertex_attr_i[(2*ATTRIBUTES+n)*ATTR_BITS +: ATTR_BITS]);
      end
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!valid_i[3] || products_ready) else $error("products find their FIFO full");
      assert (!valid_i[LAST-1] || products_valid) else $error("a reciprocal without products");
    end
  end
`endif
endmodule
`endif
