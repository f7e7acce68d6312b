// A FIFO between two ready/valid streams. Depth 0: wires.
//
// In       in_data_i, taken when in_valid_i && in_ready_o.
// Out      out_data_o, stable while out_valid_o && !out_ready_i.
// Rate     a slot filled in a cycle is seen in the next one, as is one freed: so one token a cycle from
//          depth 2 on, and never a combinational path through it.
// Errors   none: a full FIFO is not ready, an empty one not valid.
module stream_fifo #(
  parameter int unsigned Width = 8,
  parameter int unsigned Depth = 4
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [Width-1:0] in_data_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [Width-1:0] out_data_o
);
  localparam int unsigned PTR_BITS = Depth > 1 ? $clog2(Depth) : 1;
  localparam int unsigned COUNT_BITS = Depth > 0 ? $clog2(Depth + 1) : 1;
  logic [COUNT_BITS-1:0] count_q;
  if (Depth == 0) begin : g_wires
    assign count_q = '0;
    assign in_ready_o = out_ready_i;
    assign out_valid_o = in_valid_i;
    assign out_data_o = in_data_i;
  end else begin : g_slots
    localparam logic [PTR_BITS-1:0] LAST = PTR_BITS'(Depth - 1);
    localparam logic [COUNT_BITS-1:0] FULL = COUNT_BITS'(Depth);
    logic [Width-1:0] mem [Depth];
    logic [PTR_BITS-1:0] write_q;
    logic [PTR_BITS-1:0] read_q;
    logic push;
    logic pop;

    assign in_ready_o  = count_q != FULL;
    assign out_valid_o = count_q != '0;
    assign out_data_o  = mem[read_q];
    assign push = in_valid_i && in_ready_o;
    assign pop  = out_valid_o && out_ready_i;

    always_ff @(posedge clk_i) begin
      if (push) mem[write_q] <= in_data_i;
    end

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        write_q <= '0;
        read_q  <= '0;
        count_q <= '0;
      end else begin
        if (push) write_q <= write_q == LAST ? '0 : write_q + PTR_BITS'(1);
        if (pop)  read_q  <= read_q == LAST ? '0 : read_q + PTR_BITS'(1);
        count_q <= count_q + COUNT_BITS'(push) - COUNT_BITS'(pop);
      end
    end
  end
endmodule
