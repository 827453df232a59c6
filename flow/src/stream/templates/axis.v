@ABOUT@
//
// The stream top of the core @NAME@. Span packets go in, a word a clock, and their pixels come out.
//
// s_axis: a packet of @WORDS@ words of @WORD@ bits for each span, `tlast` with its last word. @LAYOUT@ has
// every bit of it. The next packet is taken in while a span is shaded. A packet that is too short, too
// long, or of a number of pixels outside 1 to @LONGEST@ is skipped as a whole: `error` says so until
// `clear_error`.
// m_axis: a pixel in each transfer, red in bits 0 to 7, green in 8 to 15, blue in 16 to 23@POSITION_ABOUT@.
// `tuser` is high with the first pixel of a frame, `tlast` with the last one of a span.
//
// The core runs freely. A pixel enters it only where there is room for it in the memory behind it, so
// `tready` may fall in any clock.@FRAME_ABOUT@
`default_nettype none

module @NAME@_axis #(
    // The memory for pixels under way has room for 2^LOG2_DEPTH - 1 of them. @NAME@ needs @DEPTH_NEEDED@ for its full
    // speed of a pixel in @CLOCKS_A_PIXEL@.
    parameter LOG2_DEPTH = @LOG2_DEPTH@
) (
    input wire aclk,
    input wire aresetn,  // synchronous, low

    input  wire [@WORD_TOP@:0] s_axis_tdata,
    input  wire        s_axis_tvalid,
    output wire        s_axis_tready,
    input  wire        s_axis_tlast,

    output wire [@PIXEL_TOP@:0] m_axis_tdata,
    output wire        m_axis_tvalid,
    input  wire        m_axis_tready,
    output wire        m_axis_tuser,
    output wire        m_axis_tlast,

?frames|    // Inputs that hold for a frame: they change in the clock after `frame`, and in no other.
?frames|@FRAME_PORTS@
    output wire frame,  // a frame begins

    output reg  [2:0] error,  // packets that were skipped: [0] too short, [1] too long, [2] pixels
    input  wire       clear_error,
    output reg        busy,    // a packet is waiting, shaded, or not wholly sent
    output wire       blocked, // this clock a span waits, since pixels are not taken
    output wire       starved  // this clock there is no span
);
  wire reset;
  @NAME@_reset reset_high (
      .low(aresetn),
      .high(reset)
  );

  // The next packet, as soon as it is whole.
  wire [@PACKET_TOP@:0] packet;
  wire single;
  wire full;
  wire load;
  wire [2:0] skipped;
  wire lost_last;

  @NAME@_packets packets (
      .clock(aclk),
      .reset(reset),
      .word(s_axis_tdata),
      .word_valid(s_axis_tvalid),
      .word_ready(s_axis_tready),
      .word_last(s_axis_tlast),
      .packet(packet),
      .single(single),
      .full(full),
      .take(load),
      .skipped(skipped),
      .lost_last(lost_last)
  );

  always @(posedge aclk) begin
    if (reset) error <= 3'd0;
    else error <= (clear_error ? 3'd0 : error) | skipped;
  end

  // The span that is shaded.
  reg shading;
?inputs|  reg [@PACKET_TOP@:@HEADER_BITS@] span;
?positions|  reg [15:0] x;
?positions|  reg [15:0] y;
  reg [@COUNT_TOP@:0] left;  // pixels that have not entered
  reg at_last;  // left is 1
  reg at_first;  // no pixel has entered
  reg at_frame;  // the next span begins a frame
  reg of_frame;  // the next pixel begins a frame

  // A pixel enters where there is room for it.
  reg room;
?slots|  reg [1:0] slot;  // of the @INTERVAL@ clocks of a pixel
?slots|  wire first_slot = slot == 2'd0;
?slots|  wire last_slot = slot == 2'd@LAST_SLOT@;
?slots|  wire enter = shading & (room | ~first_slot);
?slots|  wire spend = enter & first_slot;
?slots|  wire complete = enter & last_slot;
!slots|  wire enter = shading & room;
!slots|  wire spend = enter;
!slots|  wire complete = enter;
  wire span_done = complete & at_last;

?frames|  // Before a frame the pipeline drains; then the inputs that hold for the frame are taken over.
?frames|`ifdef FORMAL
?frames|  localparam DRAIN = @FORMAL_DRAIN@;  // of the pipeline in place of the core
?frames|`else
?frames|  localparam DRAIN = @DRAIN@;
?frames|`endif
?frames|  reg taken;
?frames|  reg [@DRAIN_TOP@:0] drain;  // clocks until the last pixel has left, or the inputs have settled
?frames|  reg drained;
?frames|  assign frame = full & at_frame & ~taken & ~shading & drained;
?frames|  assign load = full & (~at_frame | (taken & drained)) & (~shading | span_done);
!frames|  assign frame = load & at_frame;
!frames|  assign load = full & (~shading | span_done);

