// MULT18X18D: the multiplier block of Lattice's ECP5, 18 by 18 bits, for simulators.
//
// Written for Specula from the primitive's behaviour as Lattice describes it; MIT OR Apache-2.0, as
// Specula is.
//
// Each operand has a register, and its signedness goes through that register too. Operands are
// extended to 36 bits, each as its signedness says, and the product is the lower 36 bits. It has a
// pipeline register, and an output register behind that; SIGNEDP goes through the first alone. A
// register whose clock is "NONE" is not there. Reset goes before clock enable. All registers begin
// as 0. With CLK0_DIV to CLK3_DIV "ENABLED", as they are by default, a register takes a value at
// each rising edge.
//
// Not modelled, and refused: registers that take values at both edges, a register for the operand
// C, which only passes to ROC here, second operands that alternate, the register that matches a
// cascade, and the bypass of the multiplier. There is no global reset here, so GSR makes no
// difference.
`default_nettype none

module MULT18X18D #(
    parameter REG_INPUTA_CLK = "NONE",
    parameter REG_INPUTA_CE = "CE0",
    parameter REG_INPUTA_RST = "RST0",
    parameter REG_INPUTB_CLK = "NONE",
    parameter REG_INPUTB_CE = "CE0",
    parameter REG_INPUTB_RST = "RST0",
    parameter REG_INPUTC_CLK = "NONE",
    parameter REG_INPUTC_CE = "CE0",
    parameter REG_INPUTC_RST = "RST0",
    parameter REG_PIPELINE_CLK = "NONE",
    parameter REG_PIPELINE_CE = "CE0",
    parameter REG_PIPELINE_RST = "RST0",
    parameter REG_OUTPUT_CLK = "NONE",
    parameter REG_OUTPUT_CE = "CE0",
    parameter REG_OUTPUT_RST = "RST0",
    parameter CLK0_DIV = "ENABLED",
    parameter CLK1_DIV = "ENABLED",
    parameter CLK2_DIV = "ENABLED",
    parameter CLK3_DIV = "ENABLED",
    parameter HIGHSPEED_CLK = "NONE",
    parameter GSR = "ENABLED",
    parameter CAS_MATCH_REG = "FALSE",
    parameter SOURCEB_MODE = "B_SHIFT",
    parameter MULT_BYPASS = "DISABLED",
    parameter RESETMODE = "SYNC"
) (
    input wire A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0,
    input wire B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0,
    input wire C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0,
    input wire SIGNEDA, SIGNEDB, SOURCEA, SOURCEB,
    input wire CLK0, CLK1, CLK2, CLK3, CE0, CE1, CE2, CE3, RST0, RST1, RST2, RST3,
    input wire SRIA17, SRIA16, SRIA15, SRIA14, SRIA13, SRIA12, SRIA11, SRIA10, SRIA9, SRIA8, SRIA7,
        SRIA6, SRIA5, SRIA4, SRIA3, SRIA2, SRIA1, SRIA0,
    input wire SRIB17, SRIB16, SRIB15, SRIB14, SRIB13, SRIB12, SRIB11, SRIB10, SRIB9, SRIB8, SRIB7,
        SRIB6, SRIB5, SRIB4, SRIB3, SRIB2, SRIB1, SRIB0,
    output wire SROA17, SROA16, SROA15, SROA14, SROA13, SROA12, SROA11, SROA10, SROA9, SROA8, SROA7,
        SROA6, SROA5, SROA4, SROA3, SROA2, SROA1, SROA0,
    output wire SROB17, SROB16, SROB15, SROB14, SROB13, SROB12, SROB11, SROB10, SROB9, SROB8, SROB7,
        SROB6, SROB5, SROB4, SROB3, SROB2, SROB1, SROB0,
    output wire ROA17, ROA16, ROA15, ROA14, ROA13, ROA12, ROA11, ROA10, ROA9, ROA8, ROA7, ROA6,
        ROA5, ROA4, ROA3, ROA2, ROA1, ROA0,
    output wire ROB17, ROB16, ROB15, ROB14, ROB13, ROB12, ROB11, ROB10, ROB9, ROB8, ROB7, ROB6,
        ROB5, ROB4, ROB3, ROB2, ROB1, ROB0,
    output wire ROC17, ROC16, ROC15, ROC14, ROC13, ROC12, ROC11, ROC10, ROC9, ROC8, ROC7, ROC6,
        ROC5, ROC4, ROC3, ROC2, ROC1, ROC0,
    output wire P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19,
        P18, P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0,
    output wire SIGNEDP
);
  wire [3:0] clocks = {CLK3, CLK2, CLK1, CLK0};
  wire [3:0] enables = {CE3, CE2, CE1, CE0};
  wire [3:0] resets = {RST3, RST2, RST1, RST0};
  wire [17:0] a = {
    A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0
  };
  wire [17:0] b = {
    B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0
  };
  wire [17:0] shifted_a = {
    SRIA17, SRIA16, SRIA15, SRIA14, SRIA13, SRIA12, SRIA11, SRIA10, SRIA9, SRIA8, SRIA7, SRIA6,
    SRIA5, SRIA4, SRIA3, SRIA2, SRIA1, SRIA0
  };
  wire [17:0] shifted_b = {
    SRIB17, SRIB16, SRIB15, SRIB14, SRIB13, SRIB12, SRIB11, SRIB10, SRIB9, SRIB8, SRIB7, SRIB6,
    SRIB5, SRIB4, SRIB3, SRIB2, SRIB1, SRIB0
  };

  wire [17:0] operand_a, operand_b;
  wire signed_a, signed_b;
  MULT18X18D_REGISTER #(
      .WIDTH(19), .MODE(RESETMODE),
      .CLOCK(REG_INPUTA_CLK), .ENABLE(REG_INPUTA_CE), .RESET(REG_INPUTA_RST)
  ) input_a (
      .clocks(clocks), .enables(enables), .resets(resets),
      .d({SIGNEDA, SOURCEA ? shifted_a : a}), .q({signed_a, operand_a})
  );
  MULT18X18D_REGISTER #(
      .WIDTH(19), .MODE(RESETMODE),
      .CLOCK(REG_INPUTB_CLK), .ENABLE(REG_INPUTB_CE), .RESET(REG_INPUTB_RST)
  ) input_b (
      .clocks(clocks), .enables(enables), .resets(resets),
      .d({SIGNEDB, SOURCEB ? shifted_b : b}), .q({signed_b, operand_b})
  );

  wire [35:0] extended_a = {{18{signed_a & operand_a[17]}}, operand_a};
  wire [35:0] extended_b = {{18{signed_b & operand_b[17]}}, operand_b};
  wire [35:0] product, pipelined;
  assign product = extended_a * extended_b;
  MULT18X18D_REGISTER #(
      .WIDTH(37), .MODE(RESETMODE),
      .CLOCK(REG_PIPELINE_CLK), .ENABLE(REG_PIPELINE_CE), .RESET(REG_PIPELINE_RST)
  ) pipeline (
      .clocks(clocks), .enables(enables), .resets(resets),
      .d({signed_a | signed_b, product}), .q({SIGNEDP, pipelined})
  );

  wire [35:0] result;
  MULT18X18D_REGISTER #(
      .WIDTH(36), .MODE(RESETMODE),
      .CLOCK(REG_OUTPUT_CLK), .ENABLE(REG_OUTPUT_CE), .RESET(REG_OUTPUT_RST)
  ) result_register (
      .clocks(clocks), .enables(enables), .resets(resets),
      .d(pipelined), .q(result)
  );

  assign {
    P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18, P17,
    P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
  } = result;
  assign {
    ROA17, ROA16, ROA15, ROA14, ROA13, ROA12, ROA11, ROA10, ROA9, ROA8, ROA7, ROA6, ROA5, ROA4,
    ROA3, ROA2, ROA1, ROA0
  } = operand_a;
  assign {
    SROA17, SROA16, SROA15, SROA14, SROA13, SROA12, SROA11, SROA10, SROA9, SROA8, SROA7, SROA6,
    SROA5, SROA4, SROA3, SROA2, SROA1, SROA0
  } = operand_a;
  assign {
    ROB17, ROB16, ROB15, ROB14, ROB13, ROB12, ROB11, ROB10, ROB9, ROB8, ROB7, ROB6, ROB5, ROB4,
    ROB3, ROB2, ROB1, ROB0
  } = operand_b;
  assign {
    SROB17, SROB16, SROB15, SROB14, SROB13, SROB12, SROB11, SROB10, SROB9, SROB8, SROB7, SROB6,
    SROB5, SROB4, SROB3, SROB2, SROB1, SROB0
  } = operand_b;
  assign {
    ROC17, ROC16, ROC15, ROC14, ROC13, ROC12, ROC11, ROC10, ROC9, ROC8, ROC7, ROC6, ROC5, ROC4,
    ROC3, ROC2, ROC1, ROC0
  } = {
    C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0
  };

  // To standard error.
  task refuse;
    input [8*16-1:0] name;
    input [8*16-1:0] value;
    begin
      $fdisplay(32'h8000_0002, "MULT18X18D: %0s = %0s is not modelled", name, value);
      $finish;
    end
  endtask

  initial begin
    if (REG_INPUTC_CLK != "NONE") refuse("REG_INPUTC_CLK", REG_INPUTC_CLK);
    if (CLK0_DIV != "ENABLED") refuse("CLK0_DIV", CLK0_DIV);
    if (CLK1_DIV != "ENABLED") refuse("CLK1_DIV", CLK1_DIV);
    if (CLK2_DIV != "ENABLED") refuse("CLK2_DIV", CLK2_DIV);
    if (CLK3_DIV != "ENABLED") refuse("CLK3_DIV", CLK3_DIV);
    if (HIGHSPEED_CLK != "NONE") refuse("HIGHSPEED_CLK", HIGHSPEED_CLK);
    if (GSR != "ENABLED" && GSR != "DISABLED" && GSR != "AUTO") refuse("GSR", GSR);
    if (CAS_MATCH_REG != "FALSE") refuse("CAS_MATCH_REG", CAS_MATCH_REG);
    if (SOURCEB_MODE != "B_SHIFT") refuse("SOURCEB_MODE", SOURCEB_MODE);
    if (MULT_BYPASS != "DISABLED") refuse("MULT_BYPASS", MULT_BYPASS);
    if (RESETMODE != "SYNC" && RESETMODE != "ASYNC") refuse("RESETMODE", RESETMODE);
  end
endmodule

// A register of the block: the last character of a name says which clock, enable or reset it takes.
module MULT18X18D_REGISTER #(
    parameter WIDTH = 18,
    parameter [127:0] CLOCK = "NONE",
    parameter [127:0] ENABLE = "CE0",
    parameter [127:0] RESET = "RST0",
    parameter [127:0] MODE = "SYNC"
) (
    input wire [3:0]        clocks,
    input wire [3:0]        enables,
    input wire [3:0]        resets,
    input wire [WIDTH-1:0]  d,
    output wire [WIDTH-1:0] q
);
  wire clock = clocks[CLOCK[1:0]];
  wire enable = enables[ENABLE[1:0]];
  wire reset = resets[RESET[1:0]];
  reg [WIDTH-1:0] held;
  assign q = CLOCK == "NONE" ? d : held;
  initial held = {WIDTH{1'b0}};

  generate
    if (MODE == "ASYNC") begin : asynchronous
      always @(posedge clock or posedge reset) begin
        if (reset) held <= {WIDTH{1'b0}};
        else if (enable) held <= d;
      end
    end else begin : synchronous
      always @(posedge clock) begin
        if (reset) held <= {WIDTH{1'b0}};
        else if (enable) held <= d;
      end
    end
  endgenerate

  // To standard error.
  task refuse;
    input [127:0] name;
    begin
      $fdisplay(32'h8000_0002, "MULT18X18D: a register has no %0s to take", name);
      $finish;
    end
  endtask

  initial begin
    if (CLOCK != "NONE" && {CLOCK[127:2], 2'd0} != "CLK0") refuse(CLOCK);
    if ({ENABLE[127:2], 2'd0} != "CE0") refuse(ENABLE);
    if ({RESET[127:2], 2'd0} != "RST0") refuse(RESET);
  end
endmodule

`default_nettype wire
