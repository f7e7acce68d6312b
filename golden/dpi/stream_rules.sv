// The rules of a ready/valid stream, as assertions. Bind one to each stream:
//
//   bind setup_unit stream_rules #(.Bits($bits(prim_o))) u_prim_rules (
//     .clk_i, .rst_ni, .valid_i(prim_valid_o), .ready_i(prim_ready_i), .data_i(prim_o));
//
// In       the stream's signals. Reset is asynchronous, as in the units.
// Errors   a token that is offered must stay, unchanged, until it is taken; nothing is offered while
//          rst_ni is low; valid and the payload of a valid token are known.
module stream_rules #(
  parameter int unsigned Bits = 1
) (
  input logic            clk_i,
  // Registers are reset by it, assertions look at it.
  /* verilator lint_off SYNCASYNCNET */
  input logic            rst_ni,
  /* verilator lint_on SYNCASYNCNET */
  input logic            valid_i,
  input logic            ready_i,
  input logic [Bits-1:0] data_i
);
  logic waits_q;
  logic [Bits-1:0] data_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waits_q <= 1'b0;
    else waits_q <= valid_i && !ready_i;
  end
  always_ff @(posedge clk_i) data_q <= data_i;

  a_stays: assert property (@(posedge clk_i) disable iff (!rst_ni) waits_q |-> valid_i)
    else $error("%m: a token that was offered is gone before it was taken");
  a_stable: assert property (@(posedge clk_i) disable iff (!rst_ni) waits_q |-> data_i == data_q)
    else $error("%m: a token changes while it waits");
  a_reset: assert property (@(posedge clk_i) !rst_ni |-> !valid_i)
    else $error("%m: a token is offered during reset");
  a_known: assert property (@(posedge clk_i) disable iff (!rst_ni) !$isunknown(valid_i)
                            && (!valid_i || !$isunknown(data_i)))
    else $error("%m: a token is not known");
endmodule
