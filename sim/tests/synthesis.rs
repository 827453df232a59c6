//! Cells of an ECP5, counted module by module.
use std::process::Command;
use std::sync::Mutex;

use specula_datapath::Design;
use specula_datapath::verilog::{self, Header, LongDelays};
use specula_fixtures::specs::spec_with;
use specula_fixtures::{few_spans, tools};
use specula_sim::{Progress, Synthesised, synthesise};
use specula_spec::Method;

/// What Yosys makes of a core as a whole, flattened, with every register mapped.
fn flattened(design: &Design) -> Synthesised {
    let folder = tempfile::tempdir().unwrap();
    let long_delays = LongDelays::ShiftRegisters;
    let text = verilog::print_with(&design.to_block(), &Header::default(), long_delays);
    std::fs::write(folder.path().join("core.v"), text).unwrap();
    let script = "read_verilog core.v; synth_ecp5; tee -q -o cells.txt stat";
    assert!(
        Command::new("yosys")
            .current_dir(folder.path())
            .args(["-q", "-p", script])
            .status()
            .unwrap()
            .success()
    );
    let cells = std::fs::read_to_string(folder.path().join("cells.txt")).unwrap();
    let count = |kind: &str| -> u64 {
        let words = cells.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
        words
            .filter(|words| words.contains(&kind))
            .find_map(|words| words.iter().find_map(|w| w.parse().ok()))
            .unwrap_or(0)
    };
    Synthesised {
        luts: count("LUT4") + 2 * count("CCU2C"),
        multipliers: count("MULT18X18D"),
        flip_flops: count("TRELLIS_FF"),
    }
}

fn near(ours: u64, theirs: u64) -> bool {
    ours.abs_diff(theirs) * 25 <= theirs
}

#[test]
fn cells_are_near_those_of_the_flattened_core_and_equal_modules_are_synthesised_once() {
    if !tools::is_installed("yosys") {
        return;
    }
    let frame = few_spans::frame(1993, 2, 12);
    let [general, special] = {
        let spec = spec_with(&frame, Method::Gouraud, "");
        [spec.general(), spec.specialised(&frame)]
            .map(|spec| specula_hdl::elaborate(&spec, "gouraud").unwrap())
    };
    let seen = Mutex::new(vec![]);
    let watch = |progress: Progress| seen.lock().unwrap().push(progress);
    let cells = synthesise(&[&general, &special, &general], &watch).unwrap();
    assert_eq!(cells[0], cells[2]);
    for (ours, theirs) in cells.iter().zip([&general, &special].map(flattened)) {
        assert_eq!(ours.multipliers, theirs.multipliers);
        assert!(
            near(ours.luts, theirs.luts) && near(ours.flip_flops, theirs.flip_flops),
            "{ours:?} {theirs:?}"
        );
    }
    assert!(cells[1].flip_flops < cells[0].flip_flops, "{cells:?}");
    let modules = seen.into_inner().unwrap().iter().map(|progress| progress.modules).max();
    let alone = |design: &Design| {
        let mut library = verilog::Library::new("core", LongDelays::ShiftRegisters);
        library.add(&design.to_block());
        library.modules().len()
    };
    assert!(modules <= Some(alone(&general) + alone(&special)), "{modules:?}");
}
