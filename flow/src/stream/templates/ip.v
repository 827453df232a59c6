@ABOUT@
//
// The core @NAME@ as a block for a design: @NAME@_axis, the stream top, with its registers, @NAME@_regs.
`default_nettype none

module @NAME@_ip #(
    parameter LOG2_DEPTH = @LOG2_DEPTH@  // see @NAME@_axis
) (
    input wire aclk,
    input wire aresetn,  // synchronous, low

    // Span packets.
    input  wire [@WORD_TOP@:0] s_axis_tdata,
    input  wire        s_axis_tvalid,
    output wire        s_axis_tready,
    input  wire        s_axis_tlast,

    // Pixels.
    output wire [@PIXEL_TOP@:0] m_axis_tdata,
    output wire        m_axis_tvalid,
    input  wire        m_axis_tready,
    output wire        m_axis_tuser,
    output wire        m_axis_tlast,

    // Registers.
    input  wire [11:0] s_axi_awaddr,
    input  wire        s_axi_awvalid,
    output wire        s_axi_awready,
    input  wire [31:0] s_axi_wdata,
    input  wire [3:0]  s_axi_wstrb,
    input  wire        s_axi_wvalid,
    output wire        s_axi_wready,
    output wire [1:0]  s_axi_bresp,
    output wire        s_axi_bvalid,
    input  wire        s_axi_bready,
    input  wire [11:0] s_axi_araddr,
    input  wire        s_axi_arvalid,
    output wire        s_axi_arready,
    output wire [31:0] s_axi_rdata,
    output wire [1:0]  s_axi_rresp,
    output wire        s_axi_rvalid,
    input  wire        s_axi_rready
);
?frames|@FRAME_WIRES@
  wire frame;
  wire [2:0] error;
  wire clear_error;
  wire busy;
  wire blocked;
  wire starved;

  @NAME@_axis #(
      .LOG2_DEPTH(LOG2_DEPTH)
  ) axis (
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
?frames|@FRAME_PINS@
      .frame(frame),
      .error(error),
      .clear_error(clear_error),
      .busy(busy),
      .blocked(blocked),
      .starved(starved)
  );

  @NAME@_regs regs (
      .aclk(aclk),
      .aresetn(aresetn),
      .s_axi_awaddr(s_axi_awaddr),
      .s_axi_awvalid(s_axi_awvalid),
      .s_axi_awready(s_axi_awready),
      .s_axi_wdata(s_axi_wdata),
      .s_axi_wstrb(s_axi_wstrb),
      .s_axi_wvalid(s_axi_wvalid),
      .s_axi_wready(s_axi_wready),
      .s_axi_bresp(s_axi_bresp),
      .s_axi_bvalid(s_axi_bvalid),
      .s_axi_bready(s_axi_bready),
      .s_axi_araddr(s_axi_araddr),
      .s_axi_arvalid(s_axi_arvalid),
      .s_axi_arready(s_axi_arready),
      .s_axi_rdata(s_axi_rdata),
      .s_axi_rresp(s_axi_rresp),
      .s_axi_rvalid(s_axi_rvalid),
      .s_axi_rready(s_axi_rready),
?frames|@FRAME_PINS@
      .frame(frame),
      .error(error),
      .clear_error(clear_error),
      .busy(busy),
      .pixel(m_axis_tvalid & m_axis_tready),
      .blocked(blocked),
      .starved(starved)
  );
endmodule

`default_nettype wire
