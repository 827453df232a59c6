// What synthesis makes the memory for pixels of on an ECP5, a DP16KD, beside what it is to be.
`default_nettype none

module block_ram;
  reg clock = 1'b0;
  always #5 clock = ~clock;

  reg write, read, move;
  reg [`LOG2_DEPTH-1:0] write_place, read_place;
  reg [23:0] write_data;
  wire [23:0] data;
  shader_block_memory #(
      .WIDTH(24),
      .LOG2_DEPTH(`LOG2_DEPTH)
  ) memory (
      .clock(clock),
      .write(write),
      .write_place(write_place),
      .write_data(write_data),
      .read(read),
      .read_place(read_place),
      .move(move),
      .data(data)
  );

  reg [23:0] places[0:(1<<`LOG2_DEPTH)-1];
  reg [23:0] word, moved;
  always @(posedge clock) begin
    if (write) places[write_place] <= write_data;
    if (read) word <= places[read_place];
    if (move) moved <= word;
  end

  integer i, seed;
  initial begin
    seed = 1;
    {write, read, move} = 3'b000;
    // Every place is written before any is read.
    for (i = 0; i < 20000; i = i + 1) begin
      @(negedge clock);
      if (i > (1 << `LOG2_DEPTH) + 2 && data !== moved) begin
        $display("FAIL: clock %0d: %h, not %h", i, data, moved);
        $finish;
      end
      write = i < (1 << `LOG2_DEPTH) || $random(seed);
      write_place = i < (1 << `LOG2_DEPTH) ? i : $random(seed);
      write_data = $random(seed);
      read = i >= (1 << `LOG2_DEPTH) && (i == (1 << `LOG2_DEPTH) || $random(seed));
      move = i > (1 << `LOG2_DEPTH) && (i == (1 << `LOG2_DEPTH) + 1 || $random(seed));
      // A pixel is not written where one is read.
      read_place = $random(seed);
      if (read_place == write_place) read_place = read_place + 1;
    end
    $display("PASS");
    $finish;
  end
endmodule

`default_nettype wire
