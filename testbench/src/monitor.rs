//! Pixels as they leave the core: in which clock, and with which code.
use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::{Batch, Lanes, Stimulus};

/// Collects the codes that leave and checks that they leave in the clocks in which they must.
pub struct Monitor<'a> {
    stimulus: &'a Stimulus<'a>,
    /// Clocks from a pixel's last time slot to its exit.
    depth: u64,
    valid_out: NodeId,
    outputs: Vec<NodeId>,
    /// The code of each pixel, in the order in which they entered.
    pub codes: Vec<[u8; 3]>,
    /// What leaves beside the codes: raw values, pixel by pixel and port by port.
    pub directions: Vec<i64>,
    /// Clocks in which a pixel left that must not, or must leave and did not.
    pub wrong_clocks: Vec<u64>,
}

impl<'a> Monitor<'a> {
    /// A monitor of the pixels that this stimulus makes a design give.
    pub fn new(design: &Design, stimulus: &'a Stimulus<'a>) -> Monitor<'a> {
        Monitor {
            stimulus,
            depth: u64::from(design.depth()),
            valid_out: design.valid_out,
            outputs: design.outputs.clone(),
            codes: Vec::with_capacity(stimulus.pixels() as usize),
            directions: vec![],
            wrong_clocks: vec![],
        }
    }

    /// Takes the next clocks, which follow those taken before.
    pub fn take(&mut self, batch: &Batch) {
        let nothing = Lanes::Constant(0, batch.clocks());
        let lanes = |node: NodeId| batch.of(node).unwrap_or(nothing);
        let valid = lanes(self.valid_out);
        let channels: Vec<Lanes> = self.outputs.iter().map(|&node| lanes(node)).collect();
        for row in 0..batch.clocks() {
            let clock = batch.first_clock() + row as u64;
            let due =
                clock.checked_sub(self.depth).is_some_and(|last| self.stimulus.completes(last));
            if due != (valid.get(row) == 1) {
                self.wrong_clocks.push(clock);
            }
            if due {
                // Outputs are proven to lie in 0..=255; a channel that is missing counts as 0.
                let code = |c: usize| channels.get(c).map_or(0, |lanes| lanes.get(row) as u8);
                self.codes.push([code(0), code(1), code(2)]);
                self.directions.extend(channels.iter().skip(3).map(|lanes| lanes.get(row)));
            }
        }
    }
}
