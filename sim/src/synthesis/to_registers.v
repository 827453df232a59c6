// Yosys's flip-flops without reset and enable, as boxes.
(* techmap_celltype = "$dff" *)
module to_registers (CLK, D, Q);
  parameter WIDTH = 1;
  parameter CLK_POLARITY = 1;
  input CLK;
  input [WIDTH-1:0] D;
  output [WIDTH-1:0] Q;
  REGISTERS #(.WIDTH(WIDTH)) _TECHMAP_REPLACE_ (.C(CLK), .D(D), .Q(Q));
endmodule
