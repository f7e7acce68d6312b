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
  // 'x while no value is there: it costs no gate and saves the simulator work.
  always_comb begin
    length_o = 'x;
    if (valid_i) begin
      length_o = '0;
      for (int unsigned i = 0; i < Width; i++) begin
        if (value_i[i]) length_o = LengthBits'(i + 1);
      end
    end
  end
  assign aligned_o = value_i << (LengthBits'(Width) - length_o);
endmodule
