//! Rounds, in each of which every runner runs once.
use super::progress::Step;
use super::roster::Roster;
use super::runner::{Runner, Timed};
use super::scratch::Scratch;
use super::workload::Workload;
use super::{Config, EngineResult, Machine, MeasureError, Measurement, Mode};
use specula_testbench::Bench;
use specula_testbench::statistics::median;

/// The time that a measurement may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// Number of rounds, at least 1.
    pub rounds: usize,
    /// Intended duration of a run in seconds.
    pub seconds: f64,
}

impl Default for Budget {
    fn default() -> Budget {
        Budget { rounds: 5, seconds: 0.25 }
    }
}

/// Number of spans of the first trial run.
const FIRST_SPANS: usize = 16;
/// Largest growth of the number of spans between trial runs: the duration of a short run predicts
/// that of a long one badly.
const GROWTH: f64 = 8.0;
/// A run is long enough if it takes this share of its intended duration.
const ENOUGH: f64 = 0.8;
/// Largest number of spans of a run, whatever the time: a stimulus takes some bytes for each.
const MAX_SPANS: usize = 1 << 25;

/// Measures every engine that is present, in every mode that it has.
///
/// # Errors
/// [`MeasureError`] if an engine fails or its pixels are wrong.
pub fn measure(
    bench: &Bench,
    budget: Budget,
    progress: &mut dyn FnMut(&Step),
) -> Result<Measurement, MeasureError> {
    let workload = Workload::new(bench)?;
    let scratch = Scratch::new()?;
    let Roster { mut runners, skipped, .. } = Roster::gather(bench, &workload, &scratch, progress)?;
    let mut records = vec![];
    for runner in &mut runners {
        progress(&Step::Trying { config: runner.config() });
        records.push(Record {
            spans: enough_spans(runner.as_mut(), &workload, budget.seconds)?,
            ..Record::default()
        });
    }
    equalise_spans(&runners, &mut records);
    let rounds = budget.rounds.max(1);
    let all = rounds * runners.len();
    for round in 0..rounds {
        for (number, (runner, record)) in runners.iter_mut().zip(&mut records).enumerate() {
            progress(&Step::Measuring {
                config: runner.config(),
                done: round * all / rounds + number,
                all,
            });
            record.add(runner.as_mut(), &workload)?;
        }
    }
    let rows =
        runners.iter().zip(&records).map(|(runner, record)| record.row(runner.config())).collect();
    let clocks_of_a_frame = bench.clocks();
    Ok(Measurement { machine: Machine::this(), clocks_of_a_frame, rows, skipped })
}

/// The measurements of a runner so far.
#[derive(Default)]
struct Record {
    spans: usize,
    clocks: u64,
    rates: Vec<f64>,
    start_ups: Vec<f64>,
}

impl Record {
    fn add(&mut self, runner: &mut dyn Runner, workload: &Workload) -> Result<(), MeasureError> {
        self.start_ups.push(runner.start_up()?);
        let timed = checked(runner, workload, self.spans)?;
        self.clocks = timed.clocks;
        self.rates.push(timed.clocks as f64 / timed.seconds);
        Ok(())
    }

    fn row(&self, config: Config) -> EngineResult {
        EngineResult {
            config,
            clocks: self.clocks,
            rates: self.rates.clone(),
            build_seconds: median(&self.start_ups),
        }
    }
}

/// Runs a runner and checks the checksum.
fn checked(
    runner: &mut dyn Runner,
    workload: &Workload,
    spans: usize,
) -> Result<Timed, MeasureError> {
    let timed = runner.run(spans)?;
    let expected = workload.checksum(spans);
    if timed.checksum == expected {
        return Ok(timed);
    }
    let (given, expected) = (timed.checksum.0.to_vec(), expected.0.to_vec());
    Err(MeasureError::WrongSums { config: runner.config().describe(), spans, given, expected })
}

