//! The papers' operations per pixel against what the elaborated cores contain, with one light;
//! docs/operations.md explains differences.
use specula_experiments::operations::lecture::COUNTS;
use specula_experiments::operations::lyon::PARTS;
use specula_experiments::operations::{HAST, products};
use specula_golden::loops::operations::TABLE;
use specula_scene::{Frame, load};

/// Whether docs/operations.md has this line.
fn is_documented(line: &str) -> bool {
    include_str!("../../docs/operations.md").lines().any(|documented| documented == line)
}

fn teapot() -> Frame {
    load("teapot", Some((160, 120))).unwrap().frame
}

#[test]
fn forward_differences_are_as_many_as_the_papers_count() {
    let frame = teapot();
    assert_eq!(frame.lights.len(), 1);
    for counterpart in HAST {
        let name = counterpart.row;
        let printed = TABLE.iter().find(|row| row.name == name).unwrap().printed;
        let core = counterpart.contents(&frame).unwrap();
        println!("{name}: {core:?} printed {printed:?}");
        assert_eq!(core.accumulators, printed.adds as usize, "{name}: additions");
        // 1/√q is one unit, a root and a division together.
        assert_eq!(core.reciprocal_roots, printed.square_roots as usize, "{name}: roots");
        assert_eq!(
            core.dividers + core.reciprocal_roots,
            printed.divisions as usize,
            "{name}: divisions"
        );
        assert_eq!(
            core.multipliers,
            printed.multiplies as usize + counterpart.further_products,
            "{name}: products"
        );
    }
}

#[test]
fn figures_7_and_8_have_the_multipliers_that_are_documented() {
    let frame = teapot();
    for unit in PARTS.chunk_by(|a, b| a.unit == b.unit) {
        let wanted: Vec<[u32; 2]> = unit.iter().flat_map(|part| part.core).copied().collect();
        assert_eq!(
            products(&unit[0].design(&frame).unwrap(), unit[0].unit),
            wanted,
            "{}",
            unit[0].unit
        );
    }
    for part in PARTS {
        let [wide, narrow] = part.core[0];
        let core = format!("{} of {narrow} × {wide}", part.core.len());
        let line = format!(
            "| {} | {} | {} | {core} | {} |",
            part.figure, part.product, part.printed, part.why
        );
        assert!(is_documented(&line), "{line}");
    }
}

#[test]
fn the_lectures_counts_are_documented() {
    let frame = teapot();
    for count in COUNTS {
        let core = count.contents(&frame).unwrap();
        assert_eq!(core, count.core, "{}", count.what);
        let numbers = [core.accumulators, core.multipliers, core.dividers, core.reciprocal_roots]
            .map(|n| n.to_string())
            .join(", ");
        let options: Vec<&str> = count
            .options
            .lines()
            .map(|line| line.split_once('.').map_or(line, |(_, option)| option))
            .collect();
        let options: String = options.iter().map(|option| format!(", `{option}`")).collect();
        let method = count.method.name();
        let line = format!(
            "| {} | {} | {} | `{method}`{options} | {numbers} |",
            count.section, count.what, count.printed
        );
        assert!(is_documented(&line), "{line}");
    }
}

/// A step of the slerp takes a product of each of four numbers with a cosine and with a sine
/// [lecture, 4.9 to 4.12].
#[test]
fn slerp_turns_by_the_printed_eight_products() {
    let slerp = COUNTS.iter().find(|count| count.options.contains("ends")).unwrap();
    assert_eq!(products(&slerp.design(&teapot()).unwrap(), "scaled_rotation").len(), 8);
}
