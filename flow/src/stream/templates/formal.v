@ABOUT@
//
// What is proven of the block, whatever comes in and whenever it has to wait: `make prove`. In place of
// the core stands a pipeline of 2 clocks whose colours number the pixels, in place of the memory's
// 2^@LOG2_DEPTH@ places 4.
`default_nettype none

// The block's stream top with free inputs; the first clock is a reset.
module @NAME@_formal (
    input wire aclk,
    input wire [@WORD_TOP@:0] s_axis_tdata,
    input wire s_axis_tvalid,
    input wire s_axis_tlast,
    input wire m_axis_tready,
    input wire clear_error
);
  reg begun = 1'b0;
  always @(posedge aclk) begun <= 1'b1;

  @NAME@_axis #(
      .LOG2_DEPTH(2)
  ) axis (
      .aclk(aclk),
      .aresetn(begun),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tvalid(s_axis_tvalid),
      .s_axis_tlast(s_axis_tlast),
      .m_axis_tready(m_axis_tready),
      .clear_error(clear_error)
  );
endmodule

// The pipeline in place of the core: 2 clocks long. Its colours are the lowest bits of the pixel's number.
module @NAME@ (
@STAND_IN_PORTS@
);
  reg [1:0] stages = 2'd0;
  reg [7:0] number = 8'd0;
?slots|  reg [1:0] slot = 2'd0;
?slots|  wire last_slot = slot == 2'd@LAST_SLOT@;
?reset|  wire taken = valid & ~reset;
!reset|  wire taken = valid;
?slots|  wire enters = taken & last_slot;
!slots|  wire enters = taken;

  always @(posedge clock) begin
    stages <= {stages[0], enters};
    if (stages[1]) number <= number + 8'd1;
?slots|    if (taken) slot <= last_slot ? 2'd0 : slot + 2'd1;
  end

  assign @VALID_OUT@ = stages[1];
@STAND_IN_COLOURS@
endmodule

// The properties, inside the stream top.
module @NAME@_properties #(
    parameter LOG2_DEPTH = 2
) (
    input wire clock,
    input wire reset,

    input wire [@WORD_TOP@:0] word,
    input wire accept,
    input wire word_last,
    input wire [@PACKET_TOP@:0] packet,
    input wire full,
    input wire load,
    input wire [2:0] skipped,
    input wire lost_last,

    input wire shading,
    input wire [@COUNT_TOP@:0] left,
    input wire at_last,
    input wire at_first,
    input wire at_frame,
    input wire of_frame,
    input wire frame,
    input wire enter,
    input wire spend,
    input wire complete,
    input wire leaves,
    input wire freed,
    input wire [LOG2_DEPTH-1:0] places,

    input wire [@TAG_TOP@:0] tag,
    input wire [@PIXEL_TOP@:0] pixel,
    input wire pixel_valid,
    input wire pixel_ready,
    input wire pixel_first,
    input wire pixel_last
);
  reg [@PIXEL_BITS@+1:0] was_sent;
  reg waited;
  wire [@PIXEL_BITS@+1:0] sends = {pixel, pixel_first, pixel_last};

  // A pixel that waits stays what it is.
  always @(posedge clock) begin
    waited <= ~reset & pixel_valid & ~pixel_ready;
    was_sent <= sends;
  end
  always @(*) if (~reset & waited) pixel_waits: assert (pixel_valid & sends == was_sent);

  // Pixels by their numbers, modulo twice the places: fewer than that are under way.
  localparam BITS = LOG2_DEPTH + 1;
  reg [BITS-1:0] entered;
  reg [BITS-1:0] computed;  // have left the core
  reg [BITS-1:0] held;  // of the places, those that are taken
  reg [BITS-1:0] sent;
  wire send = pixel_valid & pixel_ready;
  always @(posedge clock) begin
    if (reset) begin
      entered <= {BITS{1'b0}};
      computed <= {BITS{1'b0}};
      held <= {BITS{1'b0}};
      sent <= {BITS{1'b0}};
    end else begin
      if (spend) entered <= entered + 1'b1;
      if (leaves) computed <= computed + 1'b1;
      held <= held + spend - freed;
      if (send) sent <= sent + 1'b1;
    end
  end

  // A place for each pixel, and no more places than there are.
  always @(*) if (~reset) begin
    places_are_kept: assert (places + held == {1'b0, {LOG2_DEPTH{1'b1}}});
    if (spend) place_is_free: assert (places != {LOG2_DEPTH{1'b0}});
  end

?numbered|  // None is lost, doubled or out of order: what is sent next has the number that comes next.
?numbered|  always @(*) if (~reset & pixel_valid)
?numbered|    order: assert (pixel[@NUMBER_TOP@:@NUMBER_LOW@] == sent[@ORDER_TOP@:0]);

  // With its marks, and of its position the lowest bits, as they were when it entered. The other bits
  // of the position stand beside those.
  reg [@MARKS@-1:0] marks[0:2*(1<<LOG2_DEPTH)-1];
  wire [@MARKS@-1:0] sent_marks = marks[sent];
  always @(posedge clock) if (spend) marks[entered] <= {@TAG_MARKS@};
  always @(*) if (~reset & pixel_valid) begin
    last_arrives: assert (pixel_last == sent_marks[0]);
    first_arrives: assert (pixel_first == sent_marks[1]);
?positions|    column_arrives: assert (pixel[24] == sent_marks[2]);
?positions|    row_arrives: assert (pixel[40] == sent_marks[3]);
  end

  // A span has the pixels of its packet, and the last one is known by `left`.
  reg first_of_frame;
  reg was_shading;
  reg was_last;
  always @(posedge clock) begin
    if (load) first_of_frame <= at_frame;
    was_shading <= ~reset & shading;
    was_last <= complete & left == @COUNT_BITS@'d1;
  end
  always @(*) if (~reset) begin
    if (was_shading & ~shading) shading_until_last: assert (was_last);
    if (shading) begin
      shading_has_pixels: assert (left != @COUNT_BITS@'d0);
      last_of_span: assert (at_last == (left == @COUNT_BITS@'d1));
      first_of_frame_only: assert (of_frame == (at_first & first_of_frame));
    end
    if (enter) enters_of_span: assert (shading);
    if (load) span_is_whole: assert (~shading | (complete & at_last));
  end

  // A packet is taken where it has its words, its last one marked, and a number of pixels that fits.
  reg [@INDEX_TOP@:0] index;  // of the word that comes next; @WORDS@ behind them
  reg [15:0] pixels;
  reg last_span;
  wire [15:0] told = index == @INDEX_BITS@'d0 ? word[15:0] : pixels;
  wire told_last = index == @INDEX_BITS@'d0 ? word[16] : last_span;
  wire is_last_word = accept & index == @INDEX_BITS@'d@LAST_WORD@;
  wire fits = told != 16'd0 & told <= 16'd@LONGEST@;
  reg [2:0] expected_skip;
  reg expected_full;
  reg expected_loss;
  wire too_short = accept & word_last & index < @INDEX_BITS@'d@LAST_WORD@;
  wire [2:0] skips = {is_last_word & word_last & ~fits, is_last_word & ~word_last, too_short};
  always @(posedge clock) begin
    if (reset) begin
      index <= @INDEX_BITS@'d0;
      expected_skip <= 3'd0;
      expected_full <= 1'b0;
      expected_loss <= 1'b0;
    end else begin
      if (accept & word_last) index <= @INDEX_BITS@'d0;
      else if (accept & index != @INDEX_BITS@'d@WORDS@) index <= index + @INDEX_BITS@'d1;
      expected_skip <= skips;
      expected_full <= (is_last_word & word_last & fits) | (full & ~load);
      expected_loss <= skips != 3'd0 & told_last;
    end
    if (accept & index == @INDEX_BITS@'d0) begin
      pixels <= word[15:0];
      last_span <= word[16];
    end
  end
  always @(*) if (~reset) begin
    packet_is_whole: assert (full == expected_full);
    skipped_as_told: assert (skipped == expected_skip);
    lost_as_told: assert (lost_last == expected_loss);
    if (load) load_of_packet: assert (full);
  end

  // It is shaded as it came.
  reg [@WORDS_BITS@-1:0] expected;
  always @(posedge clock)
    if (accept & index < @INDEX_BITS@'d@WORDS@) expected[index*@WORD@+:@WORD@] <= word;
  always @(*) if (~reset & full) packet_as_sent: assert (packet == expected[@PACKET_TOP@:0]);
?frames|
?frames|  // A frame begins where no pixel is in the core.
?frames|  always @(*) if (~reset & frame) frame_when_empty: assert (entered == computed + leaves & ~enter);
endmodule

// The registers: one answer for each write and each read, which stays what it is until it is taken.
module @NAME@_regs_formal (
    input wire aclk,
    input wire [11:0] s_axi_awaddr,
    input wire s_axi_awvalid,
    input wire [31:0] s_axi_wdata,
    input wire [3:0] s_axi_wstrb,
    input wire s_axi_wvalid,
    input wire s_axi_bready,
    input wire [11:0] s_axi_araddr,
    input wire s_axi_arvalid,
    input wire s_axi_rready,
    input wire frame,
    input wire [2:0] error,
    input wire busy,
    input wire pixel,
    input wire blocked,
    input wire starved
);
  reg begun = 1'b0;
  always @(posedge aclk) begun <= 1'b1;

?frames|@FRAME_WIRES@
  wire awready, wready, bvalid, arready, rvalid;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;

  @NAME@_regs regs (
      .aclk(aclk),
      .aresetn(begun),
      .s_axi_awaddr(s_axi_awaddr),
      .s_axi_awvalid(s_axi_awvalid),
      .s_axi_awready(awready),
      .s_axi_wdata(s_axi_wdata),
      .s_axi_wstrb(s_axi_wstrb),
      .s_axi_wvalid(s_axi_wvalid),
      .s_axi_wready(wready),
      .s_axi_bresp(bresp),
      .s_axi_bvalid(bvalid),
      .s_axi_bready(s_axi_bready),
      .s_axi_araddr(s_axi_araddr),
      .s_axi_arvalid(s_axi_arvalid),
      .s_axi_arready(arready),
      .s_axi_rdata(rdata),
      .s_axi_rresp(rresp),
      .s_axi_rvalid(rvalid),
      .s_axi_rready(s_axi_rready),
?frames|@FRAME_PINS@
      .frame(frame),
      .error(error),
      .busy(busy),
      .pixel(pixel),
      .blocked(blocked),
      .starved(starved)
  );

  reg writes;  // a write has no answer yet
  reg reads;
  reg answer_waits;
  reg [1:0] was_bresp;
  reg data_waits;
  reg [33:0] was_read;
  always @(posedge aclk) begin
    writes <= begun & (writes ? ~(bvalid & s_axi_bready) : awready & s_axi_awvalid);
    reads <= begun & (reads ? ~(rvalid & s_axi_rready) : arready & s_axi_arvalid);
    answer_waits <= begun & bvalid & ~s_axi_bready;
    was_bresp <= bresp;
    data_waits <= begun & rvalid & ~s_axi_rready;
    was_read <= {rresp, rdata};
  end
  always @(*) if (begun) begin
    one_answer: assert (bvalid == writes);
    one_value: assert (rvalid == reads);
    together: assert ((awready & s_axi_awvalid) == (wready & s_axi_wvalid));
    if (answer_waits) answer_stays: assert (bresp == was_bresp);
    if (data_waits) value_stays: assert ({rresp, rdata} == was_read);
  end
?frames|
?frames|  // Inputs that hold for a frame change where one begins, and at no other time.
?frames|  reg held;
?frames|  reg [@FRAME_INPUT_BITS@-1:0] was;
?frames|  wire [@FRAME_INPUT_BITS@-1:0] is = {@FRAME_INPUT_NAMES@};
?frames|  always @(posedge aclk) begin
?frames|    held <= begun & ~frame;
?frames|    was <= is;
?frames|  end
?frames|  always @(*) if (begun & held) inputs_hold: assert (is == was);
endmodule

`default_nettype wire
