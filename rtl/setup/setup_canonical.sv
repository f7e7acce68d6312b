// A triangle with its vertices in canonical order: the anchor first, then clockwise. Flat shading
// gives the attributes of the vertex given first to all three. No state.
//
// Bits     core::setup().
// Twin     model/core/setup.cpp.
module setup_canonical (
  input  logic                   valid_i, // else the output is not used, nor computed
  input  pineda_pkg::frame_t     frame_i,
  input  pineda_pkg::triangle_t  tri_i,
  input  logic [1:0]             anchor_i,
  input  logic                   clockwise_i, // as given

  output pineda_pkg::triangle_t  tri_o
);
  logic [3*pineda_pkg::COORD_BITS-1:0] x, y;
  setup_order #(.Width(pineda_pkg::COORD_BITS)) u_x (
    .valid_i, .anchor_i, .clockwise_i, .given_i(tri_i.x), .ordered_o(x)
  );
  setup_order #(.Width(pineda_pkg::COORD_BITS)) u_y (
    .valid_i, .anchor_i, .clockwise_i, .given_i(tri_i.y), .ordered_o(y)
  );

`ifdef PINEDA_DEPTH
  logic [3*pineda_pkg::DEPTH_IN_BITS-1:0] z;
  setup_order #(.Width(pineda_pkg::DEPTH_IN_BITS)) u_z (
    .valid_i, .anchor_i, .clockwise_i, .given_i(tri_i.z), .ordered_o(z)
  );
`endif

`ifdef PINEDA_PERSPECTIVE
  logic [3*pineda_pkg::INVERSE_W_BITS-1:0] inverse_w;
  logic [3*pineda_pkg::INVERSE_W_SHIFT_BITS-1:0] inverse_w_shift;
  setup_order #(.Width(pineda_pkg::INVERSE_W_BITS)) u_inverse_w (
    .valid_i, .anchor_i, .clockwise_i, .given_i(tri_i.inverse_w), .ordered_o(inverse_w)
  );
  setup_order #(.Width(pineda_pkg::INVERSE_W_SHIFT_BITS)) u_inverse_w_shift (
    .valid_i, .anchor_i, .clockwise_i, .given_i(tri_i.inverse_w_shift), .ordered_o(inverse_w_shift)
  );
`endif

`ifdef PINEDA_ATTRIBUTES
  localparam int unsigned ATTRS_BITS = pineda_pkg::ATTRIBUTES * pineda_pkg::ATTR_BITS;
  logic [3*ATTRS_BITS-1:0] attr, given_attr;
  assign given_attr = frame_i.shade == pineda_pkg::SHADE_FLAT ? {3{tri_i.attr[ATTRS_BITS-1:0]}}
                                                              : tri_i.attr;
  setup_order #(.Width(ATTRS_BITS)) u_attr (
    .valid_i, .anchor_i, .clockwise_i, .given_i(given_attr), .ordered_o(attr)
  );
`endif

  always_comb begin
    tri_o = 'x;
    if (valid_i) begin
      tri_o = tri_i;
      tri_o.x = x;
      tri_o.y = y;
`ifdef PINEDA_DEPTH
      tri_o.z = z;
`endif
`ifdef PINEDA_PERSPECTIVE
      tri_o.inverse_w = inverse_w;
      tri_o.inverse_w_shift = inverse_w_shift;
`endif
`ifdef PINEDA_ATTRIBUTES
      tri_o.attr = attr;
`endif
    end
  end
endmodule
