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
  wire reset = ~aresetn;

  // The next packet, as soon as it is whole.
  wire [@PACKET_TOP@:0] packet;
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
  reg [15:0] left;  // pixels that have not entered
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
      left <= packet[15:0];
      at_last <= packet[15:0] == 16'd1;
      at_first <= 1'b1;
      of_frame <= at_frame;
    end else if (complete) begin
?positions|      x <= x + 16'd1;
      left <= left - 16'd1;
      at_last <= left == 16'd2;
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
      if (freed & ~spend) places <= places + 1'b1;
      else if (spend & ~freed) places <= places - 1'b1;
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

  // The rest of the header is 0, and above some inputs stand copies of their highest bit.
  wire unused_bits = &{1'b0, packet[31:17]@UNUSED_INPUTS@};

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

  // What the header says, from the clock after it on.
  wire word_fits = (word[15:0] != 16'd0) & (word[15:0] <= 16'd@LONGEST@);
?several|  reg fits;
?several|  reg is_last;
?several|  always @(posedge clock) begin
?several|    if (accept & at[0]) begin
?several|      fits <= word_fits;
?several|      is_last <= word[16];
?several|    end
?several|  end
!several|  wire fits = word_fits;
!several|  wire is_last = word[16];

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
      if (ends) at <= @WORDS@'d1;
?several|      else if (accept & ~skipping) at <= at << 1;
      if (too_long) skipping <= 1'b1;
      else if (accept & word_last) skipping <= 1'b0;
      if (whole & fits) full <= 1'b1;
      else if (take) full <= 1'b0;
      skipped <= {whole & ~fits, too_long, too_short};
?several|      lost_last <= (ends & ~(last & word_last & fits)) & (at[0] ? word[16] : is_last);
!several|      lost_last <= (ends & ~(last & word_last & fits)) & is_last;
    end
@TAKE_WORDS@
  end
?surplus|
?surplus|  // The last word is not all of it read.
?surplus|  wire unused_bits = &{1'b0, word[@WORD_TOP@:@SURPLUS@]};
endmodule

// @NAME@_pixels: pixels from when they enter the core until they have been sent, in their order. What
// belongs to a pixel is written when it enters, its colour when it leaves the core.
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
  reg [LOG2_DEPTH-1:0] entering;  // the place of the pixel that enters next
  reg [LOG2_DEPTH-1:0] leaving;  // of the one that leaves the core next
  reg [LOG2_DEPTH-1:0] sending;  // of the one that is read next
  reg [LOG2_DEPTH-1:0] stored;  // pixels in the memory that have left the core
  reg waiting;  // there are any
  reg is_read;  // a pixel stands between the memory and the output
  wire [@TAG_TOP@:0] sent_tag;
  wire [23:0] sent_colour;

  wire move = is_read & (~m_axis_tvalid | m_axis_tready);
  wire read = waiting & (~is_read | ~m_axis_tvalid | m_axis_tready);

  @NAME@_memory #(
      .WIDTH(@TAG_BITS@),
      .LOG2_DEPTH(LOG2_DEPTH)
  ) tags (
      .clock(clock),
      .write(enters),
      .write_place(entering),
      .write_data(tag),
      .read(read),
      .read_place(sending),
      .move(move),
      .data(sent_tag)
  );

  @NAME@_memory #(
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
      entering <= {LOG2_DEPTH{1'b0}};
      leaving <= {LOG2_DEPTH{1'b0}};
      sending <= {LOG2_DEPTH{1'b0}};
      stored <= {LOG2_DEPTH{1'b0}};
      waiting <= 1'b0;
      is_read <= 1'b0;
      m_axis_tvalid <= 1'b0;
      freed <= 1'b0;
    end else begin
      if (enters) entering <= entering + 1'b1;
      if (leaves) leaving <= leaving + 1'b1;
      if (read) sending <= sending + 1'b1;
      if (leaves & ~read) stored <= stored + 1'b1;
      else if (read & ~leaves) stored <= stored - 1'b1;
      waiting <= leaves | (|stored[LOG2_DEPTH-1:1]) | (stored[0] & ~read);
      is_read <= read | (is_read & ~move);
      m_axis_tvalid <= move | (m_axis_tvalid & ~m_axis_tready);
      freed <= read;
    end
  end

?positions|  assign m_axis_tdata = {sent_tag[33:2], sent_colour};
!positions|  assign m_axis_tdata = sent_colour;
  assign m_axis_tuser = sent_tag[1];
  assign m_axis_tlast = sent_tag[0];
endmodule

// @NAME@_memory: banks of up to 32 places, each with a register behind it, and a register behind all:
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
  localparam LOG2_BANK = LOG2_DEPTH > 5 ? 5 : LOG2_DEPTH - 1;
  localparam LOG2_BANKS = LOG2_DEPTH - LOG2_BANK;
  localparam BANKS = 1 << LOG2_BANKS;

  wire [WIDTH*BANKS-1:0] words;  // 0 of banks other than that which has been read
  reg [WIDTH-1:0] chosen;

  genvar number;
  generate
    for (number = 0; number < BANKS; number = number + 1) begin : banks
      @RAM_STYLE@reg [WIDTH-1:0] places[0:(1<<LOG2_BANK)-1];
      reg [WIDTH-1:0] word;
      reg is_read;
      wire own = write_place[LOG2_DEPTH-1:LOG2_BANK] == number[LOG2_BANKS-1:0];
      always @(posedge clock) begin
        if (write & own) places[write_place[LOG2_BANK-1:0]] <= write_data;
        if (read) word <= places[read_place[LOG2_BANK-1:0]];
        if (read) is_read <= read_place[LOG2_DEPTH-1:LOG2_BANK] == number[LOG2_BANKS-1:0];
      end
      assign words[WIDTH*number+:WIDTH] = word & {WIDTH{is_read}};
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
// verilator lint_on DECLFILENAME

`default_nettype wire
