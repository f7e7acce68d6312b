// Triangle setup: one snapped triangle in, three edge functions and the planes out.
//
// Bits     core::setup() defines every output bit.
// In       tri_i: vertices sQ14.8 px, inside the guard band; y down. frame_i: stable while any
//          triangle of the frame is inside.
// Out      prim_o: a, b sQ15.8 px; e sQ30.8 px^2 at the first sample of the box's first tile,
//          top-left bias folded in; planes at the same sample.
// Rate     1 triangle every SETUP_INTERVAL_CYCLES, as spec::widths() derives them for the style of
//          the design. Back-pressure freezes the whole unit.
// Drops    area2 = 0, culled by facing, box without a sample, box outside the scissor: accepted,
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
  logic working;
`ifdef PINEDA_SETUP_STEPPED
  setup_stepped
`elsif PINEDA_SETUP_PIPELINED
  setup_pipelined
`elsif PINEDA_SETUP_SERIAL
  setup_serial
`endif
  u_style (
    .clk_i, .rst_ni, .frame_i, .tri_valid_i, .tri_ready_o, .tri_i,
    .prim_valid_o, .prim_ready_i, .prim_o, .working_o(working), .idle_o
  );

`ifdef PINEDA_COUNTERS
  // Frozen by its output; else busy when it takes a triangle, or cannot yet take the next one.
  logic [2:0] cause;
  assign cause = prim_valid_o && !prim_ready_i ? cycle_cause_pkg::BLOCKED :
                 (tri_valid_i && tri_ready_o) || working ? cycle_cause_pkg::BUSY
                                                         : cycle_cause_pkg::STARVED;
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1), .kind_i(cause)
  );
`endif
endmodule
