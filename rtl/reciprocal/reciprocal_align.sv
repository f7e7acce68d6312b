// A number's bit length, and the number with its leading one at the top. No state.
//
// In       value_i > 0 while valid_i.
module reciprocal_align #(
  parameter int unsigned Width = 1,
  parameter int unsigned LengthBits = $clog2(Width + 1)
) (
  input  logic                   valid_i,
  input  logic [Width-1:0]       value_i,
  output logic [LengthBits-1:0]  length_o,
  output logic [Width-1:0]       aligned_o
);
  // By half of the bits that are left, where these are all zero, then by half of that. 'x while no
  // value is there: it costs no gate and saves the simulator work.
  logic [LengthBits-1:0] shift;
  always_comb begin
    shift = '0;
    aligned_o = 'x;
    length_o = 'x;
    if (valid_i) begin
      aligned_o = value_i;
      for (int k = $clog2(Width) - 1; k >= 0; k--) begin
        shift[k] = (aligned_o >> (Width - (1 << k))) == '0;
        if (shift[k]) aligned_o = aligned_o << (1 << k);
      end
      length_o = LengthBits'(Width) - shift;
    end
  end
endmodule
