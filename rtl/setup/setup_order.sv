// Values of a triangle's vertices in canonical order: the anchor's first, then clockwise. No state.
module setup_order #(
  parameter int unsigned Width = 1
) (
  input  logic                valid_i,
  input  logic [1:0]          anchor_i,
  input  logic                clockwise_i, // as the vertices were given
  input  logic [3*Width-1:0]  given_i,     // vertex 0 lowest
  output logic [3*Width-1:0]  ordered_o
);
  logic [Width-1:0] value0, value1, value2;
  logic [Width-1:0] anchor, next, previous;
  assign {value2, value1, value0} = given_i;
  always_comb begin
    {anchor, next, previous} = 'x;
    ordered_o = 'x;
    if (valid_i) begin
      case (anchor_i)
        2'd0:    {anchor, next, previous} = {value0, value1, value2};
        2'd1:    {anchor, next, previous} = {value1, value2, value0};
        default: {anchor, next, previous} = {value2, value0, value1};
      endcase
      ordered_o = clockwise_i ? {previous, next, anchor} : {next, previous, anchor};
    end
  end
endmodule
