//! Progress bars: on a terminal, and nowhere else.
use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressStyle};

/// How many of `clocks` clocks are done.
pub fn bar(doing: &'static str, clocks: u64) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style =
        ProgressStyle::with_template("{msg:10} {bar:40} {human_pos}/{human_len} clocks {eta}");
    let bar = ProgressBar::new(clocks).with_message(doing);
    match style {
        Ok(style) => bar.with_style(style),
        // The template is a constant; if it were wrong, the default style shows as much.
        Err(_) => bar,
    }
}

/// Which step is being done, and how many of how many are.
pub fn steps() -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(0);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}") {
        Ok(style) => bar.with_style(style),
        // As above.
        Err(_) => bar,
    }
}

/// A count of what has been done, where the total is unknown.
pub fn count(what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new_spinner().with_message(what);
    match ProgressStyle::with_template("{spinner} {pos} {msg} {elapsed}") {
        Ok(style) => bar.with_style(style),
        // As above.
        Err(_) => bar,
    }
}
