//! A block's own bench, run by a simulator on the emitted files.
use std::path::Path;
use std::process::Command;

use specula_sim::{ICARUS, ICARUS_RUNTIME, SimError, VERILATOR, temporary_directory};

use super::{File, StreamRecord};

/// A simulator that runs benches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockSimulator {
    /// Icarus Verilog.
    Icarus,
    /// Verilator 5.
    Verilator,
}

/// What a bench has seen.
pub struct BlockRun {
    /// The pixels that came out.
    pub record: StreamRecord,
    /// What it complains of, if it does.
    pub failure: Option<String>,
}

/// What the bench writes pixels to.
const RECORD: &str = "sent.txt";

impl BlockSimulator {
    /// Runs the bench of the block `name` whose files, the core's included, these are, with pauses by
    /// `seed` where it is not 0.
    ///
    /// # Errors
    /// [`SimError`] if the simulator is absent, or cannot make a program of the files.
    pub fn run(self, name: &str, files: &[File], seed: u32) -> Result<BlockRun, SimError> {
        let directory = temporary_directory()?;
        for File { name, text } in files {
            std::fs::write(directory.path().join(name), text)
                .map_err(SimError::file(format!("write {name} for a simulator")))?;
        }
        let mut program = self.build(name, directory.path())?;
        program.args([format!("+seed={seed}"), format!("+record={RECORD}")]);
        let output = program
            .current_dir(directory.path())
            .output()
            .map_err(SimError::file(format!("run the bench {name}_tb")))?;
        let said = String::from_utf8_lossy(&output.stdout);
        let text = std::fs::read_to_string(directory.path().join(RECORD))
            .map_err(SimError::file(format!("read what the bench {name}_tb has recorded")))?;
        let passed = said.lines().any(|line| line.starts_with("PASS"));
        let failed = said.lines().find(|line| line.starts_with("FAIL"));
        let failure = failed.map_or_else(|| "the bench came to no end".to_owned(), str::to_owned);
        // A last line that the program had no time to write whole is none.
        let whole = text.rfind('\n').map_or("", |end| &text[..end]);
        let record = StreamRecord::read(whole).unwrap_or_default();
        Ok(BlockRun { record, failure: (!passed).then_some(failure) })
    }

    /// Builds the bench in `directory`, and gives what runs it.
    fn build(self, name: &str, directory: &Path) -> Result<Command, SimError> {
        let bench = format!("{name}_tb");
        let parts = ["_tb", "", "_axis", "_regs", "_ip"];
        let sources = parts.map(|part| format!("{name}{part}.v"));
        let command = |words: &[&str]| {
            let words = words.iter().map(|&word| word.to_owned());
            words.chain(sources.clone()).collect::<Vec<_>>()
        };
        match self {
            BlockSimulator::Icarus => {
                ICARUS_RUNTIME.present()?;
                let words = command(&["-g2001", "-s", &bench, "-o", "bench.vvp"]);
                ICARUS.run(directory, &words)?;
                let mut program = Command::new(ICARUS_RUNTIME.command);
                program.args(["-N", "bench.vvp"]);
                Ok(program)
            }
            BlockSimulator::Verilator => {
                let words = ["--binary", "--timing", "--top-module", &bench, "-o", "bench"];
                VERILATOR.run(directory, &command(&words))?;
                Ok(Command::new(directory.join("obj_dir").join("bench")))
            }
        }
    }
}