/// Gives all runners that write waveforms the same spans, as many as the fastest of them needs: the
/// cost of a waveform depends on how many signals change, and that on the part of the frame.
fn equalise_spans(runners: &[Box<dyn Runner + '_>], records: &mut [Record]) {
    for mode in [Mode::Vcd, Mode::VcdNull, Mode::Fst] {
        let of_mode = |number: &usize| runners[*number].config().mode == mode;
        let numbers: Vec<usize> = (0..records.len()).filter(of_mode).collect();
        let most = numbers.iter().map(|&number| records[number].spans).max().unwrap_or(0);
        numbers.iter().for_each(|&number| records[number].spans = most);
    }
}

/// The number of spans that take about `seconds`; the trial runs also warm up.
fn enough_spans(
    runner: &mut dyn Runner,
    workload: &Workload,
    seconds: f64,
) -> Result<usize, MeasureError> {
    runner.start_up()?;
    let mut spans = FIRST_SPANS;
    loop {
        let taken = checked(runner, workload, spans)?.seconds;
        if taken >= ENOUGH * seconds || spans >= MAX_SPANS {
            return Ok(spans);
        }
        spans = more(spans, seconds / taken);
    }
}

/// About `factor` times as many spans, within limits.
fn more(spans: usize, factor: f64) -> usize {
    // A time of 0 gives an infinite factor or a NaN; both are brought into bounds here.
    let factor = factor.clamp(1.0, GROWTH);
    ((spans as f64 * factor).ceil() as usize).clamp(spans + 1, MAX_SPANS.max(spans + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::benchmark::checksum::Checksum;
    use specula_spec::SceneCore;
    use specula_testbench::EngineKind;

    /// A runner that takes a millisecond for each span and gives the model's checksum for one span
    /// more or less.
    struct Fake<'a> {
        workload: &'a Workload,
        more: usize,
        mode: Mode,
    }

    impl Runner for Fake<'_> {
        fn config(&self) -> Config {
            Config::only(EngineKind::RustHdl, self.mode)
        }

        fn start_up(&mut self) -> Result<f64, MeasureError> {
            Ok(0.5)
        }

        fn run(&mut self, spans: usize) -> Result<Timed, MeasureError> {
            Ok(Timed {
                seconds: spans as f64 / 1000.0,
                clocks: 7 * spans as u64,
                checksum: self.workload.checksum(spans + self.more),
            })
        }
    }

    fn with_workload(test: impl Fn(&Workload)) {
        let scene = specula_scene::load("icosahedron", Some((24, 18))).unwrap();
        let spec = scene.core_spec(None).unwrap().general();
        test(&Workload::new(&Bench::new(&scene.frame, &spec, "core").unwrap()).unwrap());
    }

    #[test]
    fn a_run_is_long_enough_and_counts_its_clocks() {
        with_workload(|workload| {
            let mut fake = Fake { workload, more: 0, mode: Mode::Outputs };
            let spans = enough_spans(&mut fake, workload, 1.0).unwrap();
            assert!((800..=1100).contains(&spans), "{spans}");
            let mut record = Record { spans, ..Record::default() };
            record.add(&mut fake, workload).unwrap();
            let row = record.row(fake.config());
            assert_eq!((row.clocks, row.build_seconds), (7 * spans as u64, 0.5));
            assert!((row.rate() - 7000.0).abs() < 1e-6, "{}", row.rate());
        });
    }

    #[test]
    fn waveforms_are_compared_over_the_same_spans() {
        with_workload(|workload| {
            let fake = |mode| Box::new(Fake { workload, more: 0, mode }) as Box<dyn Runner>;
            let runners = [Mode::Vcd, Mode::Outputs, Mode::Vcd, Mode::Fst].map(fake);
            let mut records = [5, 6, 7, 3].map(|spans| Record { spans, ..Record::default() });
            equalise_spans(&runners, &mut records);
            assert_eq!(records.map(|record| record.spans), [7, 6, 7, 3]);
        });
    }

    #[test]
    fn wrong_pixels_are_an_error() {
        with_workload(|workload| {
            assert_ne!(workload.checksum(1), Checksum::default());
            let error = checked(&mut Fake { workload, more: 1, mode: Mode::Outputs }, workload, 20)
                .unwrap_err();
            assert!(matches!(error, MeasureError::WrongSums { spans: 20, .. }), "{error}");
        });
    }

    #[test]
    fn tries_grow_and_end() {
        assert_eq!(more(16, 2.5), 40);
        assert_eq!(more(16, 1e9), 128);
        assert_eq!(more(16, f64::INFINITY), 128);
        assert_eq!(more(16, 1.0), 17);
        assert_eq!(more(MAX_SPANS - 1, 8.0), MAX_SPANS);
    }
}
