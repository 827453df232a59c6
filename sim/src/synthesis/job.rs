//! One run of Yosys, for some of the modules of a library.
use std::fmt::Write;
use std::path::Path;

use specula_datapath::verilog::Library;

use super::cells::Synthesised;
use super::counts;
use crate::SimError;
use crate::external::{Tool, temporary_directory};

const YOSYS: Tool = Tool {
    name: "Yosys",
    command: "yosys",
    version_argument: "--version",
    install: "install Yosys, from its own site or by the package `yosys`",
    otherwise: "leave out `--synthesis`",
};

/// Words of registers as boxes, what makes them of Yosys's, and what makes flip-flops of them.
const REGISTERS: [(&str, &str); 3] = [
    ("registers.v", include_str!("registers.v")),
    ("to_registers.v", include_str!("to_registers.v")),
    ("to_flip_flops.v", include_str!("to_flip_flops.v")),
];

/// A module that instantiates all others, since Yosys wants one on top.
const TOP: &str = "all";

/// Letters of Verilog below which a module is put together with others, since a run takes half a
/// second before it begins.
const FEWEST_LETTERS: usize = 30_000;

/// Modules in jobs: the places of those that one run is to take, the longest run first. Time goes
/// with the length of the text.
pub fn shared_out(library: &Library, processors: usize) -> Vec<Vec<usize>> {
    let length = |place: usize| library.modules()[place].source().len();
    let mut places: Vec<(usize, usize)> =
        (0..library.modules().len()).map(|place| (length(place), place)).collect();
    places.sort_unstable_by(|a, b| b.cmp(a));
    let whole: usize = places.iter().map(|(length, _)| length).sum();
    let enough = FEWEST_LETTERS.min(whole / processors);
    let mut jobs: Vec<Vec<usize>> = vec![];
    let mut letters = usize::MAX;
    for (length, place) in places {
        if letters >= enough {
            jobs.push(vec![]);
            letters = 0;
        }
        letters += length;
        jobs.last_mut().into_iter().for_each(|job| job.push(place));
    }
    jobs
}

/// Cells of the modules in these places themselves, without what they instantiate.
pub fn run(library: &Library, places: &[usize]) -> Result<Vec<Synthesised>, SimError> {
    let directory = temporary_directory()?;
    let write = |name: &str, text: &str| {
        std::fs::write(directory.path().join(name), text)
            .map_err(SimError::file(format!("write {name} for Yosys")))
    };
    REGISTERS.iter().try_for_each(|(name, text)| write(name, text))?;
    write("modules.v", &source(library, places))?;
    let names = library.names(places);
    YOSYS.run(directory.path(), &["-q".to_owned(), "-p".to_owned(), script(&names)])?;
    names.iter().map(|name| cells_of(directory.path(), name)).collect()
}

/// What Yosys counted in a module.
fn cells_of(directory: &Path, module: &str) -> Result<Synthesised, SimError> {
    let name = counts_file(module);
    let text = std::fs::read_to_string(directory.join(&name))
        .map_err(SimError::file(format!("read {name} from Yosys")))?;
    let [luts, carries, multipliers, flip_flops] =
        ["LUT4", "CCU2C", "MULT18X18D", "TRELLIS_FF"].map(|cell| counts::cells(&text, cell));
    Ok(Synthesised { luts: luts + 2 * carries, multipliers, flip_flops })
}

fn counts_file(module: &str) -> String {
    format!("{module}.txt")
}

/// The modules in these places, those that they instantiate as boxes, and one that instantiates
/// them all.
fn source(library: &Library, places: &[usize]) -> String {
    let modules = library.modules();
    let mut boxes: Vec<usize> =
        places.iter().flat_map(|&place| &modules[place].children).copied().collect();
    boxes.sort_unstable();
    boxes.dedup();
    boxes.retain(|child| !places.contains(child));
    let mut text: String = boxes.iter().map(|&child| modules[child].black_box()).collect();
    text.extend(places.iter().map(|&place| modules[place].source()));
    text.extend(library.primitive_modules());
    // Writing to a String cannot fail.
    let _ = writeln!(text, "module {TOP};");
    for (number, name) in library.names(places).iter().enumerate() {
        let _ = writeln!(text, "  {name} module_{number} ();");
    }
    text.push_str("endmodule\n");
    text
}

/// Everything of `synth_ecp5`, but delay lines alone are flattened: their cells are those of the
/// module that they are in, and have its widths and lengths. Registers are boxes while gates are
/// mapped: every pass looks at every cell, and most cells would be flip-flops, in which there is
/// nothing to map.
fn script(names: &[String]) -> String {
    let synth = |labels: &str| format!("synth_ecp5 -noflatten -top {TOP} -run {labels}");
    let count = |name: &String| format!("tee -q -o {} stat {name}", counts_file(name));
    let commands = [
        "read_verilog registers.v modules.v".to_owned(),
        synth("begin:coarse"),
        "proc".to_owned(),
        format!("setattr -mod -set keep_hierarchy 1 {}", names.join(" ")),
        "flatten".to_owned(),
        synth("coarse:map_ram"),
        "techmap -map to_registers.v".to_owned(),
        synth("map_ram:check"),
        "techmap -map to_flip_flops.v".to_owned(),
        // Flip-flops that nobody reads.
        "clean".to_owned(),
    ];
    commands.into_iter().chain(names.iter().map(count)).collect::<Vec<_>>().join("; ")
}
