//! Nanoseconds that the fast engine takes for a clock of the teapot's core, in rounds that take the
//! settings in turn.
//!
//! ```text
//! cargo bench -p specula-sim --bench engine -- [ROUNDS [PART [BATCH...]]]
//! ```
//! With PART, only rows whose name has it as a part are taken; with BATCHes, only batches of so
//! many clocks.
use std::time::Instant;

use specula_datapath::design::NodeId;
use specula_datapath::{Design, SpanPacket};
use specula_sim::fast::{InstructionSet, Settings};
use specula_sim::{Batch, Engine, Fast, Flow, SpanSource, Stimulus};
use specula_spec::SceneCore;

/// Frames in a run: long enough for the clock that it is timed by.
const FRAMES: usize = 20;

fn main() {
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    let rounds = arguments.next().map_or(5, |rounds| rounds.parse().expect("ROUNDS is a number"));
    let part = arguments.next().unwrap_or_default();
    let mut batches: Vec<usize> =
        arguments.map(|batch| batch.parse().expect("BATCH is a number")).collect();
    if batches.is_empty() {
        batches.push(Settings::default().batch);
    }

    let scene = specula_scene::load("teapot", Some((640, 480))).expect("the scene is built in");
    let spec = scene.core_spec(None).expect("the scene has a core").general();
    let design = specula_hdl::elaborate(&spec, "teapot").expect("the core can be built");
    let packets: Vec<_> =
        scene.frame.spans.iter().map(|span| spec.packet(&scene.frame, span)).collect();
    let source = Repeated { packets };
    let stimulus = Stimulus::whole(&source, &design);
    let every = design.variables();
    println!("{} signals, {} clocks", every.len(), stimulus.clocks().end);

    let mut rows = vec![];
    for &batch in &batches {
        let settings = Settings { batch, ..Settings::default() };
        for (name, watched) in [("outputs", &design.outputs), ("every signal", &every)] {
            rows.push(Row::new(name, settings, watched));
            rows.push(Row::new(
                name,
                Settings { instruction_set: InstructionSet::BASELINE, ..settings },
                watched,
            ));
            rows.push(Row::new(name, Settings { threads: 2, ..settings }, watched));
        }
    }
    rows.retain(|row| row.name.contains(&part));
    for _ in 0..rounds {
        rows.iter_mut().for_each(|row| row.take(&design, &stimulus));
    }
    rows.iter().for_each(Row::print);
}

/// A frame, over and over.
struct Repeated {
    packets: Vec<SpanPacket>,
}

impl SpanSource for Repeated {
    fn count(&self) -> usize {
        FRAMES * self.packets.len()
    }

    fn length(&self, index: usize) -> u32 {
        self.packets[index % self.packets.len()].length
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        inputs.extend_from_slice(&self.packets[index % self.packets.len()].inputs);
    }
}

/// A way of running, and its times so far.
struct Row<'a> {
    name: String,
    settings: Settings,
    watched: &'a [NodeId],
    /// Nanoseconds for a clock, round by round.
    times: Vec<f64>,
}

impl<'a> Row<'a> {
    fn new(name: &str, settings: Settings, watched: &'a [NodeId]) -> Row<'a> {
        let Settings { batch, instruction_set, threads, .. } = settings;
        let threads = if threads > 1 { format!(" {threads} threads") } else { String::new() };
        Row {
            name: format!("{name}, {}{threads}, batch {batch}", instruction_set.name()),
            settings,
            watched,
            times: vec![],
        }
    }

    fn take(&mut self, design: &Design, stimulus: &Stimulus) {
        let begin = Instant::now();
        let mut engine = Fast::with_settings(design, self.settings);
        let sink = &mut |batch: &Batch| {
            std::hint::black_box(batch);
            Flow::Continue
        };
        engine.run(stimulus, self.watched, sink).expect("the engine works");
        self.times.push(begin.elapsed().as_secs_f64() * 1e9 / stimulus.clocks().end as f64);
    }

    fn print(&self) {
        let mut times = self.times.clone();
        times.sort_by(f64::total_cmp);
        println!("{:6.2} ns, at best {:6.2}: {}", times[times.len() / 2], times[0], self.name);
    }
}
