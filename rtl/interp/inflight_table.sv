// The addresses of the stamps between their depth read and their depth write.
//
// In       look-up of an address; insert (with insert_i) and remove the oldest (with remove_i).
// Out      hit_o: the address is in flight; an entry removed in this cycle still hits.
//          full_o: no insertion in this cycle. insert_at_o: the place of the next insertion; places
//          come round in order, and an address can be read at its place until it is removed.
// Rate     one look-up, one insertion, one removal, one read a cycle.
// Errors   none; the user neither inserts when full nor removes when empty.
module inflight_table #(
  parameter int unsigned Width = 26,
  parameter int unsigned Depth = 72
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             lookup_i,
  input  logic [Width-1:0] address_i,
  output logic             hit_o,
  output logic             full_o,
  output logic             empty_o,

  input  logic             insert_i,
  output logic [$clog2(Depth)-1:0]  insert_at_o,
  input  logic             remove_i,

  input  logic [$clog2(Depth)-1:0]  place_i,
  output logic [Width-1:0]          address_o
);
  localparam int unsigned PTR_BITS = $clog2(Depth);
  localparam logic [PTR_BITS-1:0] LAST = PTR_BITS'(Depth - 1);

  logic [Width-1:0] address_q [Depth];
  logic [Depth-1:0] inflight_q;
  logic [PTR_BITS-1:0] insert_q;
  logic [PTR_BITS-1:0] remove_q;

  assign full_o = inflight_q[insert_q];
  assign empty_o = inflight_q == '0;
  assign insert_at_o = insert_q;
  assign address_o = address_q[place_i];

  logic hit;
  always_comb begin
    hit = 1'b0;
    if (lookup_i) begin
      for (int unsigned i = 0; i < Depth; i++) begin
        hit = hit | (inflight_q[i] && address_q[i] == address_i);
      end
    end
  end
  assign hit_o = hit;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      insert_q <= '0;
      remove_q <= '0;
      inflight_q <= '0;
    end else begin
      if (insert_i) begin
        inflight_q[insert_q] <= 1'b1;
        insert_q <= insert_q == LAST ? '0 : insert_q + PTR_BITS'(1);
      end
      if (remove_i) begin
        inflight_q[remove_q] <= 1'b0;
        remove_q <= remove_q == LAST ? '0 : remove_q + PTR_BITS'(1);
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (insert_i) address_q[insert_q] <= address_i;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(insert_i && full_o)) else $error("a stamp enters a full in-flight table");
      assert (!(remove_i && empty_o)) else $error("a stamp leaves an empty in-flight table");
    end
  end
`endif
endmodule
