// Triangle setup in steps: two multipliers for area and edges, then a pipeline for the planes.
//
// Bits     core::setup() defines every output bit.
// In, Out  as setup_unit.
// Rate     1 triangle every SETUP_INTERVAL_CYCLES; a dropped one takes 5 cycles. Latency
//          SETUP_PLANES_STEP + PLANES + 6 cycles, 10 without planes. Back-pressure freezes the
//          whole unit.
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

  output logic                     idle_o
);
  localparam int unsigned COORD_BITS = pineda_pkg::COORD_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned AREA2_BITS = pineda_pkg::AREA2_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
  localparam int unsigned STEP_BITS = $clog2(pineda_pkg::SETUP_INTERVAL_CYCLES);
  localparam logic [STEP_BITS-1:0] LAST_STEP =
      STEP_BITS'(pineda_pkg::SETUP_INTERVAL_CYCLES - 1);

  // ---- Control: step_q = 0 waits for a triangle, the steps below are numbered by it
  logic [STEP_BITS-1:0] step_q;
  logic advance;
  logic drop;
  logic prim_valid_q;
  pineda_pkg::setup_prim_t prim_q;
  assign advance = !(prim_valid_q && !prim_ready_i);
  assign tri_ready_o = advance && step_q == '0;
  assign prim_valid_o = prim_valid_q;
  assign prim_o = prim_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
    end else if (advance) begin
      if (step_q == '0) step_q <= STEP_BITS'(tri_valid_i);
      else if (step_q == LAST_STEP || (step_q == STEP_BITS'(4) && drop)) step_q <= '0;
      else step_q <= step_q + STEP_BITS'(1);
    end
  end

  // ---- Step 0: the triangle. Step 1: differences, extremes, anchor
  pineda_pkg::triangle_t tri_q;
  logic signed [COEFF_BITS-1:0] raw_dx1, raw_dy1, raw_dx2, raw_dy2;
  logic signed [COEFF_BITS-1:0] raw_dx1_q, raw_dy1_q, raw_dx2_q, raw_dy2_q;
  setup_differences u_raw (
    .x_i(tri_q.x), .y_i(tri_q.y),
    .dx1_o(raw_dx1), .dy1_o(raw_dy1), .dx2_o(raw_dx2), .dy2_o(raw_dy2)
  );

  logic [1:0] anchor, anchor_q;
  logic signed [COORD_BITS-1:0] x_low, x_high, y_low, y_high, x_low_q, x_high_q, y_low_q, y_high_q;
  setup_extremes u_extremes (
    .x_i(tri_q.x), .y_i(tri_q.y), .anchor_o(anchor),
    .x_low_o(x_low), .x_high_o(x_high), .y_low_o(y_low), .y_high_o(y_high)
  );

  // ---- Steps 2 and 3: doubled area, box
  logic empty, empty_q;
  logic [4*PIXEL_BITS-1:0] box, box_q;
  setup_box u_box (
    .frame_i, .x_low_i(x_low_q), .x_high_i(x_high_q), .y_low_i(y_low_q), .y_high_i(y_high_q),
    .empty_o(empty), .box_o(box)
  );
  logic signed [AREA2_BITS-1:0] area2_q;

  // Two multipliers serve the area (step 2) and the edges (steps 6 and 7)
  logic signed [COEFF_BITS-1:0] factor_a, factor_b, factor_c, factor_d;
  logic signed [AREA2_BITS-1:0] product_ab_q, product_cd_q;

  // ---- Step 4: drop, or canonical order
  logic clockwise;
  logic [AREA2_BITS-2:0] abs_area2, abs_area2_q;
  setup_drop u_drop (
`ifdef PINEDA_COUNTERS
    // The inputs of the box do not change before the next triangle's step 1.
    .clk_i, .count_i(advance && step_q == STEP_BITS'(4)),
    .no_sample_i(u_box.u_x.no_sample || u_box.u_y.no_sample),
`endif
    .frame_i, .area2_i(area2_q), .empty_i(empty_q),
    .drop_o(drop), .clockwise_o(clockwise), .abs_area2_o(abs_area2)
  );
  pineda_pkg::triangle_t canonical, canonical_q;
  setup_canonical u_canonical (
    .valid_i(step_q == STEP_BITS'(4)),
    .frame_i, .tri_i(tri_q), .anchor_i(anchor_q), .clockwise_i(clockwise), .tri_o(canonical)
  );

  // ---- Step 5: differences from the anchor, the first sample from the anchor; reciprocal starts
  logic signed [COEFF_BITS-1:0] dx1, dy1, dx2, dy2, ref_x, ref_y;
  logic signed [COEFF_BITS-1:0] dx1_q, dy1_q, dx2_q, dy2_q, ref_x_q, ref_y_q;
  setup_differences u_differences (
    .x_i(canonical_q.x), .y_i(canonical_q.y), .dx1_o(dx1), .dy1_o(dy1), .dx2_o(dx2), .dy2_o(dy2)
  );
  setup_reference u_reference (
    .x_i(canonical_q.x[COORD_BITS-1:0]), .y_i(canonical_q.y[COORD_BITS-1:0]),
    .box_i(box_q[2*PIXEL_BITS-1:0]), .ref_x_o(ref_x), .ref_y_o(ref_y)
  );

  // ---- Steps 6 to 9: E of edges 0 and 2 from the anchor, which lies on both
  logic signed [AREA2_BITS-1:0] e0_q, e2_q;
  always_comb begin
    case (step_q)
      STEP_BITS'(2): begin
        factor_a = raw_dx1_q; factor_b = raw_dy2_q; factor_c = raw_dx2_q; factor_d = raw_dy1_q;
      end
      STEP_BITS'(6): begin
        factor_a = dx1_q; factor_b = ref_y_q; factor_c = dy1_q; factor_d = ref_x_q;
      end
      default: begin
        factor_a = dy2_q; factor_b = ref_x_q; factor_c = dx2_q; factor_d = ref_y_q;
      end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (advance) begin
      case (step_q)
        STEP_BITS'(0): if (tri_valid_i) tri_q <= tri_i;
        STEP_BITS'(1): begin
          raw_dx1_q <= raw_dx1;
          raw_dy1_q <= raw_dy1;
          raw_dx2_q <= raw_dx2;
          raw_dy2_q <= raw_dy2;
          anchor_q <= anchor;
          x_low_q <= x_low;
          x_high_q <= x_high;
          y_low_q <= y_low;
          y_high_q <= y_high;
        end
        STEP_BITS'(3): begin
          area2_q <= product_ab_q - product_cd_q;
          empty_q <= empty;
          box_q <= box;
        end
        STEP_BITS'(4): if (!drop) begin
          canonical_q <= canonical;
          abs_area2_q <= abs_area2;
        end
        STEP_BITS'(5): begin
          dx1_q <= dx1;
          dy1_q <= dy1;
          dx2_q <= dx2;
          dy2_q <= dy2;
          ref_x_q <= ref_x;
          ref_y_q <= ref_y;
        end
        STEP_BITS'(7): e0_q <= product_ab_q - product_cd_q;
        STEP_BITS'(8): e2_q <= product_ab_q - product_cd_q;
        default: ;
      endcase
      if (step_q == STEP_BITS'(2) || step_q == STEP_BITS'(6) || step_q == STEP_BITS'(7)) begin
        product_ab_q <= AREA2_BITS'(factor_a) * AREA2_BITS'(factor_b);
        product_cd_q <= AREA2_BITS'(factor_c) * AREA2_BITS'(factor_d);
      end
    end
  end

  pineda_pkg::setup_prim_t with_edges;
  setup_edges u_edges (
    .valid_i(step_q == STEP_BITS'(9)),
    .tri_i(canonical_q), .box_i(box_q), .dx1_i(dx1_q), .dy1_i(dy1_q), .dx2_i(dx2_q), .dy2_i(dy2_q),
    .area2_i(abs_area2_q), .e0_i(e0_q), .e2_i(e2_q), .prim_i(prim_q), .prim_o(with_edges)
  );

  // ---- The output register: edges in step 9, then the planes, the last one completes it
`ifdef PINEDA_PLANES
  localparam int unsigned PLANES = pineda_pkg::PLANES;
  localparam int unsigned PLANE_BITS = pineda_pkg::PLANE_BITS;
  localparam int unsigned INDEX_BITS = $clog2(PLANES + 1);

  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0] length;
  logic [pineda_pkg::RECIPROCAL_BITS-1:0] mantissa;
  reciprocal u_reciprocal (
    .clk_i, .rst_ni,
    .enable_i(advance),
    .start_i(step_q == STEP_BITS'(5)),
    .area2_i(abs_area2_q),
    .length_o(length),
    .mantissa_o(mantissa)
  );

  logic plane_valid, planes_busy;
  logic [INDEX_BITS-1:0] plane_index;
  logic signed [PLANE_BITS-1:0] plane_dx, plane_dy, plane_ref;
`ifdef PINEDA_DEPTH
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] bias;
`ifdef PINEDA_HIERARCHICAL_Z
  logic steep;
`endif
`endif
  setup_planes u_planes (
    .clk_i, .rst_ni,
    .enable_i(advance),
    .start_i(step_q == STEP_BITS'(pineda_pkg::SETUP_PLANES_STEP)),
    .tri_i(canonical_q),
    .dx1_i(dx1_q), .dy1_i(dy1_q), .dx2_i(dx2_q), .dy2_i(dy2_q),
    .ref_x_i(ref_x_q), .ref_y_i(ref_y_q),
    .mantissa_i(mantissa), .length_i(length),
    .valid_o(plane_valid), .index_o(plane_index),
    .dx_o(plane_dx), .dy_o(plane_dy), .ref_o(plane_ref),
`ifdef PINEDA_DEPTH
    .frame_i, .bias_o(bias),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o(steep),
`endif
`endif
    .busy_o(planes_busy)
  );
  pineda_pkg::setup_prim_t with_plane;
  setup_with_plane u_with_plane (
    .valid_i(plane_valid),
    .index_i(plane_index), .dx_i(plane_dx), .dy_i(plane_dy), .ref_i(plane_ref),
    .prim_i(prim_q), .prim_o(with_plane)
  );

  logic complete;
  assign complete = plane_valid && plane_index == INDEX_BITS'(PLANES - 1);
  assign idle_o = step_q == '0 && !planes_busy && !prim_valid_q;
  always_ff @(posedge clk_i) begin
    if (advance) begin
      if (step_q == STEP_BITS'(9)) prim_q <= with_edges;
      if (plane_valid) begin
        prim_q <= with_plane;
`ifdef PINEDA_DEPTH
        if (plane_index == '0) prim_q.z_bias <= bias;
`ifdef PINEDA_HIERARCHICAL_Z
        if (plane_index == '0) prim_q.z_steep <= steep;
`endif
`endif
      end
    end
  end
`else
  logic complete;
  assign complete = step_q == STEP_BITS'(9);
  assign idle_o = step_q == '0 && !prim_valid_q;
  always_ff @(posedge clk_i) begin
    if (advance && complete) prim_q <= with_edges;
  end
`endif

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) prim_valid_q <= 1'b0;
    else if (advance) prim_valid_q <= complete;
  end
endmodule
`endif
