// Where enums.fst comes from: Verilator 5.006, which wrote it with
//   $ verilator --binary --timing --trace-fst --top enums enums.sv; obj_dir/Venums
module enums;
  typedef enum logic [1:0] {IDLE, RUN, DONE} state_t;
  state_t state = IDLE;
  logic a = 0;
  initial begin
    $dumpfile("enums.fst");
    $dumpvars;
    #5 state = RUN; a = 1;
    #5 state = DONE;
    #5 state = state_t'(2'b11);
    #5 $finish;
  end
endmodule
