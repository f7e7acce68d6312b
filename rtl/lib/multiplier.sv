// A signed product, and a number added to it. No state.
//
// For cells it is built of radix-4 Booth digits: half as many rows as b_i has bits, which is a fifth
// smaller than what Yosys makes of `*`. Simulators are quicker with `*`, and an FPGA (PINEDA_DSP) has
// blocks for it.
module multiplier #(
  parameter int unsigned ABits = 2,
  parameter int unsigned BBits = 2
) (
  input  logic signed [ABits-1:0]        a_i,
  input  logic signed [BBits-1:0]        b_i,
  input  logic [ABits+BBits-1:0]         addend_i,
  output logic signed [ABits+BBits-1:0]  product_o
);
`ifdef SYNTHESIS
`ifndef PINEDA_DSP
`define PINEDA_BOOTH
`endif
`endif
`ifdef PINEDA_BOOTH
  localparam int unsigned BITS = ABits + BBits;
  localparam int unsigned ROWS = (BBits + 1) / 2 + 3;
  logic [ROWS*BITS-1:0] rows;
  booth_rows #(.ABits(ABits), .BBits(BBits)) u_rows (.a_i, .b_i, .addend_i, .rows_o(rows));
  always_comb begin
    product_o = '0;
    for (int unsigned row = 0; row < ROWS; row++) product_o = product_o + rows[row*BITS +: BITS];
  end
`else
  assign product_o = (ABits+BBits)'(a_i) * (ABits+BBits)'(b_i) + signed'(addend_i);
`endif
endmodule
