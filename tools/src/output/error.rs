//! The reasons why the output folder cannot be used.
use std::io;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use thiserror::Error;

/// The reason why the output folder cannot be used.
#[derive(Debug, Error, Diagnostic)]
pub enum OutputError {
    /// A part of the path is not a folder.
    #[error("output folder `{}`: `{}` is not a folder", folder.display(), at.display())]
    #[diagnostic(
        code(specula::output::file),
        help("name a folder that is not there yet, or one that Specula wrote, with `-o`")
    )]
    NotAFolder {
        /// The folder asked for.
        folder: PathBuf,
        /// What is in the way.
        at: PathBuf,
    },
    /// The folder holds files that Specula did not write.
    #[error("output folder `{}` contains files that Specula did not write, such as `{foreign}`", folder.display())]
    #[diagnostic(
        code(specula::output::foreign),
        help(
            "name an empty folder, one that is not there yet, or one that Specula wrote, with `-o`"
        )
    )]
    Foreign {
        /// The folder asked for.
        folder: PathBuf,
        /// A file in it.
        foreign: String,
    },
    /// A file that Specula did not write has the name of one that would be written.
    #[error("output folder `{}` holds `{name}`, which Specula did not write and would replace", folder.display())]
    #[diagnostic(
        code(specula::output::in_the_way),
        help("move or rename `{name}`, or name another folder with `-o`")
    )]
    InTheWay {
        /// The folder asked for.
        folder: PathBuf,
        /// The name of the file in it.
        name: String,
    },
    /// The folder holds a run's results, and the Verilog in it belongs to them.
    #[error("output folder `{}` holds the results of a run with another core", folder.display())]
    #[diagnostic(
        code(specula::output::core),
        help("name another folder with `-o`, or let `specula run` replace it")
    )]
    OtherCore {
        /// The folder asked for.
        folder: PathBuf,
    },
    /// The folder would have to be replaced while it is a shell's current folder.
    #[error("output folder `{}` is the current folder, or one above it, and would be replaced", folder.display())]
    #[diagnostic(code(specula::output::current), help("name another folder with `-o`"))]
    Current {
        /// The folder asked for.
        folder: PathBuf,
    },
    /// The operating system refuses to write.
    #[error("cannot write `{}`: {reason}", path.display())]
    #[diagnostic(
        code(specula::output::system),
        help(
            "check the folder's name, its permissions and the room on the disk, or name another with `-o`"
        )
    )]
    System {
        /// What was to be written.
        path: PathBuf,
        /// The operating system's error.
        reason: io::Error,
    },
    /// Not everything that belongs in the output folder is in it yet.
    #[error("`{}` could not be moved into the output folder: {reason}", path.display())]
    #[diagnostic(
        code(specula::output::kept),
        help("it is safe there: the next run tries again, or move it by hand")
    )]
    Kept {
        /// Where it is now.
        path: PathBuf,
        /// The reason why it could not be moved.
        reason: io::Error,
    },
}

impl OutputError {
    /// Turns the operating system's error into the error of having failed to write `path`.
    pub fn system(path: &Path) -> impl FnOnce(io::Error) -> OutputError + '_ {
        move |reason| OutputError::System { path: path.to_owned(), reason }
    }
}
