// A signed product and a number added to it, as rows that add up to it modulo 2^RowBits: radix-4 Booth
// digits of b_i, each 0, 1 or 2 times a_i, added or subtracted. No state.
//
// Source   MacSorley, "High-Speed Arithmetic in Binary Computers", Proc. IRE 49, 1961.
module booth_rows #(
  parameter int unsigned ABits = 2,
  parameter int unsigned BBits = 2,
  parameter int unsigned RowBits = ABits + BBits,
  localparam int unsigned DIGITS = (BBits + 1) / 2,
  localparam int unsigned ROWS = DIGITS + 3
) (
  input  logic signed [ABits-1:0]   a_i,
  input  logic signed [BBits-1:0]   b_i,
  input  logic [RowBits-1:0]        addend_i,
  output logic [ROWS*RowBits-1:0]   rows_o
);
  // A digit's row has the weight 4^digit and is a number of ABits + 1 bits with a sign, without the 1
  // that completes a negation: these form a row of their own. Its sign bit is sent inverted, which
  // adds 2^ABits: one row takes that off again for all.
  function automatic logic [RowBits-1:0] all_signs();
    all_signs = '0;
    for (int unsigned digit = 0; digit < DIGITS; digit++) begin
      all_signs = all_signs - (RowBits'(1) << (ABits + 2 * digit));
    end
  endfunction
  localparam logic [RowBits-1:0] SIGNS = all_signs();

  logic [2*DIGITS:0] b; // with its sign twice where it has an odd number of bits, and a 0 below
  assign b = {(2*DIGITS)'(b_i), 1'b0};
  always_comb begin
    logic [RowBits-1:0] negatives;
    negatives = '0;
    for (int unsigned digit = 0; digit < DIGITS; digit++) begin
      logic one, two, negative;
      logic [ABits:0] row;
      one = b[2*digit+1] ^ b[2*digit];
      two = b[2*digit+2] ? !b[2*digit+1] && !b[2*digit] : b[2*digit+1] && b[2*digit];
      negative = b[2*digit+2];
      row = (({a_i[ABits-1], a_i} & {(ABits+1){one}}) | ({a_i, 1'b0} & {(ABits+1){two}})) ^
            {(ABits+1){negative}};
      row[ABits] = !row[ABits];
      rows_o[digit*RowBits +: RowBits] = RowBits'(row) << (2 * digit);
      negatives = negatives | (RowBits'(negative) << (2 * digit));
    end
    rows_o[DIGITS*RowBits +: RowBits] = negatives;
    rows_o[(DIGITS+1)*RowBits +: RowBits] = SIGNS;
    rows_o[(DIGITS+2)*RowBits +: RowBits] = addend_i;
  end
endmodule
