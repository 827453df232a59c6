// Words of flip-flops as the device's.
module REGISTERS (C, D, Q);
  parameter WIDTH = 1;
  input C;
  input [WIDTH-1:0] D;
  output [WIDTH-1:0] Q;
  genvar bit;
  generate
    for (bit = 0; bit < WIDTH; bit = bit + 1) begin : bits
      TRELLIS_FF flip_flop (.CLK(C), .DI(D[bit]), .Q(Q[bit]));
    end
  endgenerate
endmodule
