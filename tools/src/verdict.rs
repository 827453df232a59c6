//! The verdict with which a command ends.

/// The verdict of a command that could be carried out; it becomes the program's exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything is as expected.
    Done,
    /// The core and its models disagree, or a number differs from the one measured before.
    Disagrees,
}
