@ABOUT@
//
// Self-checking bench of @NAME@_ip. It writes the registers, streams @NAME@_packets.hex in, and compares every pixel
// that comes out with @NAME@_pixels.hex. It says PASS, or which pixel differs first, and then stops by `$stop`,
// so that simulators end with a status that is not 0 (Icarus with `vvp -N`).
//
//   +seed=N     pauses at random on both sides; 0, which is the default, for none
//   +record=F   writes each pixel into the file F: the clock in which it is taken, and its bits
`default_nettype none

module @NAME@_tb #(
    parameter [2:0] SKIPPED = 3'd0  // what `status` has to say of packets that are skipped
);
  localparam WORDS = @WORD_COUNT@;
  localparam PIXELS = @PIXEL_COUNT@;
  localparam FRAMES = @FRAME_COUNT@;
?writes|  localparam WRITES = @WRITE_COUNT@;
  localparam PATIENCE = 100000;  // clocks without any transfer

  reg [@WORD_LINE_TOP@:0] words[0:WORDS-1];  // first of a frame, tlast, word
  reg [@PIXEL_LINE_TOP@:0] pixels[0:PIXELS-1];  // tuser, tlast, pixel
?writes|  reg [63:0] writes[0:WRITES-1];  // frame, address, word
  reg [31:0] seed;
  reg [8*64-1:0] record_name;
  integer record;

  reg aclk = 1'b0;
  reg [3:0] reset_clocks = 4'd0;
  wire aresetn = reset_clocks == 4'd15;

  initial begin
    if (!$value$plusargs("seed=%d", seed)) seed = 32'd0;
    if (^seed === 1'bx) begin
      $display("FAIL: the seed is no number");
      $stop;
    end
    record = 0;
    if ($value$plusargs("record=%s", record_name)) record = $fopen(record_name, "w");
    $readmemh("@NAME@_packets.hex", words);
    $readmemh("@NAME@_pixels.hex", pixels);
?writes|    $readmemh("@NAME@_registers.hex", writes);
    forever #5 aclk = ~aclk;
  end

  always @(posedge aclk) if (!aresetn) reset_clocks <= reset_clocks + 4'd1;

  // Random pauses: how often changes every 64 clocks, from never to nearly always.
  reg [31:0] random_in;
  reg [31:0] random_out;
  reg [7:0] rare_in;
  reg [7:0] rare_out;
  reg [5:0] phase;

  function [31:0] next_random(input [31:0] state);
    reg [31:0] a;
    reg [31:0] b;
    begin
      a = state ^ (state << 13);
      b = a ^ (a >> 17);
      next_random = b ^ (b << 5);
    end
  endfunction

  wire pause_in = seed != 32'd0 && random_in[31:24] < rare_in;
  wire pause_out = seed != 32'd0 && random_out[31:24] < rare_out;

  always @(posedge aclk) begin
    if (!aresetn) begin
      random_in <= {seed[15:0], 16'h9e37} ^ {16'd0, seed[31:16]};
      random_out <= {16'h85eb, seed[15:0]} ^ {seed[31:16], 16'd0};
      rare_in <= 8'd0;
      rare_out <= 8'd0;
      phase <= 6'd0;
    end else begin
      random_in <= next_random(random_in);
      random_out <= next_random(random_out);
      phase <= phase + 6'd1;
      if (phase == 6'd0) begin
        rare_in <= random_in[9] ? 8'd0 : random_in[7:0];
        rare_out <= random_out[9] ? 8'd0 : random_out[7:0];
      end
    end
  end

  // Packets.
  reg [@WORD_TOP@:0] s_axis_tdata;
  reg s_axis_tvalid;
  wire s_axis_tready;
  reg s_axis_tlast;
  integer next_word;
  integer frames_begun;
  integer frames_written;
  wire [@WORD_LINE_TOP@:0] word = next_word < WORDS ? words[next_word] : words[0];
  wire may_send = next_word < WORDS && (!word[@WORD_LINE_TOP@] || frames_begun < frames_written);

  always @(posedge aclk) begin
    if (!aresetn) begin
      s_axis_tvalid <= 1'b0;
      next_word <= 0;
      frames_begun <= 0;
    end else if (!s_axis_tvalid || s_axis_tready) begin
      s_axis_tvalid <= may_send && !pause_in;
      if (may_send && !pause_in) begin
        s_axis_tdata <= word[@WORD_TOP@:0];
        s_axis_tlast <= word[@WORD@];
        next_word <= next_word + 1;
        if (word[@WORD_LINE_TOP@]) frames_begun <= frames_begun + 1;
      end
    end
  end

  // Pixels.
  wire [@PIXEL_TOP@:0] m_axis_tdata;
  wire m_axis_tvalid;
  reg m_axis_tready;
  wire m_axis_tuser;
  wire m_axis_tlast;
  wire [@PIXEL_LINE_TOP@:0] pixel = {m_axis_tuser, m_axis_tlast, m_axis_tdata};
  reg [@PIXEL_LINE_TOP@:0] held;
  reg holds;
  integer sent;
  integer first_clock;
  integer last_clock;
  integer clocks;
  integer idle;
  reg failed;

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_axis_tready <= 1'b0;
      holds <= 1'b0;
      sent <= 0;
      clocks <= 0;
      first_clock <= 0;
      last_clock <= 0;
      idle <= 0;
      failed <= 1'b0;
    end else begin
      m_axis_tready <= !pause_out;
      clocks <= clocks + 1;
      idle <= (m_axis_tvalid && m_axis_tready) || (s_axis_tvalid && s_axis_tready) ? 0 : idle + 1;
      if (s_axis_tvalid && s_axis_tready && first_clock == 0) first_clock <= clocks;
      held <= pixel;
      holds <= m_axis_tvalid && !m_axis_tready;
      if (holds && (!m_axis_tvalid || pixel !== held)) begin
        $display("FAIL: pixel %0d changed while it waited", sent);
        failed <= 1'b1;
      end
      if (m_axis_tvalid && m_axis_tready) begin
        sent <= sent + 1;
        last_clock <= clocks;
        if (record != 0) $fwrite(record, "%0d %h\n", clocks, pixel);
        if (sent >= PIXELS) begin
          $display("FAIL: more than %0d pixels", PIXELS);
          failed <= 1'b1;
        end else if (pixel !== pixels[sent]) begin
          $display("FAIL: pixel %0d is %h, not %h (tuser, tlast, pixel)", sent, pixel, pixels[sent]);
          failed <= 1'b1;
        end
      end
      if (idle > PATIENCE) begin
        $display("FAIL: nothing moves behind pixel %0d", sent);
        failed <= 1'b1;
      end
      if (failed) $stop;
    end
  end

  // Registers: what the block is, those of each frame as soon as the one before has begun, and at the
  // end the counters.
  localparam [2:0] IDENTIFY = 3'd0, CHECK_CORE = 3'd1, AWAIT = 3'd2, WRITE = 3'd3, DRAIN = 3'd4;
  localparam [2:0] COUNT = 3'd5, STATUS = 3'd6, DONE = 3'd7;
  reg [2:0] step;
  reg asked;
  reg [11:0] s_axi_awaddr;
  reg s_axi_awvalid;
  wire s_axi_awready;
  reg [31:0] s_axi_wdata;
  reg s_axi_wvalid;
  wire s_axi_wready;
  wire [1:0] s_axi_bresp;
  wire s_axi_bvalid;
  reg [11:0] s_axi_araddr;
  reg s_axi_arvalid;
  wire s_axi_arready;
  wire [31:0] s_axi_rdata;
  wire [1:0] s_axi_rresp;
  wire s_axi_rvalid;
  reg wrong;
?writes|  integer next_write;
?writes|  wire [63:0] write = next_write < WRITES ? writes[next_write] : 64'hffff_0000_0000_0000;
?writes|  wire unused_bits = &{1'b0, write[47:44]};
?writes|  wire writes_left = {16'd0, write[63:48]} == frames_written;

  always @(posedge aclk) begin
    if (!aresetn) begin
      step <= IDENTIFY;
      asked <= 1'b0;
      s_axi_awvalid <= 1'b0;
      s_axi_wvalid <= 1'b0;
      s_axi_arvalid <= 1'b0;
      frames_written <= 0;
?writes|      next_write <= 0;
      wrong <= 1'b0;
    end else begin
      if (s_axi_awready) s_axi_awvalid <= 1'b0;
      if (s_axi_wready) s_axi_wvalid <= 1'b0;
      if (s_axi_arready) s_axi_arvalid <= 1'b0;
      if (!asked) begin
        case (step)
          IDENTIFY: s_axi_araddr <= 12'h000;
          CHECK_CORE: s_axi_araddr <= 12'h008;
          AWAIT: s_axi_araddr <= 12'h018;
          COUNT: s_axi_araddr <= 12'h01c;
          default: s_axi_araddr <= 12'h014;
        endcase
        case (step)
          WRITE: begin
?writes|            if (writes_left) begin
?writes|              s_axi_awaddr <= write[43:32];
?writes|              s_axi_wdata <= write[31:0];
?writes|              s_axi_awvalid <= 1'b1;
?writes|              s_axi_wvalid <= 1'b1;
?writes|              asked <= 1'b1;
?writes|              next_write <= next_write + 1;
?writes|            end else begin
?writes|              frames_written <= frames_written + 1;
?writes|              step <= frames_written + 1 < FRAMES ? AWAIT : DRAIN;
?writes|            end
!writes|            frames_written <= frames_written + 1;
!writes|            step <= frames_written + 1 < FRAMES ? AWAIT : DRAIN;
          end
          DRAIN: if (sent == PIXELS) step <= COUNT;
          DONE: begin
            if (!failed && !wrong)
              $display("PASS: %0d pixels, %0d clocks from the first word on, seed %0d", sent,
                       last_clock - first_clock + 1, seed);
            $finish;
          end
          default: begin
            s_axi_arvalid <= 1'b1;
            asked <= 1'b1;
          end
        endcase
      end
      if (s_axi_bvalid) begin
        asked <= 1'b0;
        if (s_axi_bresp != 2'b00) begin
          $display("FAIL: register %h cannot be written", s_axi_awaddr);
          wrong <= 1'b1;
        end
      end
      if (s_axi_rvalid) begin
        asked <= 1'b0;
        if (s_axi_rresp != 2'b00) wrong <= 1'b1;
        case (step)
          IDENTIFY: begin
            if (s_axi_rdata != 32'h@IDENTITY@) wrong <= 1'b1;
            step <= CHECK_CORE;
          end
          CHECK_CORE: begin
            if (s_axi_rdata != 32'h@CORE@) wrong <= 1'b1;
            step <= AWAIT;
          end
          AWAIT: if (s_axi_rdata == frames_written) step <= WRITE;
          COUNT: begin
            if (s_axi_rdata != PIXELS) wrong <= 1'b1;
            step <= STATUS;
          end
          default: begin
            if (s_axi_rdata != {29'd0, SKIPPED}) wrong <= 1'b1;
            step <= DONE;
          end
        endcase
      end
      if (wrong) begin
        $display("FAIL: register %h has %h", s_axi_araddr, s_axi_rdata);
        $stop;
      end
    end
  end
!writes|
!writes|  always @(posedge aclk) begin
!writes|    s_axi_awaddr <= 12'd0;
!writes|    s_axi_wdata <= 32'd0;
!writes|  end

  @NAME@_ip dut (
      .aclk(aclk),
      .aresetn(aresetn),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tvalid(s_axis_tvalid),
      .s_axis_tready(s_axis_tready),
      .s_axis_tlast(s_axis_tlast),
      .m_axis_tdata(m_axis_tdata),
      .m_axis_tvalid(m_axis_tvalid),
      .m_axis_tready(m_axis_tready),
      .m_axis_tuser(m_axis_tuser),
      .m_axis_tlast(m_axis_tlast),
      .s_axi_awaddr(s_axi_awaddr),
      .s_axi_awvalid(s_axi_awvalid),
      .s_axi_awready(s_axi_awready),
      .s_axi_wdata(s_axi_wdata),
      .s_axi_wstrb(4'b1111),
      .s_axi_wvalid(s_axi_wvalid),
      .s_axi_wready(s_axi_wready),
      .s_axi_bresp(s_axi_bresp),
      .s_axi_bvalid(s_axi_bvalid),
      .s_axi_bready(1'b1),
      .s_axi_araddr(s_axi_araddr),
      .s_axi_arvalid(s_axi_arvalid),
      .s_axi_arready(s_axi_arready),
      .s_axi_rdata(s_axi_rdata),
      .s_axi_rresp(s_axi_rresp),
      .s_axi_rvalid(s_axi_rvalid),
      .s_axi_rready(1'b1)
  );
endmodule

`default_nettype wire
