//! The program's subcommands.
use std::io::Write;

use clap::{Parser, Subcommand};

use crate::error::ToolError;
use crate::output::Interrupts;
use crate::verdict::Verdict;
use crate::{
    cmd_bench, cmd_compare, cmd_completions, cmd_explore, cmd_generate, cmd_manual, cmd_methods,
    cmd_needs, cmd_new, cmd_prove, cmd_reproduce, cmd_run, cmd_scenes, cmd_schedule, cmd_stress,
    cmd_synth, cmd_wave,
};

const EXAMPLES: &str = "\
Examples:
  specula run teapot
  specula run bunny.ply --size 320x240 --method hybrid -o out/bunny
  specula generate scene.toml
  specula wave out/teapot/trace.vcd";

/// Turns a scene into shading hardware that can be checked.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100, after_help = EXAMPLES)]
pub struct Cli {
    /// The subcommand.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Simulate the core for a scene, compare every pixel, and write Verilog, pictures, waveform
    /// and report
    Run(cmd_run::Arguments),
    /// Write the Verilog of the core for a scene, without simulating it
    Generate(cmd_generate::Arguments),
    /// Show a core clock by clock: operators, the longest path, register bits
    Schedule(cmd_schedule::Arguments),
    /// Synthesise, place and route the core for a scene: cells, and the clock that it reaches
    Synth(cmd_synth::Arguments),
    /// Draw a window of a waveform as text or as a picture
    Wave(cmd_wave::Arguments),
    /// Measure how fast each simulator on this machine runs the core for a scene
    Bench(cmd_bench::Arguments),
    /// Compare methods and formats: error against run time and size
    Compare(cmd_compare::Arguments),
    /// Show what a scene needs, and which hardware its core therefore leaves out
    Needs(cmd_needs::Arguments),
    /// Search options and formats for the smallest core within an error of exact shading
    Explore(cmd_explore::Arguments),
    /// Try every method on the catalogue of extremes
    Stress(cmd_stress::Arguments),
    /// Have the bounds of a core proven by another program, Gappa
    Prove(cmd_prove::Arguments),
    /// Compute the claims of the papers, and say which of them hold
    Reproduce(cmd_reproduce::Arguments),
    /// Write a scene file to begin with
    New(cmd_new::Arguments),
    /// List the built-in scenes, or print one's file
    Scenes(cmd_scenes::Arguments),
    /// List the shading methods
    Methods(cmd_methods::Arguments),
    /// Print what a shell needs to complete this program's command lines
    Completions(cmd_completions::Arguments),
    /// Print a page for `man`
    Manual(cmd_manual::Arguments),
}

impl Command {
    /// Runs the subcommand, which prints its result on `stdout`. What it writes elsewhere is undone
    /// by `interrupts` if it is interrupted half way.
    pub fn execute(
        &self,
        stdout: &mut dyn Write,
        interrupts: &Interrupts,
    ) -> Result<Verdict, ToolError> {
        match self {
            Command::Run(arguments) => cmd_run::execute(arguments, stdout, interrupts),
            Command::Generate(arguments) => cmd_generate::execute(arguments, stdout, interrupts),
            Command::Schedule(arguments) => cmd_schedule::execute(arguments, stdout, interrupts),
            Command::Synth(arguments) => cmd_synth::execute(arguments, stdout),
            Command::Wave(arguments) => cmd_wave::execute(arguments, stdout, interrupts),
            Command::Bench(arguments) => cmd_bench::execute(arguments, stdout),
            Command::Compare(arguments) => cmd_compare::execute(arguments, stdout, interrupts),
            Command::Needs(arguments) => cmd_needs::execute(arguments, stdout),
            Command::Explore(arguments) => cmd_explore::execute(arguments, stdout, interrupts),
            Command::Stress(arguments) => cmd_stress::execute(arguments, stdout, interrupts),
            Command::Prove(arguments) => cmd_prove::execute(arguments, stdout, interrupts),
            Command::Reproduce(arguments) => cmd_reproduce::execute(arguments, stdout, interrupts),
            Command::New(arguments) => cmd_new::execute(arguments, stdout, interrupts),
            Command::Scenes(arguments) => cmd_scenes::execute(arguments, stdout),
            Command::Methods(arguments) => cmd_methods::execute(arguments, stdout),
            Command::Completions(arguments) => cmd_completions::execute(arguments, stdout),
            Command::Manual(arguments) => cmd_manual::execute(arguments, stdout),
        }
    }
}
