//! Circuits of the cells that families have besides look-up tables.
use super::circuit::{CELL, Pipeline, register};

/// Cells that a family is measured with.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// Look-up tables in a row that are measured: as many as there are between registers at clocks
    /// that the family is asked for.
    pub depths: &'static [u32],
    /// The multiplier block, if it has one.
    pub multiplier: Option<Multiplier>,
    /// The block RAM.
    pub memory: Memory,
    /// Whether look-up tables can be memories.
    pub has_distributed_memory: bool,
}

/// A multiplier block.
#[derive(Clone, Copy, Debug)]
pub struct Multiplier {
    /// Width of each operand, in bits.
    pub width: u32,
    /// How many of them a circuit has: side by side, and one behind the other.
    pub arrangement: [u32; 2],
    /// The instance with so many of its registers, as Verilog: first that of the product, then those
    /// of the operands, then the one inside.
    instance: fn(u32, &str, [&str; 3]) -> String,
    /// The numbers of registers with which it is measured.
    pub registers: &'static [u32],
}

/// Block RAM.
#[derive(Clone, Copy, Debug)]
pub struct Memory {
    /// Width of what is measured, in bits.
    width: u32,
    /// Bits of the address.
    address: u32,
    /// Whether it has a register at its output.
    pub has_output_register: bool,
    /// The instance, as Verilog; with its register at the output if the first argument says so.
    instance: fn(bool, &str, [&str; 2]) -> String,
}

impl Family {
    /// Lattice's ECP5.
    pub const ECP5: Family = Family {
        multiplier: Some(Multiplier {
            width: 18,
            arrangement: [5, 4],
            instance: mult18x18d,
            registers: &[0, 1, 2, 3],
        }),
        memory: Memory { width: 18, address: 10, has_output_register: true, instance: dp16kd },
        depths: &[1, 2],
        has_distributed_memory: true,
    };
    /// Lattice's iCE40 HX.
    pub const ICE40_HX: Family = Family {
        multiplier: None,
        memory: Memory { width: 16, address: 8, has_output_register: false, instance: sb_ram40 },
        depths: &[1, 2, 4],
        has_distributed_memory: false,
    };
    /// Lattice's iCE40 UltraPlus. nextpnr times its block as if it had every register.
    pub const ICE40_UP: Family = Family {
        multiplier: Some(Multiplier {
            width: 16,
            arrangement: [4, 2],
            instance: sb_mac16,
            registers: &[3],
        }),
        ..Family::ICE40_HX
    };
    /// Gowin's Arora.
    pub const GOWIN: Family = Family {
        multiplier: Some(Multiplier {
            width: 18,
            arrangement: [5, 4],
            instance: mult18x18,
            registers: &[0, 1, 2, 3],
        }),
        memory: Memory { width: 16, address: 10, has_output_register: true, instance: prom },
        depths: &[1, 2, 4],
        has_distributed_memory: true,
    };
}

impl Multiplier {
    /// A circuit of blocks, with a register behind each.
    pub fn circuit(&self, registers: u32) -> String {
        let [lanes, stages] = self.arrangement;
        let (width, product) = (self.width, 2 * self.width);
        Pipeline { width: product, lanes, stages }.text(|name, [a, b, ..]| {
            let wire = format!("{CELL}_{name}_product");
            let a = format!("{a}[{}:{width}]", product - 1);
            let b = format!("{b}[{}:0]", width - 1);
            format!(
                "  wire [{}:0] {wire};\n{}{}",
                product - 1,
                (self.instance)(registers, &format!("{CELL}_{name}"), [&a, &b, &wire]),
                register(name, product, &wire)
            )
        })
    }
}

impl Memory {
    /// A circuit of memories, with a register behind each.
    pub fn circuit(&self, has_output_register: bool) -> String {
        let Memory { width, address, .. } = *self;
        Pipeline { width, lanes: 4, stages: 3 }.text(|name, [a, ..]| {
            let wire = format!("{CELL}_{name}_word");
            let a = format!("{a}[{}:0]", address - 1);
            format!(
                "  wire [{}:0] {wire};\n{}{}",
                width - 1,
                (self.instance)(has_output_register, &format!("{CELL}_{name}"), [&a, &wire]),
                register(name, width, &wire)
            )
        })
    }
}

/// The bits of a value at ports that have one each; `value` is a name with a range of bits, or one
/// of `width` bits.
fn bits(port: &str, value: &str, width: u32) -> String {
    let (name, last) = match value.split_once('[') {
        Some((name, range)) => (name, range.rsplit_once(':').map_or(range, |(_, low)| low)),
        None => (value, "0"),
    };
    let low: u32 = last.trim_end_matches(']').parse().unwrap_or(0);
    let bit = |at: u32| format!(".{port}{at}({name}[{}])", low + at);
    (0..width).map(bit).collect::<Vec<String>>().join(", ")
}

