// A signed product and a number added to it, one a cycle, in one or two cycles.
//
// In       valid_i: which of its cycles have a product.
// Out      product_o modulo 2^ProductBits, Stages enabled cycles later.
//
// For cells the rows of multiplier are added without carries before the register between two cycles:
// three numbers become two, a sum and carries, until two are left, which the second cycle adds.
//
// Source   Wallace, "A Suggestion for a Fast Multiplier", IEEE Trans. Electron. Comput. 13, 1964.
module multiplier_pipelined #(
  parameter int unsigned ABits = 2,
  parameter int unsigned BBits = 2,
  parameter int unsigned ProductBits = ABits + BBits,
  parameter int unsigned Stages = pineda_pkg::MULTIPLIER_STAGES
) (
  input  logic                           clk_i,
  input  logic                           enable_i,

  input  logic [Stages-1:0]              valid_i,
  input  logic signed [ABits-1:0]        a_i,
  input  logic signed [BBits-1:0]        b_i,
  input  logic [ProductBits-1:0]         addend_i,

  output logic signed [ProductBits-1:0]  product_o
);
`ifdef SYNTHESIS
`ifndef PINEDA_DSP
`define PINEDA_BOOTH
`endif
`endif
  logic signed [ProductBits-1:0] product, product_q;
  assign product_o = product_q;
  always_ff @(posedge clk_i) begin
    if (enable_i && valid_i[Stages-1]) product_q <= product;
  end

`ifdef PINEDA_BOOTH
  localparam int unsigned ROWS = (BBits + 1) / 2 + 3;
  logic [ROWS*ProductBits-1:0] rows;
  booth_rows #(.ABits(ABits), .BBits(BBits), .RowBits(ProductBits)) u_rows (
    .a_i, .b_i, .addend_i, .rows_o(rows)
  );
  if (Stages == 1) begin : g_one
    always_comb begin
      product = '0;
      for (int unsigned row = 0; row < ROWS; row++) begin
        product = product + rows[row*ProductBits +: ProductBits];
      end
    end
  end else begin : g_two
    logic [ROWS*ProductBits-1:0] sums;
    always_comb begin
      sums = rows;
      for (int unsigned left = ROWS; left > 2; left = left - left / 3) begin
        for (int unsigned i = 0; i < left / 3; i++) begin
          logic [ProductBits-1:0] x, y, z;
          x = sums[3*i*ProductBits +: ProductBits];
          y = sums[(3*i+1)*ProductBits +: ProductBits];
          z = sums[(3*i+2)*ProductBits +: ProductBits];
          sums[2*i*ProductBits +: ProductBits] = x ^ y ^ z;
          sums[(2*i+1)*ProductBits +: ProductBits] = ((x & y) | (x & z) | (y & z)) << 1;
        end
        for (int unsigned i = 0; i < left % 3; i++) begin
          sums[(2*(left/3)+i)*ProductBits +: ProductBits] =
              sums[(3*(left/3)+i)*ProductBits +: ProductBits];
        end
      end
    end
    logic [ProductBits-1:0] sum_q, carries_q;
    always_ff @(posedge clk_i) begin
      if (enable_i && valid_i[0]) {carries_q, sum_q} <= sums[2*ProductBits-1:0];
    end
    assign product = sum_q + carries_q;
  end
`else
  logic signed [ProductBits-1:0] whole;
  assign whole = ProductBits'(a_i) * ProductBits'(b_i) + signed'(addend_i);
  if (Stages == 1) begin : g_one
    assign product = whole;
  end else begin : g_two
    logic signed [ProductBits-1:0] whole_q;
    always_ff @(posedge clk_i) begin
      if (enable_i && valid_i[0]) whole_q <= whole;
    end
    assign product = whole_q;
  end
`endif
endmodule
