//! The file of a waveform, written batch by batch.
use std::fs::File;
use std::io;

use clap::ValueEnum;
use specula_datapath::Design;
use specula_sim::{Batch, fst, vcd};

/// The format of a waveform's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TraceFormat {
    /// Value change dump: text that every viewer reads
    Vcd,
    /// GTKWave's compressed format: about a seventh of the size, slower to write
    Fst,
}

impl TraceFormat {
    /// The file's name.
    pub const fn file_name(self) -> &'static str {
        match self {
            TraceFormat::Vcd => "trace.vcd",
            TraceFormat::Fst => "trace.fst",
        }
    }
}

/// A waveform's file.
pub struct TraceFile<'a> {
    design: &'a Design,
    about: &'a str,
    format: TraceFormat,
    /// The file until there is a batch: the header needs the batch's signals.
    file: Option<File>,
    waves: Option<Waves>,
}

impl<'a> TraceFile<'a> {
    /// A file for a waveform of `design`; `about` is the description in its header.
    pub fn new(
        file: File,
        format: TraceFormat,
        design: &'a Design,
        about: &'a str,
    ) -> TraceFile<'a> {
        TraceFile { design, about, format, file: Some(file), waves: None }
    }

    /// Appends a batch; all must have the same signals.
    pub fn append(&mut self, batch: &Batch) -> io::Result<()> {
        if let Some(file) = self.file.take() {
            self.waves = Some(self.begin(file, batch)?);
        }
        match &mut self.waves {
            None => Ok(()),
            Some(Waves::Vcd(waves)) => waves.append(batch),
            Some(Waves::Fst(waves)) => waves.append(batch),
        }
    }

    fn begin(&self, file: File, batch: &Batch) -> io::Result<Waves> {
        Ok(match self.format {
            TraceFormat::Vcd => Waves::Vcd(Box::new(vcd::Waves::begin(
                file,
                self.design,
                batch.nodes(),
                self.about,
            )?)),
            TraceFormat::Fst => Waves::Fst(Box::new(fst::Waves::begin(
                file,
                self.design,
                batch.nodes(),
                self.about,
            )?)),
        })
    }

    /// Finishes the file.
    pub fn end(self) -> io::Result<()> {
        match self.waves {
            None => Ok(()),
            Some(Waves::Vcd(waves)) => waves.end(),
            Some(Waves::Fst(waves)) => waves.end(),
        }
    }
}

/// A waveform writer that has written its header.
enum Waves {
    Vcd(Box<vcd::Waves<File>>),
    Fst(Box<fst::Waves<File>>),
}
