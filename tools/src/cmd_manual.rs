//! `specula manual`: pages for `man`.
use std::io::Write;

use clap::{Args, Command, CommandFactory};
use clap_mangen::Man;

use crate::cli::Cli;
use crate::error::ToolError;
use crate::verdict::Verdict;

const EXAMPLE: &str = "\
Example: specula manual run | man -l -";

/// Arguments of `manual`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// A subcommand; the program as a whole if left out
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

/// Prints the page.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let mut program = Cli::command();
    program.build();
    let page = match &arguments.command {
        None => program,
        Some(name) => subcommand(&program, name)?,
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(ToolError::Print)?;
    stdout.write_all(&text).and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

/// The subcommand of that name, called `specula-NAME` as its page is.
fn subcommand(program: &Command, name: &str) -> Result<Command, ToolError> {
    let Some(command) = program.find_subcommand(name) else {
        let known: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
        return Err(ToolError::NoSuchCommand { name: name.to_owned(), known: known.join(", ") });
    };
    let title = format!("specula-{name}");
    Ok(command.clone().name(title.clone()).display_name(title))
}