?frames|  always @(posedge aclk) begin
?frames|    if (reset) taken <= 1'b0;
?frames|    else if (frame) taken <= 1'b1;
?frames|    else if (load) taken <= 1'b0;
?frames|    if (reset) begin
?frames|      drain <= @DRAIN_WIDTH@'d0;
?frames|      drained <= 1'b1;
?frames|    end else if (enter) begin
?frames|      drain <= DRAIN[@DRAIN_TOP@:0];
?frames|      drained <= 1'b0;
?frames|    end else if (frame) begin
?frames|      drain <= @DRAIN_WIDTH@'d@SETTLING@;
?frames|      drained <= 1'b@SETTLED@;
?frames|    end else if (~drained) begin
?frames|      drain <= drain - @DRAIN_WIDTH@'d1;
?frames|      drained <= drain == @DRAIN_WIDTH@'d1;
?frames|    end
?frames|  end

  always @(posedge aclk) begin
    if (reset) shading <= 1'b0;
    else if (load) shading <= 1'b1;
    else if (span_done) shading <= 1'b0;

    if (reset) at_frame <= 1'b1;
    else if (load) at_frame <= packet[16];
    else if (lost_last) at_frame <= 1'b1;

?slots|    if (load) slot <= 2'd0;
?slots|    else if (enter) slot <= last_slot ? 2'd0 : slot + 2'd1;
?slots|
    if (load) begin
?inputs|      span <= packet[@PACKET_TOP@:@HEADER_BITS@];
?positions|      x <= packet[47:32];
?positions|      y <= packet[63:48];
      left <= packet[@COUNT_TOP@:0];
      at_last <= single;
      at_first <= 1'b1;
      of_frame <= at_frame;
    end else if (complete) begin
