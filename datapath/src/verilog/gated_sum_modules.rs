//! The module that sums of which one summand may be cleared are instances of.
use crate::block::{AtomKind, Cell, Module};
use crate::design::{NodeId, Op, Register};
use crate::target::SumCells;

/// A sum whose first summand is 0 where a bit is 1, by numbers of the module's own wires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GatedSum {
    /// The sum.
    pub sum: u32,
    /// The bit that clears the first summand.
    pub clear: NodeId,
    /// The first summand before it is cleared.
    pub kept: NodeId,
    /// The first summand.
    pub gated: NodeId,
    /// The second.
    pub added: NodeId,
}

impl GatedSum {
    /// Those of a module, in order; none where the target has no cells for them.
    pub fn all(module: &Module) -> Vec<GatedSum> {
        if module.primitives().gated_sum.is_none() {
            return vec![];
        }
        let mut gates: Vec<Option<(NodeId, NodeId)>> = vec![None; module.wires().len()];
        let constant = |id: NodeId| {
            let wire = &module.wires()[id.0 as usize];
            (wire.wire_type().kind == AtomKind::Constant).then(|| wire.value())
        };
        for cell in module.cells().filter(|cell| cell.register == Register::None) {
            if let Op::Select(clear, zero, kept) = cell.op
                && constant(zero) == Some(0)
            {
                gates[cell.wire as usize] = Some((clear, kept));
            }
        }
        let sum = |cell: &Cell| {
            let Op::Add(gated, added) = cell.op else { return None };
            let (clear, kept) = gates[gated.0 as usize]?;
            let [one, other] = [gated, kept].map(|id| module.wires()[id.0 as usize].wire_type());
            // Both reach the sum's width in the same way.
            let same = (one.width, one.signed) == (other.width, other.signed);
            let sum = cell.wire;
            same.then_some(GatedSum { sum, clear, kept, gated, added })
        };
        module.cells().filter(|cell| cell.register == Register::None).filter_map(sum).collect()
    }
}

/// What the module is called, without the core's name.
pub const UNIT: &str = "gated_sum";

/// The text of the module under a name.
pub fn source(name: &str, cells: SumCells) -> String {
    let text = match cells {
        SumCells::Ecp5 => ECP5,
    };
    FRAME.replacen("NAME", name, 1).replacen("CELLS\n", text, 1)
}

/// One module for all: what synthesis instantiates, and what simulators see.
const FRAME: &str = "\
// gated_sum: s is a + b where a is 0 if clear is 1, else what it was. For synthesis a look-up table of
// the carry chain does both; others are told what is left of a as gated_a.
module NAME #(
    parameter WIDTH = 1
) (
    input wire              clear,
    input wire [WIDTH-1:0]  a,
    input wire [WIDTH-1:0]  gated_a,
    input wire [WIDTH-1:0]  b,
    output wire [WIDTH-1:0] s
);
`ifdef SYNTHESIS
CELLS
`else
  assign s = gated_a + b;
  wire unused_bits = &{1'b0, clear, a};
`endif
endmodule
";

/// A CCU2C adds two bits: a carry is made where a look-up table gives 0, and then it is B; the table
/// is A xor B, or B alone where C, the bit that clears A, is 1.
const ECP5: &str = "\
  // Pairs of bits.
  localparam PAIRS = (WIDTH + 1) / 2;
  wire [WIDTH:0] a_wide = {1'b0, a};
  wire [WIDTH:0] b_wide = {1'b0, b};
  wire [2*PAIRS-1:0] sum;
  wire [PAIRS:0] carry;
  assign carry[0] = 1'b0;
  assign s = sum[WIDTH-1:0];

  genvar pair;
  generate
    for (pair = 0; pair < PAIRS; pair = pair + 1) begin : pairs
      CCU2C #(
          .INIT0(16'hC60C), .INIT1(16'hC60C), .INJECT1_0(\"NO\"), .INJECT1_1(\"NO\")
      ) adder (
          .CIN(carry[pair]), .COUT(carry[pair+1]),
          .A0(a_wide[2*pair]), .B0(b_wide[2*pair]), .C0(clear), .D0(1'b1), .S0(sum[2*pair]),
          .A1(a_wide[2*pair+1]), .B1(b_wide[2*pair+1]), .C1(clear), .D1(1'b1), .S1(sum[2*pair+1])
      );
    end
  endgenerate
";
