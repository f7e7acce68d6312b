// Triangle setup: one snapped triangle in, three edge functions and the planes out.
//
// Bits     core::setup() defines every output bit.
// In       tri_i: vertices sQ14.8 px, inside the guard band; y down. frame_i: stable while any
//          triangle of the frame is inside.
// Out      prim_o: a, b sQ15.8 px; e sQ30.8 px^2 at the first sample of the box's first tile,
//          top-left bias folded in; planes at the same sample.
// Rate     1 triangle every SETUP_INTERVAL_CYCLES; a dropped one takes 5 cycles. Latency
//          SETUP_PLANES_STEP + ATTRIBUTES + 7 cycles. Back-pressure freezes the whole unit.
// Drops    area2 = 0, culled by facing, box without a sample, box outside the frame: accepted,
//          not sent.
// Errors   none.
// Twin     model/core/setup.cpp. Source: Pineda, SIGGRAPH 1988.
module setup_unit (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pineda_pkg::frame_t       frame_i,

  // Snapped triangles, from the vertex source
  input  logic                     tri_valid_i,
  output logic                     tri_ready_o,
  input  pineda_pkg::triangle_t    tri_i,

  // Edge functions and planes, to traversal_unit; stable while prim_valid_o && !prim_ready_i
  output logic                     prim_valid_o,
  input  logic                     prim_ready_i,
  output pineda_pkg::setup_prim_t  prim_o,

  output logic                     idle_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned COORD_BITS = pineda_pkg::COORD_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned AREA2_BITS = pineda_pkg::AREA2_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::EDGE_BITS;
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_IN_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTRS_BITS = ATTRIBUTES * pineda_pkg::ATTR_BITS;
  localparam int unsigned ATTR_PLANE_BITS = pineda_pkg::ATTR_PLANE_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  // Pixel indices of vertices anywhere in the guard band, and the frame's size beside them
  localparam int unsigned RANGE_BITS = COORD_BITS - S + 1;
  localparam int unsigned STEP_BITS = $clog2(pineda_pkg::SETUP_INTERVAL_CYCLES);
  localparam logic [STEP_BITS-1:0] LAST_STEP =
      STEP_BITS'(pineda_pkg::SETUP_INTERVAL_CYCLES - 1);

  // ---- Control: step_q = 0 waits for a triangle, the steps below are numbered by it
  logic [STEP_BITS-1:0] step_q;
  logic advance;
  logic drop;
  logic planes_busy;
  logic prim_valid_q;
  pineda_pkg::setup_prim_t prim_q;
  assign advance = !(prim_valid_q && !prim_ready_i);
  assign tri_ready_o = advance && step_q == '0;
  assign prim_valid_o = prim_valid_q;
  assign prim_o = prim_q;
  assign idle_o = step_q == '0 && !planes_busy && !prim_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= '0;
    end else if (advance) begin
      if (step_q == '0) step_q <= STEP_BITS'(tri_valid_i);
      else if (step_q == LAST_STEP || (step_q == STEP_BITS'(4) && drop)) step_q <= '0;
      else step_q <= step_q + STEP_BITS'(1);
    end
  end

  // ---- Step 0: the triangle
  pineda_pkg::triangle_t tri_q;
  logic signed [COORD_BITS-1:0] x0, x1, x2, y0, y1, y2;
  assign x0 = signed'(tri_q.x[0 +: COORD_BITS]);
  assign x1 = signed'(tri_q.x[COORD_BITS +: COORD_BITS]);
  assign x2 = signed'(tri_q.x[2*COORD_BITS +: COORD_BITS]);
  assign y0 = signed'(tri_q.y[0 +: COORD_BITS]);
  assign y1 = signed'(tri_q.y[COORD_BITS +: COORD_BITS]);
  assign y2 = signed'(tri_q.y[2*COORD_BITS +: COORD_BITS]);

  // ---- Step 1: differences, extremes, and the anchor: the topmost, then leftmost vertex
  logic before10, before20, before21;
  assign before10 = y1 < y0 || (y1 == y0 && x1 < x0);
  assign before20 = y2 < y0 || (y2 == y0 && x2 < x0);
  assign before21 = y2 < y1 || (y2 == y1 && x2 < x1);
  logic [1:0] anchor_q;
  logic signed [COEFF_BITS-1:0] raw_dx1_q, raw_dy1_q, raw_dx2_q, raw_dy2_q;
  logic signed [COORD_BITS-1:0] x_low_q, x_high_q, y_low_q, y_high_q;

  // ---- Steps 2 and 3: doubled area; the pixels whose centres lie in [low, high), and the frame
  logic signed [RANGE_BITS-1:0] x_first_q, x_last_q, y_first_q, y_last_q;
  logic signed [RANGE_BITS-1:0] frame_width, frame_height;
  assign frame_width = RANGE_BITS'(signed'({1'b0, frame_i.width}));
  assign frame_height = RANGE_BITS'(signed'({1'b0, frame_i.height}));
  logic box_empty_q;
  logic [PIXEL_BITS-1:0] box_x0_q, box_y0_q, box_x1_q, box_y1_q;
  logic signed [AREA2_BITS-1:0] area2_q;

  // Two multipliers serve the area (step 2) and the edges (steps 6 and 7)
  logic signed [COEFF_BITS-1:0] factor_a, factor_b, factor_c, factor_d;
  logic signed [AREA2_BITS-1:0] product_ab_q, product_cd_q;

  // ---- Step 4: drop, or canonical order: the anchor first, then clockwise
  logic clockwise;
  logic culled;
  assign clockwise = !area2_q[AREA2_BITS-1];
  assign culled = (frame_i.cull == pineda_pkg::CULL_BACK && clockwise) ||
                  (frame_i.cull == pineda_pkg::CULL_FRONT && !clockwise);
  assign drop = area2_q == '0 || culled || box_empty_q;

  logic [1:0] order0, order1, order2; // which vertex stands first, second, third
  always_comb begin
    order0 = anchor_q;
    case (anchor_q)
      2'd0:    begin order1 = 2'd1; order2 = 2'd2; end
      2'd1:    begin order1 = 2'd2; order2 = 2'd0; end
      default: begin order1 = 2'd0; order2 = 2'd1; end
    endcase
    if (!clockwise) {order1, order2} = {order2, order1};
  end

  function automatic logic signed [COORD_BITS-1:0] coord(input logic [3*COORD_BITS-1:0] all,
                                                         input logic [1:0] vertex);
    case (vertex)
      2'd0:    coord = signed'(all[0 +: COORD_BITS]);
      2'd1:    coord = signed'(all[COORD_BITS +: COORD_BITS]);
      default: coord = signed'(all[2*COORD_BITS +: COORD_BITS]);
    endcase
  endfunction
  function automatic logic [Z_BITS-1:0] depth(input logic [3*Z_BITS-1:0] all,
                                              input logic [1:0] vertex);
    case (vertex)
      2'd0:    depth = all[0 +: Z_BITS];
      2'd1:    depth = all[Z_BITS +: Z_BITS];
      default: depth = all[2*Z_BITS +: Z_BITS];
    endcase
  endfunction
  function automatic logic [ATTRS_BITS-1:0] attrs(input logic [3*ATTRS_BITS-1:0] all,
                                                  input logic [1:0] vertex);
    case (vertex)
      2'd0:    attrs = all[0 +: ATTRS_BITS];
      2'd1:    attrs = all[ATTRS_BITS +: ATTRS_BITS];
      default: attrs = all[2*ATTRS_BITS +: ATTRS_BITS];
    endcase
  endfunction

  pineda_pkg::triangle_t canonical_q;
  logic [AREA2_BITS-2:0] abs_area2_q;

  // ---- Step 5: differences from the anchor, the first sample from the anchor; reciprocal starts
  logic signed [COORD_BITS-1:0] cx0, cx1, cx2, cy0, cy1, cy2;
  assign cx0 = signed'(canonical_q.x[0 +: COORD_BITS]);
  assign cx1 = signed'(canonical_q.x[COORD_BITS +: COORD_BITS]);
  assign cx2 = signed'(canonical_q.x[2*COORD_BITS +: COORD_BITS]);
  assign cy0 = signed'(canonical_q.y[0 +: COORD_BITS]);
  assign cy1 = signed'(canonical_q.y[COORD_BITS +: COORD_BITS]);
  assign cy2 = signed'(canonical_q.y[2*COORD_BITS +: COORD_BITS]);
  logic signed [COORD_BITS-1:0] sample_x, sample_y;
  assign sample_x = signed'({1'b0, box_x0_q[PIXEL_BITS-1:TILE_LOG2], {TILE_LOG2{1'b0}}, 1'b1,
                             {(S-1){1'b0}}});
  assign sample_y = signed'({1'b0, box_y0_q[PIXEL_BITS-1:TILE_LOG2], {TILE_LOG2{1'b0}}, 1'b1,
                             {(S-1){1'b0}}});
  logic signed [COEFF_BITS-1:0] dx1_q, dy1_q, dx2_q, dy2_q, ref_x_q, ref_y_q;

  // ---- Steps 6 to 9: E of edges 0 and 2 from the anchor, which lies on both; the three E add up
  // to area2
  logic signed [AREA2_BITS-1:0] e0_q, e2_q, e1;
  logic signed [COEFF_BITS-1:0] edge1_dx, edge1_dy;
  assign e1 = signed'({1'b0, abs_area2_q}) - e0_q - e2_q;
  assign edge1_dx = dx2_q - dx1_q;
  assign edge1_dy = dy2_q - dy1_q;

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

  // Biased before the shift, then in steps of whole pixels; an edge (dx, dy) is left if it goes up,
  // top if it goes to the right.
  function automatic logic [EDGE_BITS-1:0] biased(input logic signed [AREA2_BITS-1:0] e,
                                                  input logic signed [COEFF_BITS-1:0] dx,
                                                  input logic signed [COEFF_BITS-1:0] dy);
    logic top_left;
    logic signed [AREA2_BITS-1:0] shifted;
    top_left = dy < 0 || (dy == '0 && dx > 0);
    shifted = (e - AREA2_BITS'(signed'({1'b0, !top_left}))) >>> S;
    biased = shifted[EDGE_BITS-1:0];
  endfunction

  // The rounding of samples: first = ceil(low - 1/2), last = ceil(high - 1/2) - 1
  localparam logic signed [COORD_BITS:0] HALF_LESS_1 = (COORD_BITS+1)'((1 << (S - 1)) - 1);
  localparam logic signed [COORD_BITS:0] HALF_MORE_1 = (COORD_BITS+1)'((1 << (S - 1)) + 1);
  function automatic logic signed [RANGE_BITS-1:0] first(input logic signed [COORD_BITS-1:0] low);
    logic signed [COORD_BITS:0] moved;
    moved = (COORD_BITS+1)'(low) + HALF_LESS_1;
    first = moved[COORD_BITS:S];
  endfunction
  function automatic logic signed [RANGE_BITS-1:0] last(input logic signed [COORD_BITS-1:0] high);
    logic signed [COORD_BITS:0] moved;
    moved = (COORD_BITS+1)'(high) - HALF_MORE_1;
    last = moved[COORD_BITS:S];
  endfunction

  always_ff @(posedge clk_i) begin
    if (advance) begin
      case (step_q)
        STEP_BITS'(0): if (tri_valid_i) tri_q <= tri_i;
        STEP_BITS'(1): begin
          raw_dx1_q <= COEFF_BITS'(x1) - COEFF_BITS'(x0);
          raw_dy1_q <= COEFF_BITS'(y1) - COEFF_BITS'(y0);
          raw_dx2_q <= COEFF_BITS'(x2) - COEFF_BITS'(x0);
          raw_dy2_q <= COEFF_BITS'(y2) - COEFF_BITS'(y0);
          if (before20 && before21) anchor_q <= 2'd2;
          else anchor_q <= before10 ? 2'd1 : 2'd0;
          x_low_q  <= x0 < x1 ? (x0 < x2 ? x0 : x2) : (x1 < x2 ? x1 : x2);
          x_high_q <= x0 > x1 ? (x0 > x2 ? x0 : x2) : (x1 > x2 ? x1 : x2);
          y_low_q  <= y0 < y1 ? (y0 < y2 ? y0 : y2) : (y1 < y2 ? y1 : y2);
          y_high_q <= y0 > y1 ? (y0 > y2 ? y0 : y2) : (y1 > y2 ? y1 : y2);
        end
        STEP_BITS'(2): begin
          x_first_q <= first(x_low_q);
          x_last_q  <= last(x_high_q);
          y_first_q <= first(y_low_q);
          y_last_q  <= last(y_high_q);
        end
        STEP_BITS'(3): begin
          area2_q <= product_ab_q - product_cd_q;
          box_empty_q <= x_first_q > x_last_q || y_first_q > y_last_q ||
                         x_last_q < 0 || y_last_q < 0 ||
                         x_first_q >= frame_width || y_first_q >= frame_height;
          box_x0_q <= x_first_q < 0 ? '0 : x_first_q[PIXEL_BITS-1:0];
          box_y0_q <= y_first_q < 0 ? '0 : y_first_q[PIXEL_BITS-1:0];
          box_x1_q <= x_last_q < frame_width ? x_last_q[PIXEL_BITS-1:0]
                                             : PIXEL_BITS'(frame_width - RANGE_BITS'(1));
          box_y1_q <= y_last_q < frame_height ? y_last_q[PIXEL_BITS-1:0]
                                              : PIXEL_BITS'(frame_height - RANGE_BITS'(1));
        end
        STEP_BITS'(4): if (!drop) begin
          canonical_q.id <= tri_q.id;
          canonical_q.x <= {coord(tri_q.x, order2), coord(tri_q.x, order1),
                            coord(tri_q.x, order0)};
          canonical_q.y <= {coord(tri_q.y, order2), coord(tri_q.y, order1),
                            coord(tri_q.y, order0)};
          canonical_q.z <= {depth(tri_q.z, order2), depth(tri_q.z, order1),
                            depth(tri_q.z, order0)};
          canonical_q.attr <= {attrs(tri_q.attr, order2), attrs(tri_q.attr, order1),
                               attrs(tri_q.attr, order0)};
          abs_area2_q <= clockwise ? area2_q[AREA2_BITS-2:0] : (AREA2_BITS-1)'(-area2_q);
        end
        STEP_BITS'(5): begin
          dx1_q <= COEFF_BITS'(cx1) - COEFF_BITS'(cx0);
          dy1_q <= COEFF_BITS'(cy1) - COEFF_BITS'(cy0);
          dx2_q <= COEFF_BITS'(cx2) - COEFF_BITS'(cx0);
          dy2_q <= COEFF_BITS'(cy2) - COEFF_BITS'(cy0);
          ref_x_q <= COEFF_BITS'(sample_x) - COEFF_BITS'(cx0);
          ref_y_q <= COEFF_BITS'(sample_y) - COEFF_BITS'(cy0);
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

  logic plane_valid;
  logic signed [pineda_pkg::DEPTH_PLANE_BITS-1:0] plane_dx, plane_dy, plane_ref;
  setup_planes u_planes (
    .clk_i, .rst_ni,
    .enable_i(advance),
    .start_i(step_q == STEP_BITS'(pineda_pkg::SETUP_PLANES_STEP)),
    .dx1_i(dx1_q), .dy1_i(dy1_q), .dx2_i(dx2_q), .dy2_i(dy2_q),
    .ref_x_i(ref_x_q), .ref_y_i(ref_y_q),
    .z_i(canonical_q.z), .attr_i(canonical_q.attr),
    .mantissa_i(mantissa), .length_i(length),
    .plane_valid_o(plane_valid),
    .dx_o(plane_dx), .dy_o(plane_dy), .ref_o(plane_ref),
    .busy_o(planes_busy)
  );

  // ---- The output register: edges in step 9, then the planes, depth first, the last one completes
  localparam int unsigned INDEX_BITS = $clog2(ATTRIBUTES + 2);
  logic [INDEX_BITS-1:0] plane_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      plane_q <= '0;
      prim_valid_q <= 1'b0;
    end else if (advance) begin
      prim_valid_q <= plane_valid && plane_q == INDEX_BITS'(ATTRIBUTES);
      if (plane_valid) plane_q <= plane_q == INDEX_BITS'(ATTRIBUTES) ? '0
                                                                     : plane_q + INDEX_BITS'(1);
    end
  end

  always_ff @(posedge clk_i) begin
    if (advance) begin
      if (step_q == STEP_BITS'(9)) begin
        prim_q.id <= canonical_q.id;
        prim_q.x0 <= box_x0_q;
        prim_q.y0 <= box_y0_q;
        prim_q.x1 <= box_x1_q;
        prim_q.y1 <= box_y1_q;
        prim_q.a <= {dy2_q, COEFF_BITS'(-edge1_dy), COEFF_BITS'(-dy1_q)};
        prim_q.b <= {COEFF_BITS'(-dx2_q), edge1_dx, dx1_q};
        prim_q.e <= {biased(e2_q, -dx2_q, -dy2_q), biased(e1, edge1_dx, edge1_dy),
                     biased(e0_q, dx1_q, dy1_q)};
      end
      if (plane_valid) begin
        if (plane_q == '0) begin
          prim_q.z_dx <= plane_dx;
          prim_q.z_dy <= plane_dy;
          prim_q.z_ref <= plane_ref;
        end
        for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
          if (plane_q == INDEX_BITS'(i + 1)) begin
            prim_q.attr_dx[i*ATTR_PLANE_BITS +: ATTR_PLANE_BITS] <= plane_dx[ATTR_PLANE_BITS-1:0];
            prim_q.attr_dy[i*ATTR_PLANE_BITS +: ATTR_PLANE_BITS] <= plane_dy[ATTR_PLANE_BITS-1:0];
            prim_q.attr_ref[i*ATTR_PLANE_BITS +: ATTR_PLANE_BITS] <=
                plane_ref[ATTR_PLANE_BITS-1:0];
          end
        end
      end
    end
  end
endmodule
