//! The papers' tables of operations against what the inner loops do.
use glam::DVec3;
use specula_golden::loops::Line;
use specula_golden::loops::operations::TABLE;
use specula_scene::frame::EYE;

#[test]
fn inner_loops_do_what_the_papers_print() {
    let ends = [DVec3::Z, DVec3::new(0.6, 0.0, 0.8)];
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let vertices = [ends[0], ends[1], DVec3::Z];
    let line = Line { ends, steps: 8, vertices, face: DVec3::Z, weights, shininess: 16, eye: EYE };
    let light = DVec3::new(0.0, 0.6, 0.8);
    let wrong: Vec<_> = TABLE
        .iter()
        .map(|row| (row.name, row.printed, (row.counted)(&line, light)))
        .filter(|r| r.1 != r.2)
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
