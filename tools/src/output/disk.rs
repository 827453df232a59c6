//! What putting results in place does to the disk: one atomic step after the other, so that a test
//! can look at what a kill before each of them would leave.
use std::fs;
use std::io;
use std::path::Path;

/// Steps, each of which is done or not done, whenever the program ends.
pub trait Disk {
    /// Moves a file or folder; a file replaces another.
    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()>;
    /// Lets two folders change places. [`io::ErrorKind::Unsupported`] where the system or the file
    /// system cannot do that in one step.
    fn exchange(&mut self, one: &Path, other: &Path) -> io::Result<()>;
    /// Gives a file a second name.
    fn link(&mut self, file: &Path, name: &Path) -> io::Result<()>;
    /// Removes a file.
    fn remove_file(&mut self, file: &Path) -> io::Result<()>;
    /// Makes a folder.
    fn make_folder(&mut self, folder: &Path) -> io::Result<()>;
}

/// The system's.
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
        // The file system, the kernel, or a place that something is mounted on.
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
