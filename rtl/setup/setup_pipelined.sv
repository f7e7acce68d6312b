// Triangle setup as a pipeline: every product has its own multiplier.
//
// Bits     core::setup() defines every output bit.
// In, Out  as setup_unit.
// Rate     1 triangle a cycle, dropped or not. Back-pressure freezes the whole unit.
// Drops    as setup_unit; in the cycle DROP after the triangle came.
// Twin     model/core/setup.cpp.
`ifdef PINEDA_SETUP_PIPELINED
module setup_pipelined (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pineda_pkg::frame_t       frame_i,

  input  logic                     tri_valid_i,
  output logic                     tri_ready_o,
  input  pineda_pkg::triangle_t    tri_i,

  output logic                     prim_valid_o,
  input  logic                     prim_ready_i,
  output pineda_pkg::setup_prim_t  prim_o,

  output logic                     working_o, // no triangle can be taken, since one was
  output logic                     idle_o
);
  localparam int unsigned COORD_BITS = pineda_pkg::COORD_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned AREA2_BITS = pineda_pkg::AREA2_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
  localparam int unsigned LATENCY = pineda_pkg::SETUP_LATENCY_CYCLES;

  // ---- Control: valid_q[n]: a triangle came n cycles ago. Names in capitals below are such n; a
  // product takes M cycles.
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;
  localparam int unsigned DROP = 3 + M;
  localparam int unsigned OFFSETS = DROP + 1;
  localparam int unsigned PRODUCTS = OFFSETS + 1; // of the edges
  localparam int unsigned EDGES = PRODUCTS + M + 1;
  logic [LATENCY:1] valid_q;
  logic advance;
  logic drop;
  assign advance = !(valid_q[LATENCY] && !prim_ready_i);
  assign tri_ready_o = advance;
  assign prim_valid_o = valid_q[LATENCY];
  assign working_o = 1'b0;
  assign idle_o = valid_q == '0;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (advance) begin
      valid_q <= {valid_q[LATENCY-1:DROP+1], valid_q[DROP] && !drop, valid_q[DROP-1:1],
                  tri_valid_i};
    end
  end

  // ---- 1: differences, extremes, anchor
  pineda_pkg::triangle_t tri1_q, tri_drop;
  logic signed [COEFF_BITS-1:0] dx1_1, dy1_1, dx2_1, dy2_1, dx1_2q, dy1_2q, dx2_2q, dy2_2q;
  setup_differences u_raw (
    .x_i(tri1_q.x), .y_i(tri1_q.y), .dx1_o(dx1_1), .dy1_o(dy1_1), .dx2_o(dx2_1), .dy2_o(dy2_1)
  );
  logic [1:0] anchor1, anchor_drop;
  logic signed [COORD_BITS-1:0] x_low1, x_high1, y_low1, y_high1;
  logic signed [COORD_BITS-1:0] x_low2_q, x_high2_q, y_low2_q, y_high2_q;
  setup_extremes u_extremes (
    .x_i(tri1_q.x), .y_i(tri1_q.y), .anchor_o(anchor1),
    .x_low_o(x_low1), .x_high_o(x_high1), .y_low_o(y_low1), .y_high_o(y_high1)
  );
  delay_line #(.Width(pineda_pkg::TRIANGLE_BITS), .Depth(DROP - 1)) u_tri_drop (
    .clk_i, .enable_i(advance), .data_i(tri1_q), .data_o(tri_drop)
  );
  delay_line #(.Width(2), .Depth(DROP - 1)) u_anchor_drop (
    .clk_i, .enable_i(advance), .data_i(anchor1), .data_o(anchor_drop)
  );

  // ---- 2: products of the area, box. Then the area
  logic signed [AREA2_BITS-1:0] product12, product21, area2_q;
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product12 (
    .clk_i, .enable_i(advance), .valid_i(valid_q[2 +: M]),
    .a_i(dx1_2q), .b_i(dy2_2q), .addend_i('0), .product_o(product12)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product21 (
    .clk_i, .enable_i(advance), .valid_i(valid_q[2 +: M]),
    .a_i(dx2_2q), .b_i(dy1_2q), .addend_i('0), .product_o(product21)
  );
  logic empty2, empty_drop;
  logic [4*PIXEL_BITS-1:0] box2, box_drop;
  setup_box u_box (
    .frame_i, .x_low_i(x_low2_q), .x_high_i(x_high2_q), .y_low_i(y_low2_q), .y_high_i(y_high2_q),
    .empty_o(empty2), .box_o(box2)
  );
  delay_line #(.Width(4*PIXEL_BITS+1), .Depth(DROP - 2)) u_box_drop (
    .clk_i, .enable_i(advance), .data_i({empty2, box2}), .data_o({empty_drop, box_drop})
  );

  // ---- DROP: drop, or canonical order
  logic clockwise;
  logic [AREA2_BITS-2:0] abs_area2, abs_area2_q;
`ifdef PINEDA_COUNTERS
  logic no_sample;
  delay_line #(.Width(1), .Depth(DROP - 2)) u_no_sample (
    .clk_i, .enable_i(advance), .data_i(u_box.u_x.no_sample || u_box.u_y.no_sample),
    .data_o(no_sample)
  );
