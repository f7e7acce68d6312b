// What a plane is made of: depth or an attribute at the three vertices. No state.
//
// In       index_i: 0 is the first plane, depth if there is any.
// Out      values_o in units of 2^-VALUE_FRACTION_BITS whatever they are, the anchor's lowest.
`ifdef PINEDA_PLANES
module setup_values (
  input  logic                                          valid_i,
  input  logic [$clog2(pineda_pkg::PLANES+1)-1:0]       index_i,
  input  pineda_pkg::triangle_t                         tri_i,
  output logic [3*pineda_pkg::VALUE_BITS-1:0]           values_o
);
`ifdef PINEDA_AFFINE
  localparam int unsigned VALUE_BITS = pineda_pkg::VALUE_BITS;
  localparam int unsigned FRACTION = pineda_pkg::VALUE_FRACTION_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_BITS;
  localparam int unsigned FIRST = pineda_pkg::PLANES - ATTRIBUTES;
`endif
  // 'x while the values are not used: it costs no gate and saves the simulator work.
  always_comb begin
    values_o = 'x;
    if (valid_i) begin
`ifdef PINEDA_DEPTH
      if (index_i == '0) values_o = tri_i.z;
`endif
`ifdef PINEDA_AFFINE
      for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
        if (32'(index_i) == FIRST + i) begin
          for (int unsigned v = 0; v < 3; v++) begin
            values_o[v*VALUE_BITS +: VALUE_BITS] =
                VALUE_BITS'(tri_i.attr[(v*ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS]) << FRACTION;
          end
        end
      end
`endif
    end
  end
endmodule
`endif
