//! The modules that products in multiplier blocks are instances of.
use std::collections::BTreeSet;

use crate::block::WireType;
use crate::design::{MultiplierBlock, NodeId};
use crate::target::Cells;

/// The multiplier modules of a file: their names, and the texts of those that are instantiated.
#[derive(Clone, Debug)]
pub struct MultiplierModules {
    prefix: String,
    used: BTreeSet<Cells>,
}

impl MultiplierModules {
    /// None of them used yet; their names begin with `prefix`.
    pub fn new(prefix: &str) -> MultiplierModules {
        MultiplierModules { prefix: prefix.to_owned(), used: BTreeSet::new() }
    }

    /// Notes that there is a product in such a block.
    pub fn note(&mut self, cells: Cells) {
        self.used.insert(cells);
    }

    /// Module and parameters of a product of factors like these.
    pub fn instantiated(&self, block: &MultiplierBlock, shapes: [Factor; 2], width: u32) -> String {
        let [a, b] = shapes;
        format!(
            "{} #(\n      .REGISTERS({}), .WIDTH_A({}), .SIGNED_A({}), .WIDTH_B({}), .SIGNED_B({}), \
             .WIDTH_P({width})\n  )",
            self.name(),
            block.registers,
            a.width,
            u32::from(a.signed),
            b.width,
            u32::from(b.signed),
        )
    }

    /// The texts of those that are used.
    pub fn sources(&self) -> impl Iterator<Item = String> {
        self.used.iter().map(|cells| {
            let cell = match cells {
                Cells::Ecp5 => ecp5(),
                Cells::Ice40up => ICE40UP.to_owned(),
            };
            FRAME.replacen("NAME", &self.name(), 1).replacen("CELL\n", &cell, 1)
        })
    }

    fn name(&self) -> String {
        format!("{}_{UNIT}", self.prefix)
    }
}

/// Whether a multiplier module has the name that a unit's first module would have.
pub fn is_named_as(unit: &str) -> bool {
    unit == UNIT
}

const UNIT: &str = "multiplier";

/// What a factor's port is.
#[derive(Clone, Copy, Debug)]
pub struct Factor {
    /// Width in bits.
    pub width: u32,
    /// Whether it is in two's complement.
    pub signed: bool,
}

impl Factor {
    /// The port for a wire.
    pub fn of(wire: &WireType) -> Factor {
        Factor { width: wire.width, signed: wire.signed }
    }
}

/// Where a simulator has the registers inside an instance: the scopes in it, and the net.
pub fn places_inside(
    block: &MultiplierBlock,
) -> impl Iterator<Item = (NodeId, &'static str, &'static str)> {
    let [a, b] = block.taken;
    let b = b.filter(|&b| Some(b) != a);
    let taken = [(a, "a_held"), (b, "b_held")].map(|(id, net)| (id, "factor_registers", net));
    let pipelined = [(block.pipelined, "pipeline_register", "held")];
    taken.into_iter().chain(pipelined).filter_map(|(id, scope, net)| Some((id?, scope, net)))
}

