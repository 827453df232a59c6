// DP16KD: the block RAM of Lattice's ECP5, 18 Kbit, for simulators.
//
// Written for Specula from the primitive's behaviour as Lattice describes it; MIT OR Apache-2.0, as
// Specula is.
//
// There are 2048 bytes of nine bits. A port of 9 bits reads and writes byte AD[13:3], one of 18
// bits the two bytes from 2 AD[13:4], and AD1 and AD0 say which of them are written. Of ports of 36
// bits, A only writes the four bytes from 4 AD[13:5], as AD3 to AD0 say, from DIB and DIA, and B
// only reads, to DOB and DOA. An INITVAL holds sixteen words of 18 bits, 20 bits apart. What is
// read stands in a register; with REGMODE "OUTREG" there is one more. While a port writes, what it
// read stays, or is what is overwritten, with WRITEMODE "READBEFOREWRITE". All registers begin as
// 0. Reset goes before clock enable, and nothing is written meanwhile.
//
// Not modelled, and refused: narrower ports, other decodings of CS than 0, and ports that show what
// they write. There is no global reset here, so GSR makes no difference.
`default_nettype none

module DP16KD #(
    parameter DATA_WIDTH_A = 18,
    parameter DATA_WIDTH_B = 18,
    parameter REGMODE_A = "NOREG",
    parameter REGMODE_B = "NOREG",
    parameter RESETMODE = "SYNC",
    parameter ASYNC_RESET_RELEASE = "SYNC",
    parameter CSDECODE_A = "0b000",
    parameter CSDECODE_B = "0b000",
    parameter WRITEMODE_A = "NORMAL",
    parameter WRITEMODE_B = "NORMAL",
    parameter CLKAMUX = "CLKA",
    parameter CLKBMUX = "CLKB",
    parameter GSR = "ENABLED",
    parameter [319:0] INITVAL_00 = 320'd0,
    parameter [319:0] INITVAL_01 = 320'd0,
    parameter [319:0] INITVAL_02 = 320'd0,
    parameter [319:0] INITVAL_03 = 320'd0,
    parameter [319:0] INITVAL_04 = 320'd0,
    parameter [319:0] INITVAL_05 = 320'd0,
    parameter [319:0] INITVAL_06 = 320'd0,
    parameter [319:0] INITVAL_07 = 320'd0,
    parameter [319:0] INITVAL_08 = 320'd0,
    parameter [319:0] INITVAL_09 = 320'd0,
    parameter [319:0] INITVAL_0A = 320'd0,
    parameter [319:0] INITVAL_0B = 320'd0,
    parameter [319:0] INITVAL_0C = 320'd0,
    parameter [319:0] INITVAL_0D = 320'd0,
    parameter [319:0] INITVAL_0E = 320'd0,
    parameter [319:0] INITVAL_0F = 320'd0,
    parameter [319:0] INITVAL_10 = 320'd0,
    parameter [319:0] INITVAL_11 = 320'd0,
    parameter [319:0] INITVAL_12 = 320'd0,
    parameter [319:0] INITVAL_13 = 320'd0,
    parameter [319:0] INITVAL_14 = 320'd0,
    parameter [319:0] INITVAL_15 = 320'd0,
    parameter [319:0] INITVAL_16 = 320'd0,
    parameter [319:0] INITVAL_17 = 320'd0,
    parameter [319:0] INITVAL_18 = 320'd0,
    parameter [319:0] INITVAL_19 = 320'd0,
    parameter [319:0] INITVAL_1A = 320'd0,
    parameter [319:0] INITVAL_1B = 320'd0,
    parameter [319:0] INITVAL_1C = 320'd0,
    parameter [319:0] INITVAL_1D = 320'd0,
    parameter [319:0] INITVAL_1E = 320'd0,
    parameter [319:0] INITVAL_1F = 320'd0,
    parameter [319:0] INITVAL_20 = 320'd0,
    parameter [319:0] INITVAL_21 = 320'd0,
    parameter [319:0] INITVAL_22 = 320'd0,
    parameter [319:0] INITVAL_23 = 320'd0,
    parameter [319:0] INITVAL_24 = 320'd0,
    parameter [319:0] INITVAL_25 = 320'd0,
    parameter [319:0] INITVAL_26 = 320'd0,
    parameter [319:0] INITVAL_27 = 320'd0,
    parameter [319:0] INITVAL_28 = 320'd0,
    parameter [319:0] INITVAL_29 = 320'd0,
    parameter [319:0] INITVAL_2A = 320'd0,
    parameter [319:0] INITVAL_2B = 320'd0,
    parameter [319:0] INITVAL_2C = 320'd0,
    parameter [319:0] INITVAL_2D = 320'd0,
    parameter [319:0] INITVAL_2E = 320'd0,
    parameter [319:0] INITVAL_2F = 320'd0,
    parameter [319:0] INITVAL_30 = 320'd0,
    parameter [319:0] INITVAL_31 = 320'd0,
    parameter [319:0] INITVAL_32 = 320'd0,
    parameter [319:0] INITVAL_33 = 320'd0,
    parameter [319:0] INITVAL_34 = 320'd0,
    parameter [319:0] INITVAL_35 = 320'd0,
    parameter [319:0] INITVAL_36 = 320'd0,
    parameter [319:0] INITVAL_37 = 320'd0,
    parameter [319:0] INITVAL_38 = 320'd0,
    parameter [319:0] INITVAL_39 = 320'd0,
    parameter [319:0] INITVAL_3A = 320'd0,
    parameter [319:0] INITVAL_3B = 320'd0,
    parameter [319:0] INITVAL_3C = 320'd0,
    parameter [319:0] INITVAL_3D = 320'd0,
    parameter [319:0] INITVAL_3E = 320'd0,
    parameter [319:0] INITVAL_3F = 320'd0
) (
    input wire DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5,
        DIA4, DIA3, DIA2, DIA1, DIA0,
    input wire ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1,
        ADA0,
    input wire CEA, OCEA, CLKA, WEA, RSTA, CSA2, CSA1, CSA0,
    output wire DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6,
        DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
    input wire DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5,
        DIB4, DIB3, DIB2, DIB1, DIB0,
    input wire ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1,
        ADB0,
    input wire CEB, OCEB, CLKB, WEB, RSTB, CSB2, CSB1, CSB0,
    output wire DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6,
        DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);
  wire [13:0] address_a = {
    ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0
  };
  wire [17:0] written_a = {
    DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4,
    DIA3, DIA2, DIA1, DIA0
  };
  wire [13:0] address_b = {
    ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0
  };
  wire [17:0] written_b = {
    DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4,
    DIB3, DIB2, DIB1, DIB0
  };
  wire [35:0] written_wide = {written_b, written_a};

  reg [8:0] bytes [0:2047];
  wire [64*320-1:0] contents = {
    INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39, INITVAL_38,
    INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32, INITVAL_31, INITVAL_30,
    INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B, INITVAL_2A, INITVAL_29, INITVAL_28,
    INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24, INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20,
    INITVAL_1F, INITVAL_1E, INITVAL_1D, INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18,
    INITVAL_17, INITVAL_16, INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10,
    INITVAL_0F, INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
    INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01, INITVAL_00
  };
  integer place;
  initial begin
    for (place = 0; place < 2048; place = place + 1) begin
      bytes[place] = contents[20*(place/2)+9*(place%2)+:9];
    end
  end

  // What ports of 36 bits, and of fewer, read.
  function [35:0] wide_at(input [13:0] address);
    wide_at = {
      bytes[{address[13:5], 2'd3}], bytes[{address[13:5], 2'd2}],
      bytes[{address[13:5], 2'd1}], bytes[{address[13:5], 2'd0}]
    };
  endfunction
  function [17:0] read_at(input [13:0] address, input integer width);
    if (width == 18) read_at = {bytes[{address[13:4], 1'd1}], bytes[{address[13:4], 1'd0}]};
    else read_at = {9'd0, bytes[address[13:3]]};
  endfunction

  // Port A.
  wire clock_a = CLKAMUX == "INV" ? ~CLKA : CLKA;
  wire selected_a = CEA && {CSA2, CSA1, CSA0} == 3'd0;
  reg [17:0] read_a, held_a;
  initial read_a = 0;
  initial held_a = 0;
  integer byte_a;
  wire cleared_a = RESETMODE == "ASYNC" && RSTA;
  always @(posedge clock_a or posedge cleared_a) begin
    if (RSTA) begin
      read_a <= 0;
      held_a <= 0;
    end else begin
      if (OCEA) held_a <= read_a;
      if (selected_a && (!WEA || WRITEMODE_A == "READBEFOREWRITE")) begin
        read_a <= read_at(address_a, DATA_WIDTH_A);
      end
      if (selected_a && WEA) begin
        if (DATA_WIDTH_A == 36) begin
          for (byte_a = 0; byte_a < 4; byte_a = byte_a + 1) begin
            if (address_a[byte_a]) begin
              bytes[{address_a[13:5], byte_a[1:0]}] <= written_wide[9*byte_a+:9];
            end
          end
        end else if (DATA_WIDTH_A == 18) begin
          if (address_a[0]) bytes[{address_a[13:4], 1'd0}] <= written_a[8:0];
          if (address_a[1]) bytes[{address_a[13:4], 1'd1}] <= written_a[17:9];
        end else begin
          bytes[address_a[13:3]] <= written_a[8:0];
        end
      end
    end
  end

  // Port B.
  wire clock_b = CLKBMUX == "INV" ? ~CLKB : CLKB;
  wire selected_b = CEB && {CSB2, CSB1, CSB0} == 3'd0;
  reg [35:0] read_b, held_b;
  initial read_b = 0;
  initial held_b = 0;
  wire cleared_b = RESETMODE == "ASYNC" && RSTB;
  always @(posedge clock_b or posedge cleared_b) begin
    if (RSTB) begin
      read_b <= 0;
      held_b <= 0;
    end else begin
      if (OCEB) held_b <= read_b;
      if (selected_b && (!WEB || WRITEMODE_B == "READBEFOREWRITE")) begin
        if (DATA_WIDTH_B == 36) read_b <= wide_at(address_b);
        else read_b <= {18'd0, read_at(address_b, DATA_WIDTH_B)};
      end
      if (selected_b && WEB) begin
        if (DATA_WIDTH_B == 18) begin
          if (address_b[0]) bytes[{address_b[13:4], 1'd0}] <= written_b[8:0];
          if (address_b[1]) bytes[{address_b[13:4], 1'd1}] <= written_b[17:9];
        end else begin
          bytes[address_b[13:3]] <= written_b[8:0];
        end
      end
    end
  end

  wire [17:0] shown_a = REGMODE_A == "OUTREG" ? held_a : read_a;
  wire [35:0] shown_b = REGMODE_B == "OUTREG" ? held_b : read_b;
  assign {
    DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4,
    DOA3, DOA2, DOA1, DOA0
  } = DATA_WIDTH_B == 36 ? shown_b[17:0] : shown_a;
  assign {
    DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4,
    DOB3, DOB2, DOB1, DOB0
  } = DATA_WIDTH_B == 36 ? shown_b[35:18] : shown_b[17:0];

  // To standard error.
  task refuse;
    input [8*16-1:0] name;
    input [8*16-1:0] value;
    begin
      $fdisplay(32'h8000_0002, "DP16KD: %0s = %0s is not modelled", name, value);
      $finish;
    end
  endtask
  task check_width;
    input [8*16-1:0] name;
    input integer width;
    begin
      if (width != 9 && width != 18 && width != 36) begin
        $fdisplay(32'h8000_0002, "DP16KD: %0s = %0d is not modelled", name, width);
        $finish;
      end
    end
  endtask

  initial begin
    check_width("DATA_WIDTH_A", DATA_WIDTH_A);
    check_width("DATA_WIDTH_B", DATA_WIDTH_B);
    if (REGMODE_A != "NOREG" && REGMODE_A != "OUTREG") refuse("REGMODE_A", REGMODE_A);
    if (REGMODE_B != "NOREG" && REGMODE_B != "OUTREG") refuse("REGMODE_B", REGMODE_B);
    if (RESETMODE != "SYNC" && RESETMODE != "ASYNC") refuse("RESETMODE", RESETMODE);
    if (CSDECODE_A != "0b000") refuse("CSDECODE_A", CSDECODE_A);
    if (CSDECODE_B != "0b000") refuse("CSDECODE_B", CSDECODE_B);
    if (WRITEMODE_A != "NORMAL" && WRITEMODE_A != "READBEFOREWRITE") begin
      refuse("WRITEMODE_A", WRITEMODE_A);
    end
    if (WRITEMODE_B != "NORMAL" && WRITEMODE_B != "READBEFOREWRITE") begin
      refuse("WRITEMODE_B", WRITEMODE_B);
    end
    if (CLKAMUX != "CLKA" && CLKAMUX != "INV") refuse("CLKAMUX", CLKAMUX);
    if (CLKBMUX != "CLKB" && CLKBMUX != "INV") refuse("CLKBMUX", CLKBMUX);
  end
endmodule

`default_nettype wire
