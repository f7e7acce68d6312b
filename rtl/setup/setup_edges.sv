// A primitive but for its planes, from its triangle, its box and E of edges 0 and 2. No state.
//
// Bits     core::setup().
// In       tri_i in canonical order; vertices 1 and 2 from the anchor; E of the two edges that meet
//          there, at the first sample. The three E add up to area2.
// Out      prim_o: the planes are those of prim_i.
// Twin     model/core/setup.cpp.
module setup_edges (
  input  logic                                           valid_i, // else prim_o is not used
  input  pineda_pkg::triangle_t                          tri_i,
  input  logic [4*pineda_pkg::PIXEL_BITS-1:0]            box_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]              area2_i,
  input  logic signed [pineda_pkg::AREA2_BITS-1:0]       e0_i,
  input  logic signed [pineda_pkg::AREA2_BITS-1:0]       e2_i,

  input  pineda_pkg::setup_prim_t                        prim_i,
  output pineda_pkg::setup_prim_t                        prim_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned AREA2_BITS = pineda_pkg::AREA2_BITS;

  logic signed [COEFF_BITS-1:0] edge1_dx, edge1_dy;
  assign edge1_dx = dx2_i - dx1_i;
  assign edge1_dy = dy2_i - dy1_i;

  // An edge (dx, dy) is left if it goes up, top if it goes to the right.
  function automatic logic signed [AREA2_BITS-1:0] biased(
      input logic signed [AREA2_BITS-1:0] e, input logic signed [COEFF_BITS-1:0] dx,
      input logic signed [COEFF_BITS-1:0] dy);
    logic top_left;
    top_left = dy < 0 || (dy == '0 && dx > 0);
    biased = e - AREA2_BITS'(signed'({1'b0, !top_left}));
  endfunction
  logic signed [AREA2_BITS-1:0] e0, e1, e2;
  assign e0 = biased(e0_i, dx1_i, dy1_i);
  assign e1 = biased(signed'({1'b0, area2_i}) - e0_i - e2_i, edge1_dx, edge1_dy);
  assign e2 = biased(e2_i, -dx2_i, -dy2_i);

  always_comb begin
    prim_o = 'x;
    if (valid_i) begin
      prim_o = prim_i;
      prim_o.id = tri_i.id;
      {prim_o.y1, prim_o.x1, prim_o.y0, prim_o.x0} = box_i;
      prim_o.a = {dy2_i, COEFF_BITS'(-edge1_dy), COEFF_BITS'(-dy1_i)};
      prim_o.b = {COEFF_BITS'(-dx2_i), edge1_dx, dx1_i};
      // The low S bits are left out: E moves in steps of whole pixels, which never change them.
      prim_o.e = {e2[AREA2_BITS-1:S], e1[AREA2_BITS-1:S], e0[AREA2_BITS-1:S]};
`ifdef PINEDA_PERSPECTIVE
      prim_o.e_low = {e2[S-1:0], e1[S-1:0], e0[S-1:0]};
      prim_o.inverse_w = tri_i.inverse_w;
      prim_o.inverse_w_shift = tri_i.inverse_w_shift;
      prim_o.vertex_attr = tri_i.attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
      prim_o.flat = tri_i.flat;
`endif
    end
  end
endmodule
