// Triangle setup with shared multipliers: one for area and edges, eight for the planes, which pass
// through one pipeline.
//
// Bits     core::setup() defines every output bit.
// In, Out  as setup_unit.
// Rate     1 triangle every SETUP_INTERVAL_CYCLES. While any is inside, the next one comes a multiple
//          of these later; a dropped one is inside for 6 cycles. Back-pressure freezes the whole unit.
// Drops    as setup_unit.
// Twin     model/core/setup.cpp.
`ifdef PINEDA_SETUP_STEPPED
module setup_stepped (
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
  localparam int unsigned I = pineda_pkg::SETUP_INTERVAL_CYCLES;
  localparam int unsigned PHASE_BITS = $clog2(I);

  // ---- Control. step[n]: a triangle came n cycles ago. Triangles come multiples of I cycles apart,
  // so what happens in steps that differ by no such multiple can share a multiplier. A register
  // that is written in step n holds its value in steps n + 1 to n + I, and what is needed for longer
  // moves on to another register, whose name has the next higher number.
  logic [LATENCY:0] step;
  logic [LATENCY:1] step_q;
  logic [PHASE_BITS-1:0] phase_q; // cycles until a triangle can be taken
  logic working_q;                // one was taken in phase 0
  logic advance, drop;
  assign advance = !(step_q[LATENCY] && !prim_ready_i);
  // LATENCY is no multiple of I, so no turn is lost by this, and no path leads from ready to ready.
  assign tri_ready_o = !step_q[LATENCY] && (phase_q == '0 || step_q == '0);
  assign working_o = working_q && phase_q != '0;
  assign step = {step_q, tri_valid_i && tri_ready_o};
  assign prim_valid_o = step_q[LATENCY];
  assign idle_o = step_q == '0;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
      phase_q <= '0;
      working_q <= 1'b0;
    end else if (advance) begin
      step_q <= {step[LATENCY-1:6], step[5] && !drop, step[4:0]};
      if (step[0] || phase_q == '0) begin
        phase_q <= PHASE_BITS'(I - 1);
        working_q <= step[0];
      end else begin
        phase_q <= phase_q - PHASE_BITS'(1);
        if (step[5] && drop) working_q <= 1'b0;
      end
    end
  end

  // ---- The multiplier: two products for the area in steps 2 and 3, two for each of two edges in
  // steps that these leave free. Its factors are chosen in the step before; a step after the second
  // product of a pair both are there.
  localparam int unsigned EDGE0 = 2 * I + 4;
  localparam int unsigned EDGE1 = 2 * I + 5;
  localparam int unsigned EDGE2 = 2 * I + 6;
  localparam int unsigned EDGE3 = 2 * I + 7;
  logic signed [COEFF_BITS-1:0] factor_a, factor_b, factor_a_q, factor_b_q;
  logic signed [2*COEFF_BITS-1:0] product;
  logic signed [AREA2_BITS-1:0] first_q, second_q, difference;
  multiplier #(.ABits(COEFF_BITS), .BBits(COEFF_BITS)) u_product (
    .a_i(factor_a_q), .b_i(factor_b_q), .addend_i('0), .product_o(product)
  );
  always_ff @(posedge clk_i) begin
    if (advance) begin
      {factor_a_q, factor_b_q} <= {factor_a, factor_b};
      {first_q, second_q} <= {second_q, AREA2_BITS'(product)};
    end
  end
  assign difference = first_q - second_q;

  // ---- Steps 0 to 4: the triangle; its box, its doubled area
  pineda_pkg::triangle_t tri_q;
  logic signed [COEFF_BITS-1:0] raw_dx1, raw_dy1, raw_dx2, raw_dy2;
  setup_differences u_raw (
    .x_i(tri_q.x), .y_i(tri_q.y),
    .dx1_o(raw_dx1), .dy1_o(raw_dy1), .dx2_o(raw_dx2), .dy2_o(raw_dy2)
  );
  logic [1:0] anchor, anchor_q;
  logic signed [COORD_BITS-1:0] x_low, x_high, y_low, y_high;
  setup_extremes u_extremes (
    .x_i(tri_q.x), .y_i(tri_q.y), .anchor_o(anchor),
    .x_low_o(x_low), .x_high_o(x_high), .y_low_o(y_low), .y_high_o(y_high)
  );

  logic empty, empty_q;
  logic [4*PIXEL_BITS-1:0] box, box_q, box2_q, box3_q, box4_q;
  setup_box u_box (
    .frame_i, .x_low_i(x_low), .x_high_i(x_high), .y_low_i(y_low), .y_high_i(y_high),
    .empty_o(empty), .box_o(box)
  );
  logic signed [AREA2_BITS-1:0] area2_q;

  // ---- Step 5: drop, or canonical order
  logic clockwise;
  logic [AREA2_BITS-2:0] abs_area2, area2_2q, area2_3q, area2_4q;
  setup_drop u_drop (
`ifdef PINEDA_COUNTERS
    // The triangle is still there.
    .clk_i, .count_i(advance && step[5]),
    .no_sample_i(u_box.u_x.no_sample || u_box.u_y.no_sample),
