//! Errors in what a file holds.
use std::io;

/// An error in the file's contents.
pub fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}
