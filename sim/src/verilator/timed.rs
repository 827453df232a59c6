//! Verilator at its fastest, for measuring: a program that holds its stimulus in memory and times
//! itself.
use std::fs;
use std::io::{self, Read};
use std::path::Path;
use std::time::Instant;

use specula_datapath::Design;

use super::{Effort, PROGRAM, Program, Verilator, glue};
use crate::external::{STIMULUS, Workshop, tool};
use crate::{SimError, Stimulus};

/// The program; what depends on the core is in the header that [`glue`] writes.
const MAIN: &str = include_str!("timed.cpp");
/// The file into which it writes what it measured.
const RESULT: &str = "result.txt";

/// What a timed program keeps of every clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeping {
    /// The sums of the outputs, as all of them do.
    Outputs,
    /// Every signal can be read and written by the program, so that Verilator may not optimise any
    /// away.
    EverySignal,
    /// Every signal goes to a value change dump.
    Vcd,
    /// Every signal goes to a fast signal trace, as GTKWave reads it.
    Fst,
}

impl Keeping {
    const fn options(self) -> &'static [&'static str] {
        match self {
            Keeping::Outputs => &[],
            Keeping::EverySignal => &["--public-flat-rw"],
            Keeping::Vcd => &["--trace", "--trace-max-width", "0"],
            Keeping::Fst => &["--trace-fst", "--trace-max-width", "0"],
        }
    }

    /// The core's Verilog for it: every signal is there to be kept unless outputs alone are.
    fn source(self, workshop: &Workshop) -> &str {
        match self {
            Keeping::Outputs => &workshop.source,
            Keeping::EverySignal | Keeping::Vcd | Keeping::Fst => &workshop.traced_source,
        }
    }
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// Seconds, by the program's own steady clock, without starting it and reading the stimulus.
    pub seconds: f64,
    /// Clocks simulated, that of reset apart.
    pub clocks: u64,
    /// The sum of each output over the clocks in which pixels leave, modulo 2^32.
    pub sums: Vec<u32>,
}

/// A design and a frame compiled for measuring; both are verilated with `-O3` and compiled with
/// `-O3`.
pub struct TimedVerilator {
    workshop: Workshop,
    keeping: Keeping,
    build_seconds: f64,
}

impl TimedVerilator {
    /// Builds the program for `design` and gives it the spans of `frame`.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if Verilator is not installed, [`SimError::ToolFailed`] if it
    /// cannot build such a program, [`SimError::File`] if there is no room.
    pub fn build(
        design: &Design,
        frame: &Stimulus,
        keeping: Keeping,
    ) -> Result<TimedVerilator, SimError> {
        Verilator::present()?;
        let workshop = Workshop::new(design)?;
        workshop.write("timed.cpp", MAIN)?;
        workshop.write("ports.h", &glue::header(&workshop.ports))?;
        workshop.write_stimulus(frame, design)?;
        let begin = Instant::now();
        let program = Program {
            directory: "timed",
            source: keeping.source(&workshop),
            main: "timed.cpp",
            effort: Effort::FastRun,
            options: keeping.options(),
            common: None,
        };
        program.build(&workshop)?;
        Ok(TimedVerilator { workshop, keeping, build_seconds: begin.elapsed().as_secs_f64() })
    }

    /// Seconds that Verilator and the C++ compiler took.
    pub fn build_seconds(&self) -> f64 {
        self.build_seconds
    }

    /// Shades the first `spans` spans of an endless row of frames and writes `dump`, if the program
    /// is one that does.
    ///
    /// # Errors
    /// [`SimError::ToolFailed`] if the program fails, [`SimError::File`] if it does not say what it
    /// measured, or if `dump` is not a file that the program may replace.
    pub fn run(&self, spans: usize, dump: &Path) -> Result<Timing, SimError> {
        if self.keeping == Keeping::Fst {
            replaceable(dump)
                .map_err(SimError::file(format!("replace `{}` by a waveform", dump.display())))?;
        }
        let program = self.workshop.path().join("timed").join(PROGRAM);
        let dump = dump.to_string_lossy().into_owned();
        let arguments = [STIMULUS.to_owned(), RESULT.to_owned(), spans.to_string(), dump];
        tool::run(program.as_os_str(), self.workshop.path(), &arguments)?;
        let mut text = String::new();
        let read = self.workshop.open(RESULT)?.read_to_string(&mut text);
        let timing = read.and_then(|_| {
            timing(&text).ok_or_else(|| io::Error::other(format!("`{text}` is no result")))
        });
        timing.map_err(SimError::file("read what a simulator measured"))
    }
}

/// Refuses what is there and is not a file. Verilator's FST writer removes what has the file's name
/// before it makes the file: given the null device by a privileged user, it would remove the device
/// from the system.
fn replaceable(dump: &Path) -> io::Result<()> {
    match fs::symlink_metadata(dump) {
        Ok(there) if !there.is_file() => Err(io::Error::other("it is there and is not a file")),
        _ => Ok(()),
    }
}

fn timing(text: &str) -> Option<Timing> {
    let mut words = text.split_whitespace();
    let (seconds, clocks) = (words.next()?.parse().ok()?, words.next()?.parse().ok()?);
    let sums = words.map(|word| word.parse().ok()).collect::<Option<_>>()?;
    Some(Timing { seconds, clocks, sums })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_are_replaced() {
        let place = tempfile::tempdir().unwrap();
        let file = place.path().join("waveform");
        assert!(replaceable(&file).is_ok());
        fs::write(&file, "").unwrap();
        assert!(replaceable(&file).is_ok());
        assert!(replaceable(place.path()).is_err());
        #[cfg(unix)]
        assert!(replaceable(Path::new("/dev/null")).is_err());
    }

    #[test]
    fn results_are_read_or_refused() {
        let expected = Timing { seconds: 0.25, clocks: 12, sums: vec![7, 4294967295] };
        assert_eq!(timing("0.250000000 12 7 4294967295"), Some(expected));
        for text in ["", "0.25", "0.25 12 -1", "0.25 x 1"] {
            assert_eq!(timing(text), None, "{text}");
        }
    }
}
