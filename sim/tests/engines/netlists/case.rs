//! A netlist with what goes into it, what is watched, and who runs it.
use std::ops::Range;

use specula_datapath::design::NodeId;
use specula_datapath::{Design, SpanPacket};
use specula_sim::fast::Settings;
use specula_sim::{Columns, Engine, Fast, Flow, InputHold, RustHdl, SimError, Stimulus};

use crate::netlists::interpret::{Row, Untrue, interpret};

/// Who runs a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subject {
    Fast(Settings),
    RustHdl,
}

/// A run of a netlist.
#[derive(Clone, Debug)]
pub struct Case {
    pub design: Design,
    pub packets: Vec<SpanPacket>,
    /// The seed of bubbles before pixels; none where they follow each other.
    pub bubbles: Option<u64>,
    /// The clocks that the run leads to, as `Stimulus::leading_to` takes them; the whole run if
    /// there are none.
    pub window: Option<Range<u64>>,
    pub watched: Vec<NodeId>,
    pub subject: Subject,
}

impl Case {
    /// The stimulus of the run.
    pub fn stimulus(&self) -> Stimulus<'_> {
        let whole = Stimulus::whole(&self.packets, &self.design);
        let whole = match self.bubbles {
            Some(seed) => whole.with_bubbles(seed),
            None => whole,
        };
        match &self.window {
            Some(window) => whole.leading_to(window, &self.design),
            None => whole,
        }
    }

    /// What goes in at each clock.
    fn rows(&self) -> Vec<Row> {
        if self.bubbles.is_some() { self.rows_with_bubbles() } else { self.rows_without_bubbles() }
    }

    /// As the stimulus says.
    fn rows_with_bubbles(&self) -> Vec<Row> {
        let stimulus = self.stimulus();
        let row = |hold: &InputHold, clock| Row {
            valid: hold.valid,
            start: hold.starts && clock == hold.clocks.start,
            inputs: hold.inputs.clone(),
        };
        let rows = |hold: InputHold| hold.clocks.clone().map(move |clock| row(&hold, clock));
        stimulus.holds().flat_map(rows).collect()
    }

    /// From the packets: span after span, then idle clocks with the last inputs held and `start`
    /// high.
    fn rows_without_bubbles(&self) -> Vec<Row> {
        let mut rows: Vec<Row> = vec![];
        for packet in &self.packets {
            let row = |pixel| Row { valid: true, start: pixel == 0, inputs: packet.inputs.clone() };
            rows.extend((0..packet.length).map(row));
        }
        let idle =
            rows.last().map_or_else(|| vec![0; self.design.inputs.len()], |row| row.inputs.clone());
        let clocks = self.stimulus().clocks();
        rows.resize(
            rows.len().max(clocks.end as usize),
            Row { valid: false, start: true, inputs: idle },
        );
        rows[clocks.start as usize..clocks.end as usize].to_vec()
    }

    /// The value of every signal at every clock.
    pub fn expected(&self) -> Result<Vec<Vec<i64>>, Untrue> {
        interpret(&self.design, &self.rows())
    }

    /// What the subject makes of it.
    pub fn run(&self) -> Result<Columns, SimError> {
        match self.subject {
            Subject::Fast(settings) => {
                self.collect(&mut Fast::with_settings(&self.design, settings))
            }
            Subject::RustHdl => self.collect(&mut RustHdl::new(&self.design)?),
        }
    }

    fn collect(&self, engine: &mut dyn Engine) -> Result<Columns, SimError> {
        let mut all = Columns::new(&self.watched);
        let mut next = self.stimulus().clocks().start;
        engine.run(&self.stimulus(), &self.watched, &mut |batch| {
            assert_eq!(batch.first_clock(), next, "batches follow each other");
            next = batch.span().end;
            all.extend(batch);
            Flow::Continue
        })?;
        Ok(all)
    }
}
