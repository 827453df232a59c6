// Where counter.vcd and counter.fst come from: Icarus Verilog 11.0, which wrote them with
//   iverilog -g2005 -o counter counter.v && vvp -n counter        (VCD)
//   iverilog -g2005 -o counter counter.v && vvp -n counter -fst   (FST, renamed)
// A counter with a signed fraction beside it, unknown before reset; inputs change between the edges of the clock.
`timescale 1ns/1ps
module counter(input wire clock, input wire reset, input wire enable, output reg [3:0] count, output reg signed [7:0] wave);
  wire full = &count;
  always @(posedge clock)
    if (reset) begin count <= 0; wave <= -8'sd64; end
    else if (enable) begin count <= count + 1; wave <= wave + 8'sd20; end
endmodule
module bench;
  reg clock = 0, reset = 1, enable = 1;
  wire [3:0] count;
  wire signed [7:0] wave;
  counter dut(.clock(clock), .reset(reset), .enable(enable), .count(count), .wave(wave));
  always #5 clock = ~clock;
  initial begin
    $dumpfile("counter.vcd");
    $dumpvars(0, bench);
    #12 reset = 0;
    #60 enable = 0;
    #23 enable = 1;
    #60 $finish;
  end
endmodule
