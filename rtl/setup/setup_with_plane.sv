// A primitive with one plane put in its place. No state.
//
// In       index_i: 0 is the first plane, depth if there is any. An attribute's plane is the low
//          ATTR_PLANE_BITS of each value.
`ifdef PINEDA_PLANES
module setup_with_plane (
  input  logic                                           valid_i, // else prim_o is not used
  input  logic [$clog2(pineda_pkg::PLANES+1)-1:0]        index_i,
  input  logic signed [pineda_pkg::PLANE_BITS-1:0]       dx_i,
  input  logic signed [pineda_pkg::PLANE_BITS-1:0]       dy_i,
  input  logic signed [pineda_pkg::PLANE_BITS-1:0]       ref_i,

  input  pineda_pkg::setup_prim_t                        prim_i,
  output pineda_pkg::setup_prim_t                        prim_o
);
`ifdef PINEDA_AFFINE
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned BITS = pineda_pkg::ATTR_PLANE_BITS;
  localparam int unsigned FIRST = pineda_pkg::PLANES - ATTRIBUTES;
`endif
  always_comb begin
    prim_o = 'x;
    if (valid_i) begin
      prim_o = prim_i;
`ifdef PINEDA_DEPTH
      if (index_i == '0) begin
        prim_o.z_dx = dx_i;
        prim_o.z_dy = dy_i;
        prim_o.z_ref = ref_i;
      end
`endif
`ifdef PINEDA_AFFINE
      for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
        if (32'(index_i) == FIRST + i) begin
          prim_o.attr_dx[i*BITS +: BITS] = dx_i[BITS-1:0];
          prim_o.attr_dy[i*BITS +: BITS] = dy_i[BITS-1:0];
          prim_o.attr_ref[i*BITS +: BITS] = ref_i[BITS-1:0];
        end
      end
`endif
    end
  end
endmodule
`endif
