//! Pixels as they leave the core: in which clock, and with which code.
use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_sim::{Batch, Lanes, Stimulus};

/// Collects the codes that leave and checks that they leave in the clocks in which they must.
pub(crate) struct Arrivals<'a> {
    stimulus: &'a Stimulus<'a>,
    latency: u64,
    valid_out: NodeId,
    outputs: Vec<NodeId>,
    /// The code of each pixel, in the order in which they entered.
    pub codes: Vec<[u8; 3]>,
    /// Clocks in which a pixel left that had to, or had to and did not.
    pub wrong_clocks: Vec<u64>,
}

impl<'a> Arrivals<'a> {
    pub fn new(design: &Design, stimulus: &'a Stimulus<'a>) -> Arrivals<'a> {
        Arrivals {
            stimulus,
            latency: u64::from(design.latency()),
            valid_out: design.valid_out,
            outputs: design.outputs.clone(),
            codes: Vec::with_capacity(stimulus.pixels() as usize),
            wrong_clocks: vec![],
        }
    }

    pub fn take(&mut self, batch: &Batch) {
        let nothing = Lanes::Constant(0, batch.clocks());
        let lanes = |node: NodeId| batch.of(node).unwrap_or(nothing);
        let valid = lanes(self.valid_out);
        let channels: Vec<Lanes> = self.outputs.iter().map(|&node| lanes(node)).collect();
        for row in 0..batch.clocks() {
            let clock = batch.first_clock() + row as u64;
            let due =
                clock.checked_sub(self.latency).is_some_and(|entry| self.stimulus.enters(entry));
            if due != (valid.get(row) == 1) {
                self.wrong_clocks.push(clock);
            }
            if due {
                // Outputs are proven to lie in 0..=255; a channel that is missing counts as 0.
                let code = |c: usize| channels.get(c).map_or(0, |lanes| lanes.get(row) as u8);
                self.codes.push([code(0), code(1), code(2)]);
            }
        }
    }
}