`endif
    .frame_i, .area2_i(area2_q), .empty_i(empty_q),
    .drop_o(drop), .clockwise_o(clockwise), .abs_area2_o(abs_area2)
  );
  pineda_pkg::triangle_t canonical, tri2_q, tri3_q, tri4_q;
  setup_canonical u_canonical (
    .valid_i(step[5]),
    .frame_i, .tri_i(tri_q), .anchor_i(anchor_q), .clockwise_i(clockwise), .tri_o(canonical)
  );

  // ---- Step I + 6: vertices 1 and 2 from the anchor, the first sample from the anchor
  typedef struct packed {
    logic signed [COEFF_BITS-1:0] dx1, dy1, dx2, dy2, ref_x, ref_y;
  } offsets_t;
  offsets_t offsets, offsets3_q, offsets4_q;
  setup_differences u_differences (
    .x_i(tri3_q.x), .y_i(tri3_q.y),
    .dx1_o(offsets.dx1), .dy1_o(offsets.dy1), .dx2_o(offsets.dx2), .dy2_o(offsets.dy2)
  );
  setup_reference u_reference (
    .x_i(tri3_q.x[COORD_BITS-1:0]), .y_i(tri3_q.y[COORD_BITS-1:0]),
    .box_i(box3_q[2*PIXEL_BITS-1:0]), .ref_x_o(offsets.ref_x), .ref_y_o(offsets.ref_y)
  );

  always_ff @(posedge clk_i) begin
    if (advance) begin
      if (step[0]) tri_q <= tri_i;
      if (step[2]) {anchor_q, empty_q, box_q} <= {anchor, empty, box};
      if (step[4]) area2_q <= difference;
      if (step[5]) {tri2_q, box2_q, area2_2q} <= {canonical, box_q, abs_area2};
      if (step[I+5]) {tri3_q, box3_q, area2_3q} <= {tri2_q, box2_q, area2_2q};
      if (step[I+6]) offsets3_q <= offsets;
      if (step[2*I+5]) {tri4_q, box4_q, area2_4q} <= {tri3_q, box3_q, area2_3q};
      if (step[2*I+6]) offsets4_q <= offsets3_q;
    end
  end

  // ---- E of edges 0 and 2 from the anchor, which lies on both
  logic signed [AREA2_BITS-1:0] e0_q, e2_q;
  always_comb begin
    factor_a = raw_dx1;
    factor_b = raw_dy2;
    if (step[2]) begin factor_a = raw_dx2; factor_b = raw_dy1; end
    if (step[EDGE0-1]) begin factor_a = offsets3_q.dx1; factor_b = offsets3_q.ref_y; end
    if (step[EDGE1-1]) begin factor_a = offsets3_q.dy1; factor_b = offsets3_q.ref_x; end
    if (step[EDGE2-1]) begin factor_a = offsets3_q.dy2; factor_b = offsets3_q.ref_x; end
    if (step[EDGE3-1]) begin factor_a = offsets3_q.dx2; factor_b = offsets3_q.ref_y; end
  end
  always_ff @(posedge clk_i) begin
    if (advance && step[EDGE1+1]) e0_q <= difference;
    if (advance && step[EDGE3+1]) e2_q <= difference;
  end

  // ---- The output register: each plane when it comes; edges in a step in which they are there, and
  // the primitive before is gone
  localparam int unsigned EDGES = EDGE3 + 2 > LATENCY - I ? EDGE3 + 2 : LATENCY - I;
  pineda_pkg::setup_prim_t prim_q, with_edges;
  assign prim_o = prim_q;
  setup_edges u_edges (
    .valid_i(step[EDGES]),
    .tri_i(tri4_q), .box_i(box4_q),
    .dx1_i(offsets4_q.dx1), .dy1_i(offsets4_q.dy1), .dx2_i(offsets4_q.dx2), .dy2_i(offsets4_q.dy2),
    .area2_i(area2_4q), .e0_i(e0_q), .e2_i(e2_q), .prim_i(prim_q), .prim_o(with_edges)
  );

`ifdef PINEDA_PLANES
  // ---- The reciprocal starts in step 6 and is done when the next one starts.
  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0] length, length_q;
  logic [pineda_pkg::RECIPROCAL_BITS-1:0] mantissa, mantissa_q;
  reciprocal u_reciprocal (
    .clk_i, .rst_ni,
    .enable_i(advance),
    .start_i(step[6]),
    .area2_i(area2_2q),
    .length_o(length),
    .mantissa_o(mantissa)
  );
  always_ff @(posedge clk_i) begin
    if (advance && step[I+6]) {mantissa_q, length_q} <= {mantissa, length};
  end

  // ---- The planes: each input as their pipeline takes it, see there
  localparam int unsigned START = pineda_pkg::SETUP_PLANES_STEP;
  logic plane_valid;
  logic [$clog2(pineda_pkg::PLANES+1)-1:0] plane_index;
  logic signed [pineda_pkg::PLANE_BITS-1:0] plane_dx, plane_dy, plane_ref;
