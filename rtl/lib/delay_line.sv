// A value as it was Depth enabled cycles ago. Depth 0: a wire.
module delay_line #(
  parameter int unsigned Width = 1,
  parameter int unsigned Depth = 1
) (
  input  logic              clk_i,
  input  logic              enable_i,
  input  logic [Width-1:0]  data_i,
  output logic [Width-1:0]  data_o
);
  if (Depth == 0) begin : g_wire
    assign data_o = data_i;
  end else if (Depth == 1) begin : g_register
    logic [Width-1:0] data_q;
    always_ff @(posedge clk_i) begin
      if (enable_i) data_q <= data_i;
    end
    assign data_o = data_q;
  end else begin : g_line
    logic [Depth*Width-1:0] line_q; // the newest lowest
    always_ff @(posedge clk_i) begin
      if (enable_i) line_q <= {line_q[(Depth-1)*Width-1:0], data_i};
    end
    assign data_o = line_q[(Depth-1)*Width +: Width];
  end
endmodule
