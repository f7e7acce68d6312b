// Triangle setup as a pipeline: every product has its own multiplier.
//
// Bits     core::setup() defines every output bit.
// In, Out  as setup_unit.
// Rate     1 triangle a cycle, dropped or not. Latency SETUP_PLANES_STEP + 8 cycles, 9 without
//          planes. Back-pressure freezes the whole unit.
// Drops    as setup_unit; in the cycle 4 after the triangle came.
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

  // ---- Control: valid_q[n]: a triangle came n cycles ago. A number in a name below is that n.
  logic [LATENCY:1] valid_q;
  logic advance;
  logic drop4;
  assign advance = !(valid_q[LATENCY] && !prim_ready_i);
  assign tri_ready_o = advance;
  assign prim_valid_o = valid_q[LATENCY];
  assign working_o = 1'b0;
  assign idle_o = valid_q == '0;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (advance) begin
      valid_q <= {valid_q[LATENCY-1:5], valid_q[4] && !drop4, valid_q[3:1], tri_valid_i};
    end
  end

  // ---- 1: differences, extremes, anchor
  pineda_pkg::triangle_t tri1_q, tri4;
  logic signed [COEFF_BITS-1:0] dx1_1, dy1_1, dx2_1, dy2_1, dx1_2q, dy1_2q, dx2_2q, dy2_2q;
  setup_differences u_raw (
    .x_i(tri1_q.x), .y_i(tri1_q.y), .dx1_o(dx1_1), .dy1_o(dy1_1), .dx2_o(dx2_1), .dy2_o(dy2_1)
  );
  logic [1:0] anchor1, anchor4;
  logic signed [COORD_BITS-1:0] x_low1, x_high1, y_low1, y_high1;
  logic signed [COORD_BITS-1:0] x_low2_q, x_high2_q, y_low2_q, y_high2_q;
  setup_extremes u_extremes (
    .x_i(tri1_q.x), .y_i(tri1_q.y), .anchor_o(anchor1),
    .x_low_o(x_low1), .x_high_o(x_high1), .y_low_o(y_low1), .y_high_o(y_high1)
  );
  delay_line #(.Width(pineda_pkg::TRIANGLE_BITS), .Depth(3)) u_tri4 (
    .clk_i, .enable_i(advance), .data_i(tri1_q), .data_o(tri4)
  );
  delay_line #(.Width(2), .Depth(3)) u_anchor4 (
    .clk_i, .enable_i(advance), .data_i(anchor1), .data_o(anchor4)
  );

  // ---- 2: products of the area, box. 3: area
  logic signed [AREA2_BITS-1:0] product12_3q, product21_3q, area2_4q;
  logic empty2, empty4;
  logic [4*PIXEL_BITS-1:0] box2, box4;
  setup_box u_box (
    .frame_i, .x_low_i(x_low2_q), .x_high_i(x_high2_q), .y_low_i(y_low2_q), .y_high_i(y_high2_q),
    .empty_o(empty2), .box_o(box2)
  );
  delay_line #(.Width(4*PIXEL_BITS+1), .Depth(2)) u_box4 (
    .clk_i, .enable_i(advance), .data_i({empty2, box2}), .data_o({empty4, box4})
  );

  // ---- 4: drop, or canonical order
  logic clockwise4;
  logic [AREA2_BITS-2:0] abs_area2_4, abs_area2_5q;
