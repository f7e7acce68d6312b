// A signed product, and a number added to it. No state.
//
// For cells it is built of radix-4 Booth digits: half as many rows as b_i has bits, each 0, 1 or
// 2 times a_i, added or subtracted. That is a fifth smaller than what Yosys makes of `*`. Simulators
// are quicker with `*`, and an FPGA (PINEDA_DSP) has blocks for it.
//
// Source   MacSorley, "High-Speed Arithmetic in Binary Computers", Proc. IRE 49, 1961.
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
  localparam int unsigned DIGITS = (BBits + 1) / 2;

  // A row has the weight 4^digit and is a number of ABits + 1 bits with a sign, without the 1 that
  // completes a negation. Its sign bit is sent inverted, which adds 2^ABits: the first sum takes
  // that off again for all rows.
  function automatic logic [BITS-1:0] all_signs();
    all_signs = '0;
    for (int unsigned digit = 0; digit < DIGITS; digit++) begin
      all_signs = all_signs - (BITS'(1) << (ABits + 2 * digit));
    end
  endfunction
  localparam logic [BITS-1:0] SIGNS = all_signs();

  logic [2*DIGITS:0] b; // with its sign twice where it has an odd number of bits, and a 0 below
  assign b = {(2*DIGITS)'(b_i), 1'b0};
  always_comb begin
    product_o = SIGNS + addend_i;
    for (int unsigned digit = 0; digit < DIGITS; digit++) begin
      logic one, two, negative;
      logic [ABits:0] row;
      one = b[2*digit+1] ^ b[2*digit];
      two = b[2*digit+2] ? !b[2*digit+1] && !b[2*digit] : b[2*digit+1] && b[2*digit];
      negative = b[2*digit+2];
      row = (({a_i[ABits-1], a_i} & {(ABits+1){one}}) | ({a_i, 1'b0} & {(ABits+1){two}})) ^
            {(ABits+1){negative}};
      row[ABits] = !row[ABits];
      product_o = product_o + (BITS'(row) << (2 * digit)) + (BITS'(negative) << (2 * digit));
    end
  end
`else
  assign product_o = (ABits+BBits)'(a_i) * (ABits+BBits)'(b_i) + signed'(addend_i);
`endif
endmodule
