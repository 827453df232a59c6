//! How fast waveforms of every signal are written: the teapot's core at 640x480, in rounds that
//! take the ways of writing in turn.
//!
//! ```text
//! cargo bench -p specula-sim --bench waves -- [ROUNDS [DIRECTORY [PART]]]
//! ```
//! Files go to DIRECTORY, or the one for temporary files. Verilator's own traces are timed in the
//! same rounds. With PART, only ways whose name has it as a part are taken.
use std::cell::LazyCell;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::{Batch, Engine, Fast, Flow, Keeping, Stimulus, TimedVerilator, fst, vcd};
use specula_spec::SceneCore;

fn main() {
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    let rounds = arguments.next().map_or(5, |rounds| rounds.parse().expect("ROUNDS is a number"));
    let directory = arguments.next().map_or_else(std::env::temp_dir, PathBuf::from);
    let part = arguments.next().unwrap_or_default();

    let scene = specula_scene::load("teapot", Some((640, 480))).expect("the scene is built in");
    let spec = scene.core_spec(None).expect("the scene has a core").general();
    let design = specula_hdl::elaborate(&spec, "teapot").expect("the core can be built");
    let packets: Vec<_> =
        scene.frame.spans.iter().map(|span| spec.packet(&scene.frame, span)).collect();
    let stimulus = Stimulus::whole(&packets, &design);
    let signals = design.variables();
    let bench = Bench { design: &design, stimulus: &stimulus, signals, directory: &directory };
    println!("{} signals, {} clocks", bench.signals.len(), stimulus.clocks().end);

    let build = |keeping| {
        TimedVerilator::build(&design, &stimulus, keeping).expect("Verilator is installed")
    };
    // Built when they are first wanted.
    let verilator_vcd = LazyCell::new(|| build(Keeping::Vcd));
    let verilator_fst = LazyCell::new(|| build(Keeping::Fst));
    let external = |program: &TimedVerilator, dump: &Path| {
        program.run(packets.len(), dump).expect("the program works").seconds
    };
    let file = |name: &str| directory.join(name);
    let mut rows = vec![
        Row::new("every signal, nothing written", || bench.engine(|_| Ok(()))),
        Row::new("VCD to a null sink", || bench.vcd(io::sink())),
        Row::new("VCD to /dev/null, by Verilator", || {
            external(&verilator_vcd, Path::new("/dev/null"))
        }),
        Row::new("VCD to a file", || bench.vcd(bench.file("waves.vcd"))),
        Row::new("VCD to a file, by Verilator", || {
            external(&verilator_vcd, &file("verilator.vcd"))
        }),
        Row::new("FST to a file", || bench.fst(bench.file("waves.fst"))),
        Row::new("FST to a file, by Verilator", || {
            external(&verilator_fst, &file("verilator.fst"))
        }),
    ];
    rows.retain(|row| row.name.contains(&part));
    for _ in 0..rounds {
        rows.iter_mut().for_each(Row::take);
    }
    rows.iter().for_each(|row| row.print(stimulus.clocks().end));
}

struct Bench<'a> {
    design: &'a Design,
    stimulus: &'a Stimulus<'a>,
    signals: Vec<NodeId>,
    directory: &'a Path,
}

impl Bench<'_> {
    fn engine(&self, write: impl FnMut(&Batch) -> io::Result<()>) -> f64 {
        let begin = Instant::now();
        self.run(write);
        begin.elapsed().as_secs_f64()
    }

    fn run(&self, mut write: impl FnMut(&Batch) -> io::Result<()>) {
        let mut sink = |batch: &Batch| {
            write(std::hint::black_box(batch)).expect("it can be written");
            Flow::Continue
        };
        Fast::new(self.design)
            .run(self.stimulus, &self.signals, &mut sink)
            .expect("the engine works");
    }

    fn vcd(&self, out: impl Write) -> f64 {
        let begin = Instant::now();
        let mut waves = vcd::Waves::begin(out, self.design, &self.signals, "a bench")
            .expect("it can be written");
        self.run(|batch| waves.append(batch));
        waves.end().expect("it can be written");
        begin.elapsed().as_secs_f64()
    }

    fn fst(&self, out: File) -> f64 {
        let begin = Instant::now();
        let mut waves = fst::Waves::begin(out, self.design, &self.signals, "a bench")
            .expect("it can be written");
        self.run(|batch| waves.append(batch));
        waves.end().expect("it can be written");
        begin.elapsed().as_secs_f64()
    }

    fn file(&self, name: &str) -> File {
        File::create(self.directory.join(name)).expect("the directory can be written")
    }
}

/// A way of writing, and its times so far.
struct Row<'a> {
    name: &'a str,
    /// Gives the seconds that it takes.
    task: Box<dyn Fn() -> f64 + 'a>,
    seconds: Vec<f64>,
}

impl<'a> Row<'a> {
    fn new(name: &'a str, task: impl Fn() -> f64 + 'a) -> Row<'a> {
        Row { name, task: Box::new(task), seconds: vec![] }
    }

    fn take(&mut self) {
        self.seconds.push((self.task)());
    }

    fn print(&self, clocks: u64) {
        let mut seconds = self.seconds.clone();
        seconds.sort_by(f64::total_cmp);
        let [least, median] = [0, seconds.len() / 2].map(|i| clocks as f64 / seconds[i] / 1e6);
        println!("{median:7.3} Mclock/s, at best {least:7.3}: {}", self.name);
    }
}
