//! The papers' operations per pixel against what the elaborated cores contain, with one light; docs/operations.md explains differences.
use specula_golden::operations::TABLE;
use specula_scene::load;
use specula_testbench::operations::HAST;

#[test]
fn forward_differences_are_as_many_as_the_papers_count() {
    let frame = load("teapot", Some((160, 120))).unwrap().frame;
    assert_eq!(frame.lights.len(), 1);
    for counterpart in HAST {
        let name = counterpart.row;
        let printed = TABLE.iter().find(|row| row.name == name).unwrap().printed;
        let core = counterpart.contents(&frame).unwrap();
        println!("{name}: {core:?} printed {printed:?}");
        assert_eq!(core.accumulators, printed.adds as usize, "{name}: additions");
        // 1/√q is one unit, a root and a division together.
        assert_eq!(core.reciprocal_roots, printed.square_roots as usize, "{name}: roots");
        assert_eq!(core.dividers + core.reciprocal_roots, printed.divisions as usize, "{name}: divisions");
        assert_eq!(core.multipliers, printed.multiplies as usize + counterpart.further_products, "{name}: products");
    }
}
