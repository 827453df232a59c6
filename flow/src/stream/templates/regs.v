@ABOUT@
//
// The register block of the core @NAME@, AXI4-Lite. @NAME@_registers.h and @NAME@.rdl have the map.
//
// A write takes all 32 bits: one with a byte left out, or to an address without a register, is answered
// with SLVERR and changes nothing.@REGS_ABOUT@
`default_nettype none

module @NAME@_regs (
    input wire aclk,
    input wire aresetn,  // synchronous, low

    input  wire [11:0] s_axi_awaddr,
    input  wire        s_axi_awvalid,
    output wire        s_axi_awready,
    input  wire [31:0] s_axi_wdata,
    input  wire [3:0]  s_axi_wstrb,
    input  wire        s_axi_wvalid,
    output wire        s_axi_wready,
    output wire [1:0]  s_axi_bresp,
    output reg         s_axi_bvalid,
    input  wire        s_axi_bready,
    input  wire [11:0] s_axi_araddr,
    input  wire        s_axi_arvalid,
    output wire        s_axi_arready,
    output reg  [31:0] s_axi_rdata,
    output wire [1:0]  s_axi_rresp,
    output reg         s_axi_rvalid,
    input  wire        s_axi_rready,

?frames|    // Inputs that hold for a frame, as the core sees them.
?frames|@FRAME_OUTPUTS@
    input  wire       frame,        // a frame begins
    input  wire [2:0] error,        // packets that were skipped
    output reg        clear_error,
    input  wire       busy,
    input  wire       pixel,        // a pixel is sent
    input  wire       blocked,      // a span waits for pixels to be taken
    input  wire       starved       // there is no span
);
  wire reset;
  @NAME@_reset reset_high (
      .low(aresetn),
      .high(reset)
  );

  // Counters of clocks and of what happens in them. They begin again at 0 behind 2^32 - 1.
  reg [31:0] frames;
  reg [31:0] pixels;
  reg [31:0] blocked_clocks;
  reg [31:0] starved_clocks;

  always @(posedge aclk) begin
    if (reset) begin
      frames <= 32'd0;
      pixels <= 32'd0;
      blocked_clocks <= 32'd0;
      starved_clocks <= 32'd0;
    end else begin
      if (frame) frames <= frames + 32'd1;
      if (pixel) pixels <= pixels + 32'd1;
      if (blocked) blocked_clocks <= blocked_clocks + 32'd1;
      if (starved) starved_clocks <= starved_clocks + 32'd1;
    end
  end

  // Writes: address and data are taken together.
  wire write = s_axi_awvalid & s_axi_wvalid & ~s_axi_bvalid;
  wire whole = s_axi_awaddr[1:0] == 2'd0 && s_axi_wstrb == 4'b1111;
  reg known;  // the address is that of a register that can be written
  reg failed;
  assign s_axi_awready = write;
  assign s_axi_wready = write;
  assign s_axi_bresp = {failed, 1'b0};

  always @(*) begin
    case (s_axi_awaddr[11:2])
      10'h005: known = 1'b1;
?frames|@WRITE_KNOWN@
      default: known = 1'b0;
    endcase
  end

  always @(posedge aclk) begin
    if (reset) s_axi_bvalid <= 1'b0;
    else s_axi_bvalid <= write | (s_axi_bvalid & ~s_axi_bready);
    if (write) failed <= ~(known & whole);
  end

  wire accepted = write & known & whole;
  always @(posedge aclk) begin
    clear_error <= ~reset & accepted & s_axi_awaddr[11:2] == 10'h005 & s_axi_wdata[2:0] != 3'd0;
  end

?frames|  // What is written waits here for the next frame.
?frames|@SHADOW_DECLARATIONS@
?frames|
?frames|  always @(posedge aclk) begin
?frames|    if (reset) begin
?frames|@SHADOW_RESETS@
?frames|    end else if (accepted) begin
?frames|      case (s_axi_awaddr[11:2])
?frames|@SHADOW_WRITES@
?frames|        default: ;
?frames|      endcase
?frames|    end
?frames|    if (frame) begin
?frames|@TAKE_OVER@
?frames|    end
?frames|  end

  // Reads.
  wire read = s_axi_arvalid & ~s_axi_rvalid;
  reg  read_failed;
  assign s_axi_arready = read;
  assign s_axi_rresp = {read_failed, 1'b0};

  wire [3:0] place = s_axi_araddr[5:2];
  wire [31:0] status = {23'd0, busy, 5'd0, error};
  wire [31:0] counter = place[3] ? (place[0] ? starved_clocks : blocked_clocks)
                                 : (place[0] ? pixels : frames);
  wire counts = place[3] | (place[2] & place[1]);
  reg [31:0] other;
  always @(*) begin
    case (place)
      4'd0: other = 32'h@IDENTITY@;
      4'd1: other = 32'h@VERSION@;
      4'd2: other = 32'h@CORE@;
      4'd3: other = 32'h@CAPABILITY@;
      4'd4: other = 32'h@PACKET@;
      4'd5: other = status;
      default: other = 32'd0;
    endcase
  end
  wire [31:0] own = (counter & {32{counts}}) | other;
  wire is_own = s_axi_araddr[11:6] == 6'd0 && place < 4'd10;

?frames|  reg [31:0] of_input;
?frames|  reg is_input;
?frames|  always @(*) begin
?frames|    is_input = 1'b1;
?frames|    case (s_axi_araddr[11:2])
?frames|@SHADOW_READS@
?frames|      default: begin
?frames|        of_input = 32'd0;
?frames|        is_input = 1'b0;
?frames|      end
?frames|    endcase
?frames|  end

  always @(posedge aclk) begin
    if (reset) s_axi_rvalid <= 1'b0;
    else s_axi_rvalid <= read | (s_axi_rvalid & ~s_axi_rready);
    if (read) begin
?frames|      s_axi_rdata <= is_own ? own : of_input;
?frames|      read_failed <= ~(is_own | is_input);
!frames|      s_axi_rdata <= own;
!frames|      read_failed <= ~is_own;
    end
  end

  // A read is of a whole word@UNUSED_ABOUT@.
  wire unused_bits = &{1'b0, s_axi_araddr[1:0]@UNUSED@};
endmodule

`default_nettype wire