?positions|      x <= x + 16'd1;
      left <= left - @COUNT_BITS@'d1;
      at_last <= left == @COUNT_BITS@'d2;
      at_first <= 1'b0;
      of_frame <= 1'b0;
    end
  end

  // Places in the memory for pixels: one is spent with each pixel that enters, and free again when it
  // has been sent.
  reg [LOG2_DEPTH-1:0] places;
  wire freed;

  always @(posedge aclk) begin
    if (reset) begin
      places <= {LOG2_DEPTH{1'b1}};
      room <= 1'b1;
    end else begin
      if (freed ^ spend) places <= places + {{LOG2_DEPTH - 1{~freed}}, 1'b1};  // 1 more or 1 less
      room <= freed | (|places[LOG2_DEPTH-1:1]) | (places[0] & ~spend);
    end
  end

  // The core.
  wire leaves;
@CHANNELS@

  @NAME@ core (
@CORE_PINS@
  );

  @NAME@_pixels #(
      .LOG2_DEPTH(LOG2_DEPTH)
  ) pixels (
      .clock(aclk),
      .reset(reset),
      .enters(spend),
?positions|      .tag({y, x, of_frame, at_last}),
!positions|      .tag({of_frame, at_last}),
      .leaves(leaves),
      .colour({@BLUE@, @GREEN@, @RED@}),
      .freed(freed),
      .m_axis_tdata(m_axis_tdata),
      .m_axis_tvalid(m_axis_tvalid),
      .m_axis_tready(m_axis_tready),
      .m_axis_tuser(m_axis_tuser),
      .m_axis_tlast(m_axis_tlast)
  );

  always @(posedge aclk) busy <= ~reset & (full | shading | ~(&places));
?slots|  assign blocked = shading & ~room & first_slot;
!slots|  assign blocked = shading & ~room;
  assign starved = ~shading;

  // The rest of the header is 0, as are counts above @LONGEST@, and above some inputs stand copies of their highest bit.
  wire unused_bits = &{1'b0, packet[31:17]@UNUSED_COUNT@@UNUSED_INPUTS@};

  // What is proven of all this, in @NAME@_formal.v.
`ifdef FORMAL
  @NAME@_properties #(
      .LOG2_DEPTH(LOG2_DEPTH)
  ) properties (
      .clock(aclk),
      .reset(reset),
      .word(s_axis_tdata),
      .accept(s_axis_tvalid & s_axis_tready),
      .word_last(s_axis_tlast),
      .packet(packet),
      .full(full),
      .load(load),
      .skipped(skipped),
      .lost_last(lost_last),
      .shading(shading),
      .left(left),
      .at_last(at_last),
      .at_first(at_first),
      .at_frame(at_frame),
      .of_frame(of_frame),
      .frame(frame),
      .enter(enter),
      .spend(spend),
      .complete(complete),
      .leaves(leaves),
      .freed(freed),
      .places(places),
?positions|      .tag({y, x, of_frame, at_last}),
!positions|      .tag({of_frame, at_last}),
      .pixel(m_axis_tdata),
      .pixel_valid(m_axis_tvalid),
      .pixel_ready(m_axis_tready),
      .pixel_first(m_axis_tuser),
      .pixel_last(m_axis_tlast)
  );
`endif
endmodule

// Modules of the stream top follow; they stand in its file so that one file is the whole of it.
// verilator lint_off DECLFILENAME

// @NAME@_packets: words are put together, and packets that are none skipped.
module @NAME@_packets (
    input wire clock,
    input wire reset,

    input  wire [@WORD_TOP@:0] word,
    input  wire        word_valid,
    output wire        word_ready,
    input  wire        word_last,

    output reg  [@PACKET_TOP@:0] packet,
    output reg         single,  // it is of one pixel
    output reg         full,  // the packet is whole
    input  wire        take,

    output reg  [2:0] skipped,   // in the clock before: too short, too long, wrong number of pixels
    output reg        lost_last  // what was skipped was to be the last span of its frame
);
  reg [@WORDS_TOP@:0] at;  // one-hot: the word that comes next
  reg skipping;  // up to the next `word_last`

  assign word_ready = ~full;
  wire accept = word_valid & word_ready;
  wire last = at[@WORDS_TOP@];

  // What the header says of the number of pixels@LATER@.
  wire over = word[15:@COUNT_BITS@] != @OVER_BITS@'d0;
?several|  reg is_over;
?several|  always @(posedge clock) if (accept & at[0]) is_over <= over;
?several|  wire [@COUNT_TOP@:0] count = packet[@COUNT_TOP@:0];
?several|  wire count_fits = ~is_over & count != @COUNT_BITS@'d0 & count <= @COUNT_BITS@'d@LONGEST@;
!several|  wire [@COUNT_TOP@:0] count = word[@COUNT_TOP@:0];
!several|  wire count_fits = ~over & count != @COUNT_BITS@'d0 & count <= @COUNT_BITS@'d@LONGEST@;
?long|  reg fits;
?long|  always @(posedge clock) fits <= count_fits;
!long|  wire fits = count_fits;

  wire ends = accept & ~skipping & (last | word_last);
  wire too_short = ends & ~last;
  wire too_long = ends & ~word_last;
  wire whole = ends & last & word_last;

  always @(posedge clock) begin
    if (reset) begin
      at <= @WORDS@'d1;
      skipping <= 1'b0;
      full <= 1'b0;
      skipped <= 3'd0;
      lost_last <= 1'b0;
    end else begin
?several|      if (accept & ~skipping) at <= (last | word_last) ? @WORDS@'d1 : at << 1;
      if (too_long) skipping <= 1'b1;
      else if (accept & word_last) skipping <= 1'b0;
      if (whole & fits) full <= 1'b1;
      else if (take) full <= 1'b0;
      skipped <= {whole & ~fits, too_long, too_short};
?several|      lost_last <= (ends & ~(last & word_last & fits)) & (at[0] ? word[16] : packet[16]);
!several|      lost_last <= (ends & ~(last & word_last & fits)) & word[16];
    end
?several|    single <= count == @COUNT_BITS@'d1;
!several|    if (accept) single <= count == @COUNT_BITS@'d1;
@TAKE_WORDS@
  end
?surplus|
?surplus|  // The last word is not all of it read.
?surplus|  wire unused_bits = &{1'b0, word[@WORD_TOP@:@SURPLUS@]};
endmodule

// @NAME@_pixels: pixels from when they enter the core until they have been sent, in their order. What
// belongs to a pixel is written in the clock after it enters, its colour when it leaves the core.
module @NAME@_pixels #(
    parameter LOG2_DEPTH = @LOG2_DEPTH@
) (
    input wire clock,
    input wire reset,

    input wire enters,
    input wire [@TAG_TOP@:0] tag,
    input wire leaves,
    input wire [23:0] colour,
    output reg freed,  // a place is free again

    output wire [@PIXEL_TOP@:0] m_axis_tdata,
    output reg         m_axis_tvalid,
    input  wire        m_axis_tready,
    output wire        m_axis_tuser,
    output wire        m_axis_tlast
);
  reg has_entered;  // a pixel has in the clock before
  reg [@TAG_TOP@:0] entered_tag;
  reg [LOG2_DEPTH-1:0] entering;  // the place of the pixel that enters next, or has just entered
  reg [LOG2_DEPTH-1:0] leaving;  // of the one that leaves the core next
  reg [LOG2_DEPTH-1:0] sending;  // of the one that is read next
  reg [LOG2_DEPTH-1:0] stored;  // pixels in the memory that have left the core
  reg waiting;  // there are any
  reg is_read;  // a pixel stands between the memory and the output
  wire [@TAG_TOP@:0] sent_tag;
  wire [23:0] sent_colour;

  wire move = is_read & (~m_axis_tvalid | m_axis_tready);
  wire read = waiting & (~is_read | ~m_axis_tvalid | m_axis_tready);

  @NAME@_@TAG_MEMORY@ #(
      .WIDTH(@TAG_BITS@),
      .LOG2_DEPTH(LOG2_DEPTH)
  ) tags (
      .clock(clock),
      .write(has_entered),
      .write_place(entering),
      .write_data(entered_tag),
      .read(read),
      .read_place(sending),
      .move(move),
      .data(sent_tag)
  );

  @NAME@_@COLOUR_MEMORY@ #(
      .WIDTH(24),
      .LOG2_DEPTH(LOG2_DEPTH)
  ) colours (
      .clock(clock),
      .write(leaves),
      .write_place(leaving),
      .write_data(colour),
      .read(read),
      .read_place(sending),
      .move(move),
      .data(sent_colour)
  );

  always @(posedge clock) begin
    if (reset) begin
      has_entered <= 1'b0;
      entering <= {LOG2_DEPTH{1'b0}};
      leaving <= {LOG2_DEPTH{1'b0}};
      sending <= {LOG2_DEPTH{1'b0}};
      stored <= {LOG2_DEPTH{1'b0}};
      waiting <= 1'b0;
      is_read <= 1'b0;
      m_axis_tvalid <= 1'b0;
      freed <= 1'b0;
    end else begin
      has_entered <= enters;
      if (has_entered) entering <= entering + 1'b1;
      if (leaves) leaving <= leaving + 1'b1;
      if (read) sending <= sending + 1'b1;
      if (leaves ^ read) stored <= stored + {{LOG2_DEPTH - 1{~leaves}}, 1'b1};  // 1 more or 1 less
      waiting <= leaves | (|stored[LOG2_DEPTH-1:1]) | (stored[0] & ~read);
      is_read <= read | (is_read & ~move);
      m_axis_tvalid <= move | (m_axis_tvalid & ~m_axis_tready);
      freed <= read;
    end
    entered_tag <= tag;
  end

?positions|  assign m_axis_tdata = {sent_tag[33:2], sent_colour};
!positions|  assign m_axis_tdata = sent_colour;
  assign m_axis_tuser = sent_tag[1];
  assign m_axis_tlast = sent_tag[0];
endmodule

// @NAME@_memory: banks of up to @BANK@ places, each with a register behind it, and a register behind all:
// paths are as short in a large memory as in a small one.
module @NAME@_memory #(
    parameter WIDTH = 24,
    parameter LOG2_DEPTH = @LOG2_DEPTH@
) (
    input wire clock,
    input wire write,
    input wire [LOG2_DEPTH-1:0] write_place,
    input wire [WIDTH-1:0] write_data,
    input wire read,  // into the registers of the banks
    input wire [LOG2_DEPTH-1:0] read_place,
    input wire move,  // into the last register
    output reg [WIDTH-1:0] data
);
  localparam LOG2_BANK = LOG2_DEPTH > @LOG2_BANK@ ? @LOG2_BANK@ : LOG2_DEPTH - 1;
  localparam LOG2_BANKS = LOG2_DEPTH - LOG2_BANK;
  localparam BANKS = 1 << LOG2_BANKS;

  wire [WIDTH*BANKS-1:0] words;  // 0 of banks other than that which has been read
  reg [WIDTH-1:0] chosen;

  genvar number;
  generate
    for (number = 0; number < BANKS; number = number + 1) begin : banks
      @RAM_STYLE@reg [WIDTH-1:0] places[0:(1<<LOG2_BANK)-1];
      reg [WIDTH-1:0] word;
!lut_ram|      reg is_read;
      wire own = write_place[LOG2_DEPTH-1:LOG2_BANK] == number[LOG2_BANKS-1:0];
?lut_ram|      wire other = read & (read_place[LOG2_DEPTH-1:LOG2_BANK] != number[LOG2_BANKS-1:0]);
      always @(posedge clock) begin
        if (write & own) places[write_place[LOG2_BANK-1:0]] <= write_data;
?lut_ram|        if (other) word <= {WIDTH{1'b0}};
?lut_ram|        else if (read) word <= places[read_place[LOG2_BANK-1:0]];
!lut_ram|        if (read) word <= places[read_place[LOG2_BANK-1:0]];
!lut_ram|        if (read) is_read <= read_place[LOG2_DEPTH-1:LOG2_BANK] == number[LOG2_BANKS-1:0];
      end
?lut_ram|      assign words[WIDTH*number+:WIDTH] = word;
!lut_ram|      assign words[WIDTH*number+:WIDTH] = word & {WIDTH{is_read}};
    end
  endgenerate

  integer i;
  always @(*) begin
    chosen = {WIDTH{1'b0}};
    for (i = 0; i < BANKS; i = i + 1) chosen = chosen | words[WIDTH*i+:WIDTH];
  end

  always @(posedge clock) begin
    if (move) data <= chosen;
  end
endmodule
?block_ram|
?block_ram|// @NAME@_block_memory: the same in a block RAM of an ECP5 with its output registers, up to 512 places of 36
?block_ram|// bits. Of such words the lower half is written and read at pins of port A, the upper half at those of B.
?block_ram|module @NAME@_block_memory #(
?block_ram|    parameter WIDTH = 24,
?block_ram|    parameter LOG2_DEPTH = @LOG2_DEPTH@
?block_ram|) (
?block_ram|    input wire clock,
?block_ram|    input wire write,
?block_ram|    input wire [LOG2_DEPTH-1:0] write_place,
?block_ram|    input wire [WIDTH-1:0] write_data,
?block_ram|    input wire read,
?block_ram|    input wire [LOG2_DEPTH-1:0] read_place,
?block_ram|    input wire move,
?block_ram|    output wire [WIDTH-1:0] data
?block_ram|);
?block_ram|`ifdef SYNTHESIS
?block_ram|  wire [36:0] in = {{37 - WIDTH{1'b0}}, write_data};
?block_ram|  wire [9:0] to = {{10 - LOG2_DEPTH{1'b0}}, write_place};
?block_ram|  wire [9:0] from = {{10 - LOG2_DEPTH{1'b0}}, read_place};
?block_ram|  wire [35:0] out;
?block_ram|  assign data = out[WIDTH-1:0];
?block_ram|  DP16KD #(
?block_ram|      .DATA_WIDTH_A(36), .DATA_WIDTH_B(36), .REGMODE_A("OUTREG"), .REGMODE_B("OUTREG"), .GSR("DISABLED")
?block_ram|  ) block (
?block_ram|      .CLKA(clock), .CEA(write), .OCEA(move), .WEA(1'b1), .RSTA(1'b0), .CSA0(1'b0), .CSA1(1'b0), .CSA2(1'b0),
?block_ram|      .CLKB(clock), .CEB(read), .OCEB(move), .WEB(1'b0), .RSTB(1'b0), .CSB0(1'b0), .CSB1(1'b0), .CSB2(1'b0),
?block_ram|      .DIA0(in[0]), .DIA1(in[1]), .DIA2(in[2]), .DIA3(in[3]), .DIA4(in[4]), .DIA5(in[5]),
?block_ram|      .DIA6(in[6]), .DIA7(in[7]), .DIA8(in[8]), .DIA9(in[9]), .DIA10(in[10]), .DIA11(in[11]),
?block_ram|      .DIA12(in[12]), .DIA13(in[13]), .DIA14(in[14]), .DIA15(in[15]), .DIA16(in[16]), .DIA17(in[17]),
?block_ram|      .DIB0(in[18]), .DIB1(in[19]), .DIB2(in[20]), .DIB3(in[21]), .DIB4(in[22]), .DIB5(in[23]),
?block_ram|      .DIB6(in[24]), .DIB7(in[25]), .DIB8(in[26]), .DIB9(in[27]), .DIB10(in[28]), .DIB11(in[29]),
?block_ram|      .DIB12(in[30]), .DIB13(in[31]), .DIB14(in[32]), .DIB15(in[33]), .DIB16(in[34]), .DIB17(in[35]),
?block_ram|      .ADA0(1'b1), .ADA1(1'b1), .ADA2(1'b1), .ADA3(1'b1), .ADA4(1'b0), .ADA5(to[0]), .ADA6(to[1]),
?block_ram|      .ADA7(to[2]), .ADA8(to[3]), .ADA9(to[4]), .ADA10(to[5]), .ADA11(to[6]), .ADA12(to[7]), .ADA13(to[8]),
?block_ram|      .ADB0(1'b0), .ADB1(1'b0), .ADB2(1'b0), .ADB3(1'b0), .ADB4(1'b0), .ADB5(from[0]), .ADB6(from[1]),
?block_ram|      .ADB7(from[2]), .ADB8(from[3]), .ADB9(from[4]), .ADB10(from[5]), .ADB11(from[6]), .ADB12(from[7]), .ADB13(from[8]),
?block_ram|      .DOA0(out[0]), .DOA1(out[1]), .DOA2(out[2]), .DOA3(out[3]), .DOA4(out[4]), .DOA5(out[5]),
?block_ram|      .DOA6(out[6]), .DOA7(out[7]), .DOA8(out[8]), .DOA9(out[9]), .DOA10(out[10]), .DOA11(out[11]),
?block_ram|      .DOA12(out[12]), .DOA13(out[13]), .DOA14(out[14]), .DOA15(out[15]), .DOA16(out[16]), .DOA17(out[17]),
?block_ram|      .DOB0(out[18]), .DOB1(out[19]), .DOB2(out[20]), .DOB3(out[21]), .DOB4(out[22]), .DOB5(out[23]),
?block_ram|      .DOB6(out[24]), .DOB7(out[25]), .DOB8(out[26]), .DOB9(out[27]), .DOB10(out[28]), .DOB11(out[29]),
?block_ram|      .DOB12(out[30]), .DOB13(out[31]), .DOB14(out[32]), .DOB15(out[33]), .DOB16(out[34]), .DOB17(out[35])
?block_ram|  );
?block_ram|`else
?block_ram|  reg [WIDTH-1:0] places[0:(1<<LOG2_DEPTH)-1];
?block_ram|  reg [WIDTH-1:0] word;
?block_ram|  reg [WIDTH-1:0] moved;
?block_ram|  assign data = moved;
?block_ram|  always @(posedge clock) begin
?block_ram|    if (write) places[write_place] <= write_data;
?block_ram|    if (read) word <= places[read_place];
?block_ram|    if (move) moved <= word;
?block_ram|  end
?block_ram|`endif
?block_ram|endmodule

// @NAME@_reset: the reset, high. It stays a module in synthesis: where Yosys knows that a reset is the
// inverse of a signal, each flip-flop that is reset has an inverter of its own.
(* keep_hierarchy *)
module @NAME@_reset (
    input  wire low,
    output wire high
);
  assign high = ~low;
endmodule
// verilator lint_on DECLFILENAME

`default_nettype wire
