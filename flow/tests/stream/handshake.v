// Sends the words of handshake.hex to a block whose registers have been written, holds `m_axis_tready` low
// in the two clocks from REFUSED on, and prints the signals of each clock, the first word's being 0.
module handshake;
  reg aclk = 1'b0;
  reg aresetn = 1'b0;
  reg [63:0] writes[0:`WRITES];
  reg [`WORD-1:0] words[0:`WORDS-1];
  integer clock = -40 - 4 * `WRITES;
  integer next_word = 0;
  integer next_write = 0;

  initial begin
    $readmemh("handshake.hex", words);
    if (`WRITES > 0) $readmemh("shader_registers.hex", writes, 0, `WRITES - 1);
    forever #5 aclk = ~aclk;
  end

  reg [`WORD-1:0] s_axis_tdata;
  reg s_axis_tvalid = 1'b0;
  wire s_axis_tready;
  reg s_axis_tlast = 1'b0;
  wire [`PIXEL-1:0] m_axis_tdata;
  wire m_axis_tvalid;
  reg m_axis_tready = 1'b1;
  wire m_axis_tuser;
  wire m_axis_tlast;
  reg writing = 1'b0;
  wire written;

  always @(posedge aclk) begin
    clock <= clock + 1;
    aresetn <= clock > -38 - 4 * `WRITES;
    if (written) begin
      writing <= 1'b0;
      next_write <= next_write + 1;
    end else if (clock > -30 - 4 * `WRITES && next_write < `WRITES) writing <= 1'b1;
    if (clock >= -1 && (!s_axis_tvalid || s_axis_tready)) begin
      s_axis_tvalid <= next_word < `WORDS;
      s_axis_tdata <= words[next_word];
      s_axis_tlast <= next_word == `WORDS - 2 || `WORDS == 2;
      next_word <= next_word + 1;
    end
    m_axis_tready <= clock + 1 != `REFUSED && clock != `REFUSED;
    if (clock >= 0)
      $display("%0d %h %b %b %b %h %b %b %b %b", clock, s_axis_tdata, s_axis_tvalid, s_axis_tready,
               s_axis_tlast, m_axis_tdata, m_axis_tvalid, m_axis_tready, m_axis_tuser, m_axis_tlast);
    if (clock == `LAST) $finish;
  end

  shader_ip dut (
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
      .s_axi_awaddr(writes[next_write][43:32]),
      .s_axi_awvalid(writing),
      .s_axi_awready(written),
      .s_axi_wdata(writes[next_write][31:0]),
      .s_axi_wstrb(4'b1111),
      .s_axi_wvalid(writing),
      .s_axi_bready(1'b1),
      .s_axi_arvalid(1'b0),
      .s_axi_rready(1'b1)
  );
endmodule