fn mult18x18d(registers: u32, name: &str, [a, b, product]: [&str; 3]) -> String {
    let [of_product, of_operands, inside] =
        [1, 2, 3].map(|least| if registers >= least { "CLK0" } else { "NONE" });
    format!(
        "  MULT18X18D #(.REG_INPUTA_CLK(\"{of_operands}\"), .REG_INPUTB_CLK(\"{of_operands}\"), \
         .REG_PIPELINE_CLK(\"{inside}\"), .REG_OUTPUT_CLK(\"{of_product}\")) {name} (.CLK0(clk), \
         .CE0(1'b1), .RST0(1'b0), .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0), \
         {}, {}, {});\n",
        bits("A", a, 18),
        bits("B", b, 18),
        bits("P", product, 36),
    )
}

fn dp16kd(has_output_register: bool, name: &str, [address, word]: [&str; 2]) -> String {
    let mode = if has_output_register { "OUTREG" } else { "NOREG" };
    let address = (0..10).map(|at| format!(".ADA{}({}[{at}])", at + 4, name_of(address)));
    format!(
        "  DP16KD #(.DATA_WIDTH_A(18), .REGMODE_A(\"{mode}\")) {name} (.CLKA(clk), .CEA(1'b1), \
         .OCEA(1'b1), .WEA(1'b0), .RSTA(1'b0), .CSA0(1'b0), .CSA1(1'b0), .CSA2(1'b0), {}, {});\n",
        address.collect::<Vec<String>>().join(", "),
        bits("DOA", word, 18),
    )
}

fn sb_ram40(_: bool, name: &str, [address, word]: [&str; 2]) -> String {
    format!(
        "  SB_RAM40_4K #(.READ_MODE(0), .WRITE_MODE(0)) {name} (.RCLK(clk), .RCLKE(1'b1), \
         .RE(1'b1), .WCLK(clk), .WCLKE(1'b0), .WE(1'b0), .RADDR({{3'b0, {address}}}), \
         .RDATA({word}));\n"
    )
}

fn sb_mac16(registers: u32, name: &str, [a, b, product]: [&str; 3]) -> String {
    let [of_product, of_operands, inside] = [1, 2, 3].map(|least| u32::from(registers >= least));
    format!(
        "  SB_MAC16 #(.A_REG(1'b{of_operands}), .B_REG(1'b{of_operands}), \
         .TOP_8x8_MULT_REG(1'b{inside}), .BOT_8x8_MULT_REG(1'b{inside}), \
         .PIPELINE_16x16_MULT_REG1(1'b{inside}), .PIPELINE_16x16_MULT_REG2(1'b{of_product}), \
         .TOPOUTPUT_SELECT(2'b11), .BOTOUTPUT_SELECT(2'b11), .A_SIGNED(1'b1), .B_SIGNED(1'b1)) \
         {name} (.CLK(clk), .CE(1'b1), .A({a}), .B({b}), .O({product}));\n"
    )
}

fn mult18x18(registers: u32, name: &str, [a, b, product]: [&str; 3]) -> String {
    let [of_product, of_operands, inside] = [1, 2, 3].map(|least| u32::from(registers >= least));
    format!(
        "  MULT18X18 #(.AREG(1'b{of_operands}), .BREG(1'b{of_operands}), .PIPE_REG(1'b{inside}), \
         .OUT_REG(1'b{of_product}), .ASIGN_REG(1'b0), .BSIGN_REG(1'b0), .SOA_REG(1'b0), \
         .MULT_RESET_MODE(\"SYNC\")) {name} (.CLK(clk), .CE(1'b1), .RESET(1'b0), .A({a}), .B({b}), \
         .SIA(18'b0), .SIB(18'b0), .ASIGN(1'b1), .BSIGN(1'b1), .ASEL(1'b0), .BSEL(1'b0), \
         .DOUT({product}));\n"
    )
}

fn prom(has_output_register: bool, name: &str, [address, word]: [&str; 2]) -> String {
    format!(
        "  wire [15:0] {name}_unused;\n\
         \x20 pROM #(.READ_MODE(1'b{}), .BIT_WIDTH(16), .RESET_MODE(\"SYNC\")) {name} (.CLK(clk), \
         .CE(1'b1), .OCE(1'b1), .RESET(1'b0), .AD({{{address}, 4'b0}}), \
         .DO({{{name}_unused, {word}}}));\n",
        u32::from(has_output_register),
    )
}

/// The name of a value with a range of bits.
fn name_of(value: &str) -> &str {
    value.split_once('[').map_or(value, |(name, _)| name)
}
