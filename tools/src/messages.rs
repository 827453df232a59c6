//! The layout of error messages: wrapped at blanks on a terminal, and not at all elsewhere, so that
//! paths can be copied and searched for.
use std::io::{self, IsTerminal};

use miette::MietteHandlerOpts;
use textwrap::{WordSeparator, WordSplitter};

/// Largest number of columns of a message on a terminal.
const WIDEST: usize = 120;
/// Number of columns of a terminal whose size is unknown.
const USUAL: usize = 80;

/// Installs this layout for all errors. It has to be called once, before the first error.
pub fn install() {
    // If a hook is installed already, it also shows errors.
    let _ = miette::set_hook(Box::new(|_| Box::new(options().build())));
}

fn options() -> MietteHandlerOpts {
    let whole_words = MietteHandlerOpts::new()
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation);
    if !io::stderr().is_terminal() {
        return whole_words.wrap_lines(false).width(usize::MAX);
    }
    let columns = terminal_size::terminal_size_of(io::stderr())
        .map_or(USUAL, |(width, _)| usize::from(width.0));
    whole_words.width(columns.min(WIDEST))
}