`ifdef PINEDA_DEPTH
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] bias;
`ifdef PINEDA_HIERARCHICAL_Z
  logic steep;
`endif
`endif
  setup_planes u_planes (
    .clk_i, .rst_ni,
    .enable_i(advance),
    .start_i(step[START]),
    .tri_i(tri3_q),
    .dx1_i(offsets3_q.dx1), .dy1_i(offsets3_q.dy1), .dx2_i(offsets3_q.dx2), .dy2_i(offsets3_q.dy2),
    .factors_i(step[START+3]), .mantissa_i(mantissa_q), .length_i(length_q),
    // Where these stand in the cycle before the pipeline takes them
    .offsets_i(step[START+7]),
    .ref_x_i(START + 7 > 2 * I + 6 ? offsets4_q.ref_x : offsets3_q.ref_x),
    .ref_y_i(START + 7 > 2 * I + 6 ? offsets4_q.ref_y : offsets3_q.ref_y),
    .base_i(step[START+8]), .base_tri_i(START + 8 > 2 * I + 5 ? tri4_q : tri3_q),
    .valid_o(plane_valid), .index_o(plane_index),
`ifdef PINEDA_DEPTH
    .frame_i, .bias_o(bias),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o(steep),
`endif
`endif
    .dx_o(plane_dx), .dy_o(plane_dy), .ref_o(plane_ref)
  );
  pineda_pkg::setup_prim_t with_plane;
  setup_with_plane u_with_plane (
    .valid_i(plane_valid),
    .index_i(plane_index), .dx_i(plane_dx), .dy_i(plane_dy), .ref_i(plane_ref),
    .prim_i(step[EDGES] ? with_edges : prim_q), .prim_o(with_plane)
  );
  always_ff @(posedge clk_i) begin
    if (advance) begin
      if (plane_valid) begin
        prim_q <= with_plane;
`ifdef PINEDA_DEPTH
        if (plane_index == '0) prim_q.z_bias <= bias;
`ifdef PINEDA_HIERARCHICAL_Z
        if (plane_index == '0) prim_q.z_steep <= steep;
`endif
`endif
      end else if (step[EDGES]) begin
        prim_q <= with_edges;
      end
    end
  end
`else
  always_ff @(posedge clk_i) begin
    if (advance && step[EDGES]) prim_q <= with_edges;
  end
`endif
endmodule
`endif
