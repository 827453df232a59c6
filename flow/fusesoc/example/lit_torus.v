// A design around the core `shader`: the registers are out of use, and pixels go out as red, green
// and blue.
`default_nettype none

module lit_torus (
    input  wire        clock,
    input  wire        reset,
    input  wire [31:0] word,
    input  wire        word_valid,
    output wire        word_ready,
    input  wire        word_last,
    output wire [7:0]  red,
    output wire [7:0]  green,
    output wire [7:0]  blue,
    output wire        pixel_valid,
    input  wire        pixel_ready
);
  shader_ip shader (
      .aclk(clock),
      .aresetn(~reset),
      .s_axis_tdata(word),
      .s_axis_tvalid(word_valid),
      .s_axis_tready(word_ready),
      .s_axis_tlast(word_last),
      .m_axis_tdata({blue, green, red}),
      .m_axis_tvalid(pixel_valid),
      .m_axis_tready(pixel_ready),
      .m_axis_tuser(),
      .m_axis_tlast(),
      .s_axi_awaddr(12'd0),
      .s_axi_awvalid(1'b0),
      .s_axi_awready(),
      .s_axi_wdata(32'd0),
      .s_axi_wstrb(4'd0),
      .s_axi_wvalid(1'b0),
      .s_axi_wready(),
      .s_axi_bresp(),
      .s_axi_bvalid(),
      .s_axi_bready(1'b1),
      .s_axi_araddr(12'd0),
      .s_axi_arvalid(1'b0),
      .s_axi_arready(),
      .s_axi_rdata(),
      .s_axi_rresp(),
      .s_axi_rvalid(),
      .s_axi_rready(1'b1)
  );
endmodule

`default_nettype wire
