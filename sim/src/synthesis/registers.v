// A word of flip-flops as a box, for what need not look into it.
(* blackbox *)
module REGISTERS (C, D, Q);
  parameter WIDTH = 1;
  input C;
  input [WIDTH-1:0] D;
  output [WIDTH-1:0] Q;
endmodule