`ifdef PINEDA_COUNTERS
  logic no_sample4;
  delay_line #(.Width(1), .Depth(2)) u_no_sample4 (
    .clk_i, .enable_i(advance), .data_i(u_box.u_x.no_sample || u_box.u_y.no_sample),
    .data_o(no_sample4)
  );
`endif
  setup_drop u_drop (
`ifdef PINEDA_COUNTERS
    .clk_i, .count_i(advance && valid_q[4]), .no_sample_i(no_sample4),
`endif
    .frame_i, .area2_i(area2_4q), .empty_i(empty4),
    .drop_o(drop4), .clockwise_o(clockwise4), .abs_area2_o(abs_area2_4)
  );
  pineda_pkg::triangle_t canonical4, canonical5_q, canonical6_q, canonical8;
  setup_canonical u_canonical (
    .valid_i(1'b1),
    .frame_i, .tri_i(tri4), .anchor_i(anchor4), .clockwise_i(clockwise4), .tri_o(canonical4)
  );

  // ---- 5: differences from the anchor, the first sample from the anchor; reciprocal starts
  localparam int unsigned OFFSETS_BITS = 6 * COEFF_BITS;
  logic [4*PIXEL_BITS-1:0] box5_q;
  logic signed [COEFF_BITS-1:0] dx1_5, dy1_5, dx2_5, dy2_5, ref_x5, ref_y5;
  logic signed [COEFF_BITS-1:0] dx1_6, dy1_6, dx2_6, dy2_6, ref_x6, ref_y6;
  logic [OFFSETS_BITS-1:0] offsets6_q;
  setup_differences u_differences (
    .x_i(canonical5_q.x), .y_i(canonical5_q.y),
    .dx1_o(dx1_5), .dy1_o(dy1_5), .dx2_o(dx2_5), .dy2_o(dy2_5)
  );
  setup_reference u_reference (
    .x_i(canonical5_q.x[COORD_BITS-1:0]), .y_i(canonical5_q.y[COORD_BITS-1:0]),
    .box_i(box5_q[2*PIXEL_BITS-1:0]), .ref_x_o(ref_x5), .ref_y_o(ref_y5)
  );
  assign {dx1_6, dy1_6, dx2_6, dy2_6, ref_x6, ref_y6} = offsets6_q;

  // ---- 6, 7: E of edges 0 and 2 from the anchor, which lies on both
  logic signed [AREA2_BITS-1:0] product_a7_q, product_b7_q, product_c7_q, product_d7_q;
  logic signed [AREA2_BITS-1:0] e0_8q, e2_8q;

  logic signed [2*COEFF_BITS-1:0] product12_3, product21_3;
  logic signed [2*COEFF_BITS-1:0] product_a7, product_b7, product_c7, product_d7;
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product12_3 (
    .a_i(dx1_2q), .b_i(dy2_2q), .addend_i('0), .product_o(product12_3)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product21_3 (
    .a_i(dx2_2q), .b_i(dy1_2q), .addend_i('0), .product_o(product21_3)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product_a7 (
    .a_i(dx1_6), .b_i(ref_y6), .addend_i('0), .product_o(product_a7)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product_b7 (
    .a_i(dy1_6), .b_i(ref_x6), .addend_i('0), .product_o(product_b7)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product_c7 (
    .a_i(dy2_6), .b_i(ref_x6), .addend_i('0), .product_o(product_c7)
  );
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product_d7 (
    .a_i(dx2_6), .b_i(ref_y6), .addend_i('0), .product_o(product_d7)
  );

  always_ff @(posedge clk_i) begin
    if (advance) begin
      tri1_q <= tri_i;
      {dx1_2q, dy1_2q, dx2_2q, dy2_2q} <= {dx1_1, dy1_1, dx2_1, dy2_1};
      {x_low2_q, x_high2_q, y_low2_q, y_high2_q} <= {x_low1, x_high1, y_low1, y_high1};
      product12_3q <= AREA2_BITS'(product12_3);
      product21_3q <= AREA2_BITS'(product21_3);
      area2_4q <= product12_3q - product21_3q;
      canonical5_q <= canonical4;
      abs_area2_5q <= abs_area2_4;
      box5_q <= box4;
      canonical6_q <= canonical5_q;
      offsets6_q <= {dx1_5, dy1_5, dx2_5, dy2_5, ref_x5, ref_y5};
      product_a7_q <= AREA2_BITS'(product_a7);
      product_b7_q <= AREA2_BITS'(product_b7);
      product_c7_q <= AREA2_BITS'(product_c7);
      product_d7_q <= AREA2_BITS'(product_d7);
      e0_8q <= product_a7_q - product_b7_q;
      e2_8q <= product_c7_q - product_d7_q;
    end
  end

  // ---- 8: the edges
  logic signed [COEFF_BITS-1:0] dx1_8, dy1_8, dx2_8, dy2_8;
  logic [AREA2_BITS-2:0] abs_area2_8;
  logic [4*PIXEL_BITS-1:0] box8;
  delay_line #(.Width(pineda_pkg::TRIANGLE_BITS + 4*COEFF_BITS), .Depth(2)) u_offsets8 (
    .clk_i, .enable_i(advance), .data_i({canonical6_q, dx1_6, dy1_6, dx2_6, dy2_6}),
    .data_o({canonical8, dx1_8, dy1_8, dx2_8, dy2_8})
  );
  delay_line #(.Width(AREA2_BITS - 1 + 4*PIXEL_BITS), .Depth(3)) u_area8 (
    .clk_i, .enable_i(advance), .data_i({abs_area2_5q, box5_q}), .data_o({abs_area2_8, box8})
  );
  pineda_pkg::setup_prim_t with_edges8, with_edges, prim;
  setup_edges u_edges (
    .valid_i(1'b1),
    .tri_i(canonical8), .box_i(box8),
    .dx1_i(dx1_8), .dy1_i(dy1_8), .dx2_i(dx2_8), .dy2_i(dy2_8),
    .area2_i(abs_area2_8), .e0_i(e0_8q), .e2_i(e2_8q), .prim_i('0), .prim_o(with_edges8)
  );
  delay_line #(.Width(pineda_pkg::SETUP_PRIM_BITS), .Depth(LATENCY - 9)) u_edges_out (
    .clk_i, .enable_i(advance), .data_i(with_edges8), .data_o(with_edges)
  );

  // ---- The planes, all at once
`ifdef PINEDA_PLANES
  setup_parallel_planes u_planes (
    .clk_i, .rst_ni, .enable_i(advance),
`ifdef PINEDA_DEPTH
    .frame_i,
`endif
    .area2_valid_i(valid_q[5]), .area2_i(abs_area2_5q), .valid_i(valid_q[LATENCY-2:LATENCY-8]),
    .tri_i(canonical6_q),
    .dx1_i(dx1_6), .dy1_i(dy1_6), .dx2_i(dx2_6), .dy2_i(dy2_6), .ref_x_i(ref_x6), .ref_y_i(ref_y6),
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
