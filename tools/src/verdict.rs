//! How a command ended.

/// How a command that could be done ended; the program's exit status says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything is as it must be.
    Done,
    /// The core and its models disagree, or a number is not as measured before.
    Disagrees,
}
