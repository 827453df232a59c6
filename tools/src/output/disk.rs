//! The operations on the disk that put results in place: each is atomic, so that a test can look at
//! what a kill before each of them would leave.
use std::fs;
use std::io;
use std::path::Path;

/// Atomic operations: whenever the program ends, each is done or not done.
pub trait Disk {
    /// Moves a file or folder; a file replaces another.
    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()>;
    /// Exchanges two folders. The error is [`io::ErrorKind::Unsupported`] where the operating
    /// system or the file system cannot do that in one step.
    fn exchange(&mut self, one: &Path, other: &Path) -> io::Result<()>;
    /// Gives a file a second name.
    fn link(&mut self, file: &Path, name: &Path) -> io::Result<()>;
    /// Removes a file.
    fn remove_file(&mut self, file: &Path) -> io::Result<()>;
    /// Makes a folder.
    fn make_folder(&mut self, folder: &Path) -> io::Result<()>;
}

/// The operating system's disk.
#[derive(Clone, Copy, Debug)]
pub struct System;

impl Disk for System {
    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)
    }

    fn exchange(&mut self, one: &Path, other: &Path) -> io::Result<()> {
        exchange(one, other)
    }

    fn link(&mut self, file: &Path, name: &Path) -> io::Result<()> {
        fs::hard_link(file, name)
    }

    fn remove_file(&mut self, file: &Path) -> io::Result<()> {
        fs::remove_file(file)
    }

    fn make_folder(&mut self, folder: &Path) -> io::Result<()> {
        fs::create_dir(folder)
    }
}

#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    let cannot = |errno: Errno| match errno {
        // The file system or the kernel cannot do it, or the path is a mount point.
        Errno::INVAL | Errno::NOSYS | Errno::NOTSUP | Errno::BUSY | Errno::XDEV => {
            io::ErrorKind::Unsupported.into()
        }
        errno => io::Error::from(errno),
    };
    renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE).map_err(cannot)
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}