/// One module for all: what synthesis instantiates, and what simulators see.
const FRAME: &str = "\
// multiplier: p is a times b, REGISTERS clocks later, 0 to 3: behind the product, then before it too,
// then inside it as well. For synthesis it is a block of the device with its own registers.
module NAME #(
    parameter REGISTERS = 0,
    parameter WIDTH_A = 2,
    parameter SIGNED_A = 1,
    parameter WIDTH_B = 2,
    parameter SIGNED_B = 1,
    parameter WIDTH_P = 4
) (
    input wire                clock,
    input wire [WIDTH_A-1:0]  a,
    input wire [WIDTH_B-1:0]  b,
    output wire [WIDTH_P-1:0] p
);
`ifdef SYNTHESIS
CELL
`else
  wire [WIDTH_A-1:0] a_taken;
  wire [WIDTH_B-1:0] b_taken;
  // A sign bit before both, so that the product is that of signed numbers whatever the factors are.
  wire signed [WIDTH_A:0] a_signed = {SIGNED_A != 0 && a_taken[WIDTH_A-1], a_taken};
  wire signed [WIDTH_B:0] b_signed = {SIGNED_B != 0 && b_taken[WIDTH_B-1], b_taken};
  wire signed [WIDTH_A+WIDTH_B+1:0] whole = a_signed * b_signed;
  wire [WIDTH_P-1:0] product = whole[WIDTH_P-1:0];
  wire [WIDTH_P-1:0] pipelined;
  wire unused_bits = &{1'b0, clock, whole};

  generate
    if (REGISTERS >= 2) begin : factor_registers
      reg [WIDTH_A-1:0] a_held;
      reg [WIDTH_B-1:0] b_held;
      assign a_taken = a_held;
      assign b_taken = b_held;
      always @(posedge clock) begin
        a_held <= a;
        b_held <= b;
      end
    end else begin : no_factor_registers
      assign a_taken = a;
      assign b_taken = b;
    end
    if (REGISTERS >= 3) begin : pipeline_register
      reg [WIDTH_P-1:0] held;
      assign pipelined = held;
      always @(posedge clock) held <= product;
    end else begin : no_pipeline_register
      assign pipelined = product;
    end
    if (REGISTERS >= 1) begin : product_register
      reg [WIDTH_P-1:0] held;
      assign p = held;
      always @(posedge clock) held <= pipelined;
    end else begin : no_product_register
      assign p = pipelined;
    end
  endgenerate
`endif
endmodule
";

/// The ECP5's block, as Lattice's sysDSP guide describes it.
fn ecp5() -> String {
    let pins = |port: &str, net: &str, bits: u32| {
        let pins: Vec<String> =
            (0..bits).map(|bit| format!(".{port}{bit}({net}[{bit}])")).collect();
        let rows: Vec<String> = pins.chunks(6).map(|row| row.join(", ")).collect();
        rows.join(",\n      ")
    };
    let zeros: Vec<String> = (0..18).map(|bit| format!(".C{bit}(1'b0)")).collect();
    let zeros: Vec<String> = zeros.chunks(6).map(|row| row.join(", ")).collect();
    format!(
        "  wire [17:0] a_wide = {{{{18{{SIGNED_A != 0 && a[WIDTH_A-1]}}}}, a}};\n\
        \x20 wire [17:0] b_wide = {{{{18{{SIGNED_B != 0 && b[WIDTH_B-1]}}}}, b}};\n\
        \x20 wire [35:0] product;\n\
        \x20 assign p = product[WIDTH_P-1:0];\n\
        \x20 MULT18X18D #(\n\
        \x20     .REG_INPUTA_CLK(REGISTERS >= 2 ? \"CLK0\" : \"NONE\"),\n\
        \x20     .REG_INPUTB_CLK(REGISTERS >= 2 ? \"CLK0\" : \"NONE\"),\n\
        \x20     .REG_PIPELINE_CLK(REGISTERS >= 3 ? \"CLK0\" : \"NONE\"),\n\
        \x20     .REG_OUTPUT_CLK(REGISTERS >= 1 ? \"CLK0\" : \"NONE\"),\n\
        \x20     .GSR(\"DISABLED\")\n\
        \x20 ) block (\n\
        \x20     .CLK0(clock), .CE0(1'b1), .RST0(1'b0),\n\
        \x20     .SIGNEDA(SIGNED_A != 0), .SIGNEDB(SIGNED_B != 0), .SOURCEA(1'b0), .SOURCEB(1'b0),\n\
        \x20     {},\n      {},\n      {},\n      {}\n\
        \x20 );\n",
        pins("A", "a_wide", 18),
        pins("B", "b_wide", 18),
        zeros.join(",\n      "),
        pins("P", "product", 36),
    )
}

/// The iCE40 UltraPlus's block, as Lattice's DSP guide describes it.
const ICE40UP: &str = "\
  wire [15:0] a_wide = {{16{SIGNED_A != 0 && a[WIDTH_A-1]}}, a};
  wire [15:0] b_wide = {{16{SIGNED_B != 0 && b[WIDTH_B-1]}}, b};
  wire [31:0] product;
  assign p = product[WIDTH_P-1:0];
  SB_MAC16 #(
      .A_REG(REGISTERS >= 2), .B_REG(REGISTERS >= 2),
      .TOP_8x8_MULT_REG(REGISTERS >= 3), .BOT_8x8_MULT_REG(REGISTERS >= 3),
      .PIPELINE_16x16_MULT_REG1(REGISTERS >= 3), .PIPELINE_16x16_MULT_REG2(REGISTERS >= 1),
      .TOPOUTPUT_SELECT(2'b11), .BOTOUTPUT_SELECT(2'b11),
      .A_SIGNED(SIGNED_A != 0), .B_SIGNED(SIGNED_B != 0)
  ) block (
      .CLK(clock), .CE(1'b1), .A(a_wide), .B(b_wide), .C(16'd0), .D(16'd0),
      .AHOLD(1'b0), .BHOLD(1'b0), .CHOLD(1'b0), .DHOLD(1'b0),
      .IRSTTOP(1'b0), .IRSTBOT(1'b0), .ORSTTOP(1'b0), .ORSTBOT(1'b0),
      .OLOADTOP(1'b0), .OLOADBOT(1'b0), .ADDSUBTOP(1'b0), .ADDSUBBOT(1'b0),
      .OHOLDTOP(1'b0), .OHOLDBOT(1'b0), .CI(1'b0), .ACCUMCI(1'b0), .SIGNEXTIN(1'b0),
      .O(product)
  );
";
