//! Reading files of which only the path is known: only regular ones are read, up to an agreed
//! length.
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use thiserror::Error;

/// The reason why a file was not read.
#[derive(Debug, Error)]
pub enum NotRead {
    /// The path is a folder, a device, a pipe or a socket: reading it might never end.
    #[error("it is not a regular file")]
    NotRegular,
    /// The file is longer than agreed.
    #[error("it has more than {limit} bytes")]
    TooLong {
        /// Largest number of bytes that are read.
        limit: u64,
        /// Number of bytes of the file, as far as it is known.
        bytes: u64,
    },
    /// The operating system's error.
    #[error(transparent)]
    System(#[from] io::Error),
}

impl NotRead {
    /// Whether there is no such file.
    pub fn is_missing(&self) -> bool {
        matches!(self, NotRead::System(error) if error.kind() == io::ErrorKind::NotFound)
    }
}

impl From<NotRead> for io::Error {
    fn from(reason: NotRead) -> io::Error {
        match reason {
            NotRead::System(error) => error,
            other => io::Error::other(other),
        }
    }
}

/// Reads a whole regular file of `limit` bytes at most; symbolic links are followed.
///
/// # Errors
/// [`NotRead`] for anything other than a regular file, for a longer one, and for errors of the
/// operating system. The function never blocks: a pipe is not opened.
pub fn read_regular(path: &Path, limit: u64) -> Result<Vec<u8>, NotRead> {
    // Opening a pipe would block until a writer opens it.
    check(&fs::metadata(path)?, limit)?;
    let file = File::open(path)?;
    let about = file.metadata()?;
    check(&about, limit)?;
    let mut bytes = Vec::with_capacity(usize::try_from(about.len()).unwrap_or(0));
    // A file may grow while it is read, and some of the system's files report a length of 0.
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes)?;
    let read = bytes.len() as u64;
    if read > limit { Err(NotRead::TooLong { limit, bytes: read }) } else { Ok(bytes) }
}

fn check(about: &fs::Metadata, limit: u64) -> Result<(), NotRead> {
    if !about.is_file() {
        Err(NotRead::NotRegular)
    } else if about.len() > limit {
        Err(NotRead::TooLong { limit, bytes: about.len() })
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_up_to_the_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        fs::write(&path, "12345").unwrap();
        assert_eq!(read_regular(&path, 5).unwrap(), b"12345");
        assert!(matches!(read_regular(&path, 4), Err(NotRead::TooLong { limit: 4, bytes: 5 })));
        assert!(matches!(read_regular(folder.path(), 4), Err(NotRead::NotRegular)));
        assert!(read_regular(&folder.path().join("none"), 4).unwrap_err().is_missing());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_and_pipes_are_refused_and_endless_files_end() {
        for device in ["/dev/zero", "/dev/null"] {
            assert!(
                matches!(read_regular(Path::new(device), 4), Err(NotRead::NotRegular)),
                "{device}"
            );
        }
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
        assert!(made.success() && matches!(read_regular(&pipe, 4), Err(NotRead::NotRegular)));
        // The system reports a length of 0 for this file.
        assert!(matches!(
            read_regular(Path::new("/proc/self/status"), 4),
            Err(NotRead::TooLong { limit: 4, bytes: 5 })
        ));
    }
}
