// Triangle setup with one multiplier, which makes a product a cycle.
//
// Bits     core::setup() defines every output bit.
// In, Out  as setup_unit.
// Rate     1 triangle every SETUP_INTERVAL_CYCLES; a dropped one takes 5 cycles. The next triangle
//          is taken after the primitive. Back-pressure freezes the whole unit.
// Drops    as setup_unit.
// Twin     model/core/setup.cpp.
`ifdef PINEDA_SETUP_SERIAL
module setup_serial (
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
  localparam int unsigned A_BITS = pineda_pkg::SETUP_FACTOR_A_BITS;
  localparam int unsigned B_BITS = pineda_pkg::SETUP_FACTOR_B_BITS;
  localparam int unsigned STEP_BITS = $clog2(pineda_pkg::SETUP_LATENCY_CYCLES);
  localparam logic [STEP_BITS-1:0] LAST_STEP =
      STEP_BITS'(pineda_pkg::SETUP_LATENCY_CYCLES - 1);

  // ---- Control: step_q = 0 waits for a triangle, the steps below are numbered by it
  logic [STEP_BITS-1:0] step_q;
  logic advance;
  logic drop;
  logic prim_valid_q;
  pineda_pkg::setup_prim_t prim_q;
  assign advance = !(prim_valid_q && !prim_ready_i);
  assign tri_ready_o = step_q == '0 && !prim_valid_q;
  assign prim_valid_o = prim_valid_q;
  assign prim_o = prim_q;
  assign working_o = step_q != '0 || prim_valid_q;
  assign idle_o = step_q == '0 && !prim_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
      prim_valid_q <= 1'b0;
    end else if (advance) begin
      prim_valid_q <= step_q == LAST_STEP;
      if (step_q == '0) step_q <= STEP_BITS'(tri_valid_i && tri_ready_o);
      else if (step_q == LAST_STEP || (step_q == STEP_BITS'(4) && drop)) step_q <= '0;
      else step_q <= step_q + STEP_BITS'(1);
    end
  end

  // ---- The triangle as it came, from step 5 on in canonical order
  pineda_pkg::triangle_t tri_q, canonical;
  logic signed [COEFF_BITS-1:0] dx1, dy1, dx2, dy2, ref_x, ref_y;
  setup_differences u_differences (
    .x_i(tri_q.x), .y_i(tri_q.y), .dx1_o(dx1), .dy1_o(dy1), .dx2_o(dx2), .dy2_o(dy2)
  );
  logic [1:0] anchor;
  logic signed [COORD_BITS-1:0] x_low, x_high, y_low, y_high;
  setup_extremes u_extremes (
    .x_i(tri_q.x), .y_i(tri_q.y), .anchor_o(anchor),
    .x_low_o(x_low), .x_high_o(x_high), .y_low_o(y_low), .y_high_o(y_high)
  );
  logic empty, empty_q;
  logic [4*PIXEL_BITS-1:0] box, box_q;
  setup_box u_box (
    .frame_i, .x_low_i(x_low), .x_high_i(x_high), .y_low_i(y_low), .y_high_i(y_high),
    .empty_o(empty), .box_o(box)
  );
  logic signed [AREA2_BITS-1:0] area2_q, e0_q, e2_q;
  logic [AREA2_BITS-2:0] abs_area2;
  logic clockwise;
  setup_drop u_drop (
`ifdef PINEDA_COUNTERS
    // The inputs of the box do not change before the end of step 4.
    .clk_i, .count_i(advance && step_q == STEP_BITS'(4)),
    .no_sample_i(u_box.u_x.no_sample || u_box.u_y.no_sample),
`endif
    .frame_i, .area2_i(area2_q), .empty_i(empty_q),
    .drop_o(drop), .clockwise_o(clockwise), .abs_area2_o(abs_area2)
  );
  setup_canonical u_canonical (
    .valid_i(1'b1),
    .frame_i, .tri_i(tri_q), .anchor_i(anchor), .clockwise_i(clockwise), .tri_o(canonical)
  );
  setup_reference u_reference (
    .x_i(tri_q.x[COORD_BITS-1:0]), .y_i(tri_q.y[COORD_BITS-1:0]),
    .box_i(box_q[2*PIXEL_BITS-1:0]), .ref_x_o(ref_x), .ref_y_o(ref_y)
  );

  // ---- The multiplier
  logic signed [A_BITS-1:0] factor_a, rest_a;
  logic signed [B_BITS-1:0] factor_b, rest_b;
  logic signed [A_BITS+B_BITS-1:0] product, product_q;
  multiplier #(.ABits(A_BITS), .BBits(B_BITS)) u_product (
    .a_i(factor_a), .b_i(factor_b), .addend_i('0), .product_o(product)
  );
  always_comb begin
    factor_a = rest_a;
    factor_b = rest_b;
    case (step_q)
      STEP_BITS'(1): begin factor_a = A_BITS'(dx1); factor_b = B_BITS'(dy2); end
      STEP_BITS'(2): begin factor_a = A_BITS'(dx2); factor_b = B_BITS'(dy1); end
      STEP_BITS'(5): begin factor_a = A_BITS'(dx1); factor_b = B_BITS'(ref_y); end
      STEP_BITS'(6): begin factor_a = A_BITS'(dy1); factor_b = B_BITS'(ref_x); end
      STEP_BITS'(7): begin factor_a = A_BITS'(dy2); factor_b = B_BITS'(ref_x); end
      STEP_BITS'(8): begin factor_a = A_BITS'(dx2); factor_b = B_BITS'(ref_y); end
      default: ;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (advance) product_q <= product;
  end

  // ---- Area (steps 1 to 3), drop or canonical order (4), E of the edges that meet at the anchor
  // (5 to 9)
  logic signed [AREA2_BITS-1:0] sum_q, difference;
  assign difference = sum_q - AREA2_BITS'(product_q);
  always_ff @(posedge clk_i) begin
    if (advance) begin
      case (step_q)
        STEP_BITS'(0): if (tri_valid_i) tri_q <= tri_i;
        STEP_BITS'(2), STEP_BITS'(6), STEP_BITS'(8): sum_q <= AREA2_BITS'(product_q);
        STEP_BITS'(3): begin
          area2_q <= difference;
          empty_q <= empty;
          box_q <= box;
        end
        STEP_BITS'(4): begin
          tri_q <= canonical;
          area2_q <= signed'({1'b0, abs_area2});
        end
        STEP_BITS'(7): e0_q <= difference;
        STEP_BITS'(9): e2_q <= difference;
        default: ;
      endcase
    end
  end

  pineda_pkg::setup_prim_t with_edges;
  setup_edges u_edges (
    .valid_i(1'b1),
    .tri_i(tri_q), .box_i(box_q), .dx1_i(dx1), .dy1_i(dy1), .dx2_i(dx2), .dy2_i(dy2),
    .area2_i(area2_q[AREA2_BITS-2:0]), .e0_i(e0_q), .e2_i(e2_q),
    .prim_i(prim_q), .prim_o(with_edges)
  );

`ifdef PINEDA_PLANES
  // ---- The reciprocal from step 9, the planes from SETUP_PLANES_STEP on
  localparam logic [STEP_BITS-1:0] PLANES_STEP = STEP_BITS'(pineda_pkg::SETUP_PLANES_STEP);
  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0] length;
  logic [pineda_pkg::RECIPROCAL_BITS-1:0] mantissa;
  logic signed [A_BITS-1:0] reciprocal_a, planes_a;
  logic signed [B_BITS-1:0] reciprocal_b, planes_b;
  reciprocal_serial u_reciprocal (
    .clk_i, .rst_ni, .enable_i(advance),
    .start_i(step_q == STEP_BITS'(5)), .area2_i(area2_q[AREA2_BITS-2:0]),
    .turn_i(step_q >= STEP_BITS'(9) && step_q <= PLANES_STEP),
    .factor_a_o(reciprocal_a), .factor_b_o(reciprocal_b), .product_i(product_q),
    .length_o(length), .mantissa_o(mantissa)
  );

  logic planes_busy, plane_valid;
  logic [$clog2(pineda_pkg::PLANES+1)-1:0] plane_index;
  logic signed [pineda_pkg::PLANE_BITS-1:0] plane_dx, plane_dy, plane_ref;
`ifdef PINEDA_DEPTH
  logic bias_valid;
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] bias;
`ifdef PINEDA_HIERARCHICAL_Z
  logic steep;
`endif
`endif
  setup_serial_planes u_planes (
    .clk_i, .rst_ni, .enable_i(advance),
`ifdef PINEDA_DEPTH
    .frame_i, .bias_valid_o(bias_valid), .bias_o(bias),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o(steep),
`endif
`endif
    .start_i(step_q == PLANES_STEP - STEP_BITS'(1)), .tri_i(tri_q),
    .dx1_i(dx1), .dy1_i(dy1), .dx2_i(dx2), .dy2_i(dy2), .ref_x_i(ref_x), .ref_y_i(ref_y),
    .mantissa_i(mantissa), .length_i(length),
    .busy_o(planes_busy), .factor_a_o(planes_a), .factor_b_o(planes_b), .product_i(product_q),
    .valid_o(plane_valid), .index_o(plane_index),
    .dx_o(plane_dx), .dy_o(plane_dy), .ref_o(plane_ref)
  );
  assign rest_a = planes_busy ? planes_a : reciprocal_a;
  assign rest_b = planes_busy ? planes_b : reciprocal_b;

  pineda_pkg::setup_prim_t with_plane;
  setup_with_plane u_with_plane (
    .valid_i(1'b1), .index_i(plane_index), .dx_i(plane_dx), .dy_i(plane_dy), .ref_i(plane_ref),
    .prim_i(prim_q), .prim_o(with_plane)
  );
`else
  assign rest_a = 'x;
  assign rest_b = 'x;
`endif

  // ---- The output register: edges in step 10, then the planes
  always_ff @(posedge clk_i) begin
    if (advance) begin
      if (step_q == STEP_BITS'(10)) prim_q <= with_edges;
`ifdef PINEDA_PLANES
      if (plane_valid) prim_q <= with_plane;
`endif
`ifdef PINEDA_DEPTH
      if (bias_valid) prim_q.z_bias <= bias;
`ifdef PINEDA_HIERARCHICAL_Z
      if (bias_valid) prim_q.z_steep <= steep;
`endif
`endif
    end
  end
endmodule
`endif
