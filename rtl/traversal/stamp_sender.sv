// The stamps of a group that have a covered sample, one after the other from the left.
//
// In       group_i: their masks, the left one's lowest, not all empty; stamp_i: what they share, and
//          the column of the group's first stamp.
// Out      stamp_o.
// Rate     a stamp a cycle, from one group to the next without a bubble.
module stamp_sender (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                group_valid_i,
  output logic                group_ready_o,
  input  logic [(pineda_pkg::LANES<<pineda_pkg::TESTED_STAMPS_LOG2)-1:0]  group_i,
  input  pineda_pkg::stamp_t  stamp_i,

  output logic                stamp_valid_o,
  input  logic                stamp_ready_i,
  output pineda_pkg::stamp_t  stamp_o,

  output logic                idle_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned STAMPS = 1 << pineda_pkg::TESTED_STAMPS_LOG2;

  logic valid_q;
  logic [STAMPS*LANES-1:0] group_q; // what is left of it
  pineda_pkg::stamp_t stamp_q;

  // ---- The leftmost stamp that is left
  logic [STAMPS*LANES-1:0] rest; // without it
  logic [LANES-1:0] mask;
  logic [pineda_pkg::STAMP_X_BITS-1:0] place;
  always_comb begin
    mask = '0;
    place = '0;
    rest = group_q;
    for (int unsigned i = 0; i < STAMPS; i++) begin
      if (mask == '0) begin
        mask = group_q[i*LANES +: LANES];
        place = pineda_pkg::STAMP_X_BITS'(i);
        rest[i*LANES +: LANES] = '0;
      end
    end
  end
  always_comb begin
    stamp_o = stamp_q;
    stamp_o.x = stamp_q.x | place; // groups are aligned
    stamp_o.mask = mask;
  end

  logic sent;
  assign sent = valid_q && stamp_ready_i;
  assign stamp_valid_o = valid_q;
  assign group_ready_o = !valid_q || (stamp_ready_i && rest == '0);
  assign idle_o = !valid_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (group_ready_o) valid_q <= group_valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (group_valid_i && group_ready_o) begin
      group_q <= group_i;
      stamp_q <= stamp_i;
    end else if (sent) begin
      group_q <= rest;
      stamp_q.first <= 1'b0;
    end
  end

`ifdef PINEDA_COUNTERS
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1),
    .kind_i(!valid_q ? cycle_cause_pkg::STARVED :
            stamp_ready_i ? cycle_cause_pkg::BUSY : cycle_cause_pkg::BLOCKED)
  );
  // Stamps sent, by covered samples
  cycle_counters #(.Kinds(LANES + 1)) u_sent (
    .clk_i, .count_i(sent), .kind_i($clog2(LANES + 1)'($countones(mask)))
  );
`endif
endmodule
