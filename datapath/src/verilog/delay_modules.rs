//! The modules that delay lines are instances of.
use std::collections::BTreeSet;

use super::LongDelays;
use super::delays::{DelayLine, Storage};

/// The delay modules of a file: their names, and the texts of those that are instantiated.
#[derive(Clone, Debug)]
pub struct DelayModules {
    prefix: String,
    used: BTreeSet<Storage>,
}

impl DelayModules {
    /// None of them used yet; their names begin with `prefix`.
    pub fn new(prefix: &str) -> DelayModules {
        DelayModules { prefix: prefix.to_owned(), used: BTreeSet::new() }
    }

    /// Whether a delay module has the name that a unit's first module would have.
    pub fn is_named_as(unit: &str) -> bool {
        [Storage::ShiftRegister, Storage::Memory].map(unit_name).contains(&unit)
    }

    /// Notes that there is a line of this kind.
    pub fn note(&mut self, storage: Storage) {
        self.used.insert(storage);
    }

    /// Module and parameters of a line that is `width` bits wide.
    pub fn instantiated(&self, line: &DelayLine, width: u32, long: LongDelays) -> String {
        let (storage, clocks) = (line.storage(long), line.clocks());
        let name = self.name(storage);
        let size = format!(".WIDTH({width}), .CLOCKS({clocks})");
        match storage {
            Storage::ShiftRegister => format!("{name} #({size})"),
            Storage::Memory => {
                let address = (clocks - 2).ilog2() + 1;
                format!("{name} #({size}, .ADDRESS_WIDTH({address}))")
            }
        }
    }

    /// The texts of those that are used.
    pub fn sources(&self) -> impl Iterator<Item = String> {
        self.used.iter().map(|&storage| {
            let text = match storage {
                Storage::ShiftRegister => SHIFT_REGISTER,
                Storage::Memory => MEMORY,
            };
            text.replacen("NAME", &self.name(storage), 1)
        })
    }

    fn name(&self, storage: Storage) -> String {
        format!("{}_{}", self.prefix, unit_name(storage))
    }
}

const fn unit_name(storage: Storage) -> &'static str {
    match storage {
        Storage::ShiftRegister => "delay",
        Storage::Memory => "delay_memory",
    }
}

/// The vector in [`SHIFT_REGISTER`] that holds every stage: stage k, from 1 to CLOCKS, is bits
/// k * WIDTH - 1 to (k - 1) * WIDTH.
pub const LINE: &str = "line";

/// One vector, since a simulator writes that to a trace and a synthesiser finds the chains of bits
/// in it, neither of which is so with an array.
const SHIFT_REGISTER: &str = "\
// delay: q is what d was CLOCKS clocks before, by a shift register; CLOCKS is at least 2.
module NAME #(
    parameter WIDTH = 1,
    parameter CLOCKS = 2
) (
    input wire              clock,
    input wire [WIDTH-1:0]  d,
    output wire [WIDTH-1:0] q
);
  // Stage k, from 1 to CLOCKS: bits k * WIDTH - 1 to (k - 1) * WIDTH.
  reg [CLOCKS*WIDTH-1:0] line;
  assign q = line[CLOCKS*WIDTH-1:(CLOCKS-1)*WIDTH];

  always @(posedge clock) line <= {line[(CLOCKS-1)*WIDTH-1:0], d};
endmodule
";

/// A word is read in the clock in which it is overwritten, CLOCKS - 1 clocks after it was written;
/// the register of `q` makes it CLOCKS. All begins as 0, as registers do.
const MEMORY: &str = "\
// delay_memory: q is what d was CLOCKS clocks before, by a memory used as a circular buffer; CLOCKS
// is at least 3, and addresses are as wide as CLOCKS - 2.
module NAME #(
    parameter WIDTH = 1,
    parameter CLOCKS = 3,
    parameter ADDRESS_WIDTH = 1
) (
    input wire             clock,
    input wire [WIDTH-1:0] d,
    output reg [WIDTH-1:0] q
);
  localparam [31:0] LAST = CLOCKS - 2;
  reg [WIDTH-1:0] memory [0:CLOCKS-2];
  reg [ADDRESS_WIDTH-1:0] address;

  integer word;
  initial begin
    for (word = 0; word <= CLOCKS - 2; word = word + 1) memory[word] = {WIDTH{1'b0}};
    address = {ADDRESS_WIDTH{1'b0}};
    q = {WIDTH{1'b0}};
  end

  // A counter without an adder: a bit changes where all bits below it are 1.
  wire [ADDRESS_WIDTH-1:0] next;
  genvar place;
  generate
    for (place = 0; place < ADDRESS_WIDTH; place = place + 1) begin : counter
      assign next[place] = (address != LAST[ADDRESS_WIDTH-1:0])
          & (address[place] ^ &(address | ({ADDRESS_WIDTH{1'b1}} << place)));
    end
  endgenerate

  // The oldest word is read, then overwritten.
  always @(posedge clock) begin
    q <= memory[address];
    memory[address] <= d;
    address <= next;
  end
endmodule
";