`endif
  setup_drop u_drop (
`ifdef PINEDA_COUNTERS
    .clk_i, .count_i(advance && valid_q[DROP]), .no_sample_i(no_sample),
`endif
    .frame_i, .area2_i(area2_q), .empty_i(empty_drop),
    .drop_o(drop), .clockwise_o(clockwise), .abs_area2_o(abs_area2)
  );
  pineda_pkg::triangle_t canonical, canonical_q, canonical_products_q, canonical_edges;
  setup_canonical u_canonical (
    .valid_i(1'b1),
    .frame_i, .tri_i(tri_drop), .anchor_i(anchor_drop), .clockwise_i(clockwise), .tri_o(canonical)
  );

  // ---- OFFSETS: differences from the anchor, the first sample from the anchor; reciprocal starts
  localparam int unsigned OFFSETS_BITS = 6 * COEFF_BITS;
  logic [4*PIXEL_BITS-1:0] box_q;
  logic signed [COEFF_BITS-1:0] dx1_next, dy1_next, dx2_next, dy2_next, ref_x_next, ref_y_next;
  logic signed [COEFF_BITS-1:0] dx1, dy1, dx2, dy2, ref_x, ref_y;
  logic [OFFSETS_BITS-1:0] offsets_q;
  setup_differences u_differences (
    .x_i(canonical_q.x), .y_i(canonical_q.y),
    .dx1_o(dx1_next), .dy1_o(dy1_next), .dx2_o(dx2_next), .dy2_o(dy2_next)
  );
  setup_reference u_reference (
    .x_i(canonical_q.x[COORD_BITS-1:0]), .y_i(canonical_q.y[COORD_BITS-1:0]),
    .box_i(box_q[2*PIXEL_BITS-1:0]), .ref_x_o(ref_x_next), .ref_y_o(ref_y_next)
  );
  assign {dx1, dy1, dx2, dy2, ref_x, ref_y} = offsets_q;

  // ---- PRODUCTS: E of edges 0 and 2 from the anchor, which lies on both
  logic signed [AREA2_BITS-1:0] product_a, product_b, product_c, product_d, e0_q, e2_q;
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product_a (
    .clk_i, .enable_i(advance), .valid_i(valid_q[PRODUCTS +: M]),
    .a_i(dx1), .b_i(ref_y), .addend_i('0), .product_o(product_a)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product_b (
    .clk_i, .enable_i(advance), .valid_i(valid_q[PRODUCTS +: M]),
    .a_i(dy1), .b_i(ref_x), .addend_i('0), .product_o(product_b)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product_c (
    .clk_i, .enable_i(advance), .valid_i(valid_q[PRODUCTS +: M]),
    .a_i(dy2), .b_i(ref_x), .addend_i('0), .product_o(product_c)
  );
  multiplier_pipelined #(
    .ABits(COEFF_BITS), .BBits(COEFF_BITS), .ProductBits(AREA2_BITS)
  ) u_product_d (
    .clk_i, .enable_i(advance), .valid_i(valid_q[PRODUCTS +: M]),
    .a_i(dx2), .b_i(ref_y), .addend_i('0), .product_o(product_d)
  );

  always_ff @(posedge clk_i) begin
    if (advance) begin
      tri1_q <= tri_i;
      {dx1_2q, dy1_2q, dx2_2q, dy2_2q} <= {dx1_1, dy1_1, dx2_1, dy2_1};
      {x_low2_q, x_high2_q, y_low2_q, y_high2_q} <= {x_low1, x_high1, y_low1, y_high1};
      area2_q <= product12 - product21;
      canonical_q <= canonical;
      abs_area2_q <= abs_area2;
      box_q <= box_drop;
      canonical_products_q <= canonical_q;
      offsets_q <= {dx1_next, dy1_next, dx2_next, dy2_next, ref_x_next, ref_y_next};
      e0_q <= product_a - product_b;
      e2_q <= product_c - product_d;
    end
  end

  // ---- EDGES: the edges
  logic signed [COEFF_BITS-1:0] dx1_edges, dy1_edges, dx2_edges, dy2_edges;
  logic [AREA2_BITS-2:0] abs_area2_edges;
  logic [4*PIXEL_BITS-1:0] box_edges;
  delay_line #(
    .Width(pineda_pkg::TRIANGLE_BITS + 4*COEFF_BITS), .Depth(EDGES - PRODUCTS)
  ) u_offsets_edges (
    .clk_i, .enable_i(advance), .data_i({canonical_products_q, dx1, dy1, dx2, dy2}),
    .data_o({canonical_edges, dx1_edges, dy1_edges, dx2_edges, dy2_edges})
  );
  delay_line #(.Width(AREA2_BITS - 1 + 4*PIXEL_BITS), .Depth(EDGES - OFFSETS)) u_area_edges (
    .clk_i, .enable_i(advance), .data_i({abs_area2_q, box_q}),
    .data_o({abs_area2_edges, box_edges})
  );
  pineda_pkg::setup_prim_t edges, with_edges, prim;
  setup_edges u_edges (
    .valid_i(1'b1),
    .tri_i(canonical_edges), .box_i(box_edges),
    .dx1_i(dx1_edges), .dy1_i(dy1_edges), .dx2_i(dx2_edges), .dy2_i(dy2_edges),
    .area2_i(abs_area2_edges), .e0_i(e0_q), .e2_i(e2_q), .prim_i('0), .prim_o(edges)
  );
  delay_line #(
    .Width(pineda_pkg::SETUP_PRIM_BITS), .Depth(LATENCY - 1 - EDGES)
  ) u_with_edges (
    .clk_i, .enable_i(advance), .data_i(edges), .data_o(with_edges)
  );

  // ---- The planes, all at once
`ifdef PINEDA_PLANES
  localparam int unsigned START = pineda_pkg::SETUP_PLANES_STEP;
  setup_parallel_planes u_planes (
    .clk_i, .rst_ni, .enable_i(advance),
`ifdef PINEDA_DEPTH
    .frame_i,
`endif
    .area2_valid_i(valid_q[OFFSETS]), .area2_i(abs_area2_q), .valid_i(valid_q[LATENCY-2:START]),
    .tri_i(canonical_products_q),
    .dx1_i(dx1), .dy1_i(dy1), .dx2_i(dx2), .dy2_i(dy2), .ref_x_i(ref_x), .ref_y_i(ref_y),
    .prim_i(with_edges), .prim_o(prim)
  );
`else
  assign prim = with_edges;
`endif

  pineda_pkg::setup_prim_t prim_q;
  always_ff @(posedge clk_i) begin
    if (advance) prim_q <= prim;
  end
  assign prim_o = prim_q;
endmodule
`endif
