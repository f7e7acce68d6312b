// Counts what happens, by kind, one event a cycle at most. In simulation alone: the bench reads
// count_q by name and takes the difference over a frame, so nothing ever clears it.
`ifdef PINEDA_COUNTERS
module cycle_counters #(
  parameter int unsigned Kinds = 2,
  localparam int unsigned KIND_BITS = Kinds > 1 ? $clog2(Kinds) : 1
) (
  input logic                  clk_i,
  input logic                  count_i,
  input logic [KIND_BITS-1:0]  kind_i
);
  logic [63:0] count_q [Kinds];
  always_ff @(posedge clk_i) begin
    if (count_i) count_q[kind_i] <= count_q[kind_i] + 64'd1;
  end
endmodule
`endif
