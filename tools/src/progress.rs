//! Progress bars, which are shown on a terminal only.
use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressStyle};

/// A bar that shows how many of `clocks` clocks are done.
pub fn bar(doing: &'static str, clocks: u64) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style =
        ProgressStyle::with_template("{msg:10} {bar:40} {human_pos}/{human_len} clocks {eta}");
    let bar = ProgressBar::new(clocks).with_message(doing);
    match style {
        Ok(style) => bar.with_style(style),
        // The template is a constant; if it were wrong, the default style would show as much.
        Err(_) => bar,
    }
}

/// A bar that shows how many of `frames` frames are done.
pub fn frames(frames: u32) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(frames.into());
    match ProgressStyle::with_template("shading    {bar:40} {pos}/{len} frames {eta}") {
        Ok(style) => bar.with_style(style),
        // The template is a constant, as in `bar`.
        Err(_) => bar,
    }
}

/// A bar that shows the current step, its number and the number of steps.
pub fn steps() -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(0);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}") {
        Ok(style) => bar.with_style(style),
        // The template is a constant, as in `bar`.
        Err(_) => bar,
    }
}

/// A counter of what has been done, where the total is unknown.
pub fn count(what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new_spinner().with_message(what);
    match ProgressStyle::with_template("{spinner} {pos} {msg} {elapsed}") {
        Ok(style) => bar.with_style(style),
        // The template is a constant, as in `bar`.
        Err(_) => bar,
    }
}
