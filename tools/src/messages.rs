//! How errors are shown: broken at blanks on a terminal, and not at all elsewhere, so that paths
//! can be copied and searched for.
use std::io::{self, IsTerminal};

use miette::MietteHandlerOpts;
use textwrap::{WordSeparator, WordSplitter};

/// Columns of a message on a terminal, at most.
const WIDEST: usize = 120;
/// Columns on a terminal that does not say how many it has.
const USUAL: usize = 80;

/// Has every error shown so. Once, before the first of them.
pub fn install() {
    // A hook that is there already shows errors too.
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
