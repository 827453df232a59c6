//! What programs round different cores have in common, compiled: Verilator's runtime, and the
//! headers that all of them include.
use std::fs;
use std::path::{Path, PathBuf};

use specula_datapath::Design;
use specula_datapath::builder::Builder;

use super::{Effort, HEADERS, HEADERS_FILE, Kind, Verilator};
use crate::SimError;
use crate::external::tool;

/// A folder with object files and precompiled headers.
pub struct Common {
    folder: PathBuf,
    objects: Vec<String>,
}

impl Common {
    /// What is in a folder that [`make`] filled.
    ///
    /// # Errors
    /// [`SimError::File`] if it cannot be read.
    pub fn within(folder: PathBuf) -> Result<Common, SimError> {
        let objects = names(&folder)?.into_iter().filter(|name| name.ends_with(".o")).collect();
        Ok(Common { folder, objects })
    }

    /// Verilator's arguments for a program that takes it from here.
    pub fn arguments(&self) -> Vec<String> {
        // Quoted for the shell that `make` gives them to. An empty list leaves nothing of the
        // runtime to be compiled.
        let quoted = |name: &str| format!("'{}'", self.folder.join(name).display());
        let objects: Vec<String> = self.objects.iter().map(|name| quoted(name)).collect();
        let headers = format!("-include {}", quoted(HEADERS_FILE));
        let none = ["VM_GLOBAL_FAST=", "VM_GLOBAL_SLOW="]
            .into_iter()
            .flat_map(|list| ["-MAKEFLAGS".to_owned(), list.to_owned()]);
        none.chain(["-CFLAGS".to_owned(), headers, "-LDFLAGS".to_owned(), objects.join(" ")])
            .collect()
    }
}

/// Compiles what programs of this kind have in common into `folder`: that of a program whose core
/// does nothing.
///
/// # Errors
/// [`SimError`] as for any program.
pub fn make(folder: &Path, kind: Kind, effort: Effort) -> Result<(), SimError> {
    let design = nothing();
    let mut verilator = Verilator::new(&design, effort)?;
    verilator.build(kind)?;
    verilator.workshop.write("headers.cpp", &format!("#include \"{HEADERS_FILE}\"\n"))?;
    let made = verilator.workshop.path().join(kind.directory());
    // The makefile's own rule and options, but for the language, so that the headers fit what is
    // compiled with them.
    let fixed = ["-f", "Vcore.mk", "CXXFLAGS=-x c++-header", "headers.o"].map(str::to_owned);
    tool::run(
        "make".as_ref(),
        &made,
        &fixed.into_iter().chain(effort.make_variables()).collect::<Vec<_>>(),
    )?;
    let copied = |name: &str, to: &str| {
        let doing = format!("copy {name} for a simulator");
        fs::copy(made.join(name), folder.join(to)).map_err(SimError::file(doing))
    };
    for name in
        names(&made)?.iter().filter(|name| name.starts_with("verilated") && name.ends_with(".o"))
    {
        copied(name, name)?;
    }
    // Where compilers look for the compiled form of a header.
    copied("headers.o", &format!("{HEADERS_FILE}.gch"))?;
    fs::write(folder.join(HEADERS_FILE), HEADERS)
        .map_err(SimError::file("write headers for a simulator"))
}

/// A core from which what enters leaves.
fn nothing() -> Design {
    let b = Builder::new("nothing", "what enters leaves");
    let control = b.control();
    b.finish(&control.valid, &[("first", control.start)]).expect("it has bits alone")
}

/// Names of files in a folder.
fn names(folder: &Path) -> Result<Vec<String>, SimError> {
    let unreadable = || SimError::file(format!("read the folder {}", folder.display()));
    let mut names = vec![];
    for entry in fs::read_dir(folder).map_err(unreadable())? {
        names.push(entry.map_err(unreadable())?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}
