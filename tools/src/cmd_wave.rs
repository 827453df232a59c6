//! `specula wave`: a window of a waveform as text or as a picture.
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use crate::error::ToolError;
use crate::output::{Interrupts, write_file};
use crate::picture;
use crate::verdict::Verdict;
use specula_wave::{self as wave, DumpView, Figure, Selection, WaveError, WindowRequest};

const NOTES: &str = "\
Numbers are fixed-point where the format is known from GTKWave's save file next to FILE, which has \
the same name with the extension .gtkw, as `specula run` writes it. Others are hexadecimal. Without --signals \
and --unit, the signals that the save file shows are drawn, or without one the outermost unit's.

Any dialect of VCD is drawn: what cannot be understood is passed over with a warning on standard \
error that names its line, and a truncated file is drawn up to its end (docs/wave.md). FILE may be a \
pipe, and may be compressed with gzip.

Time is counted in clocks if a signal named `clock` or `clk` rises at a constant pace: each clock \
begins with a rising edge. Otherwise it is counted in the file's units of time.

Example: specula wave out/teapot/trace.vcd --unit normalise -o normalise.svg";

/// Arguments of `wave`.
#[derive(Clone, Debug, Args)]
#[command(after_help = NOTES)]
pub struct Arguments {
    /// A waveform: VCD or FST, of any tool; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Draw signals whose full names match, such as 'teapot.normalise.*' (`*` and `?`; can be given
    /// more than once)
    #[arg(long, value_name = "GLOB")]
    signals: Vec<String>,
    /// Draw signals of the unit with this name
    #[arg(long, value_name = "NAME")]
    unit: Option<String>,
    /// First clock, or first time, to draw [default: around the save file's marker, or the
    /// beginning]
    #[arg(long, value_name = "A")]
    from: Option<u64>,
    /// Last clock, or last time, to draw
    #[arg(long, value_name = "B")]
    to: Option<u64>,
    /// Width: characters in a line of text [default: the terminal's, or 120], or pixels of a
    /// picture
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(WIDTH_ASKED))]
    width: Option<u32>,
    /// Picture to write, .svg or .png [default: text on standard output]
    #[arg(short, long, value_name = "PICTURE")]
    output: Option<PathBuf>,
}

/// Clocks in a picture unless the user gives a window.
const USUAL: u64 = 24;
/// Characters in a line if standard output is not a terminal.
const WIDTH: usize = 120;
/// Least and most characters in a line that a terminal's width may ask for.
const WIDTHS: std::ops::RangeInclusive<usize> = 60..=400;

/// Least and most that `--width` may ask for.
const WIDTH_ASKED: std::ops::RangeInclusive<i64> = 20..=8000;

/// The form in which the figure is written.
enum Target<'a> {
    Text { width: usize },
    Svg(&'a Path),
    Png(&'a Path),
}

impl Arguments {
    fn target(&self) -> Result<Target<'_>, WaveError> {
        let Some(path) = &self.output else {
            return Ok(Target::Text {
                width: self.width.map_or_else(width, |width| width as usize),
            });
        };
        match path
            .extension()
            .and_then(|ending| ending.to_str())
            .map(str::to_ascii_lowercase)
            .as_deref()
        {
            Some("svg") => Ok(Target::Svg(path)),
            Some("png") => Ok(Target::Png(path)),
            _ => Err(WaveError::Picture { path: path.clone() }),
        }
    }
}

/// Draws the waveform; for a picture, prints where it is.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let target = arguments.target()?;
    let figure = figure(arguments, &target)?;
    let said = match target {
        Target::Text { width } => wave::text(&figure, width),
        Target::Svg(path) => {
            write_file(path, interrupts, |path| {
                fs::write(path, wave::svg(&figure, arguments.width))
            })?;
            picture_message(path, &figure)
        }
        Target::Png(path) => {
            let drawing = wave::png(&figure, arguments.width)?;
            write_file(path, interrupts, |path| picture::write_line_drawing(path, &drawing))?;
            picture_message(path, &figure)
        }
    };
    write!(stdout, "{said}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

fn figure(arguments: &Arguments, target: &Target) -> Result<Figure, WaveError> {
    let mut view = DumpView::open(&arguments.file)?;
    for warning in view.warnings() {
        // A closed standard error is no reason to stop.
        let _ = writeln!(io::stderr(), "warning: {warning}");
    }
    let choice = view
        .choose(&Selection { patterns: arguments.signals.clone(), unit: arguments.unit.clone() })?;
    let mut figure = |default_columns| {
        view.figure(
            &choice,
            &WindowRequest { from: arguments.from, to: arguments.to, default_columns },
        )
    };
    match *target {
        Target::Svg(_) | Target::Png(_) => figure(USUAL),
        // How many clocks fit depends on their values.
        Target::Text { width } => {
            let widest = figure(wave::most_columns(width))?;
            figure(wave::columns_beside(&widest, width))
        }
    }
}

/// The message about a picture that was written.
fn picture_message(path: &Path, figure: &Figure) -> String {
    format!("{}: {}, {} signals\n", path.display(), figure.title, figure.rows().count())
}

/// The width of a line of text: the terminal's, or a default if standard output is not one.
fn width() -> usize {
    let terminal = terminal_size::terminal_size_of(io::stdout());
    terminal.map_or(WIDTH, |(width, _)| usize::from(width.0)).clamp(*WIDTHS.start(), *WIDTHS.end())
}
