//! A bench that finds nothing must be one that would have found something: designs, specs and facts
//! broken on purpose.
use glam::DVec3;
use specula_datapath::design::{Assumption, NodeId, Op, Range};
use specula_fixtures::frames::{Row, frame, frame_of, material, tilted};
use specula_fixtures::specs::{lyon, spec};
use specula_scene::Frame;
use specula_spec::lyon::{Difference, Normalisation};
use specula_spec::{CoreSpec, Method};
use specula_testbench::{Bench, BenchError, EngineKind, MovedInput, Outcome, Wrong};

/// Wide spans and slanting lights, so that every operator has something to do.
fn picture() -> Frame {
    let lights = [DVec3::new(0.36, -0.48, 0.8), DVec3::new(-0.48, 0.6, 0.64)];
    let row = |number: u32| {
        let from = tilted(25.0 * f64::from(number) - 60.0);
        let to = (from + DVec3::new(0.7, 0.8 - 0.3 * f64::from(number), 0.2)).normalize();
        Row { normals: [from, to], length: 3 + 9 * number, material: material(0.1, 0.4, 0.45, 8) }
    };
    frame_of(&[0, 1, 2, 3, 4, 5].map(row), &lights)
}

fn run(bench: &Bench) -> Outcome {
    bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap()
}

/// The operator that somebody might have meant.
fn mistaken(op: Op) -> Option<Op> {
    match op {
        Op::Add(a, b) => Some(Op::Sub(a, b)),
        Op::Sub(a, b) => Some(Op::Add(a, b)),
        Op::Mul(a, b) if a != b => Some(Op::Add(a, b)),
        Op::LessThan(a, b) => Some(Op::LessThan(b, a)),
        Op::Select(c, a, b) => Some(Op::Select(c, b, a)),
        _ => None,
    }
}

/// `lyon` with formats so coarse that half a unit of the last place shows in the codes.
fn coarse(frame: &Frame, difference: Difference) -> CoreSpec {
    lyon(frame, |lyon| {
        lyon.difference = difference;
        let f = &mut lyon.formats;
        for format in
            [&mut f.weight, &mut f.vector, &mut f.length_squared, &mut f.gain, &mut f.difference]
        {
            format.fraction_bits = 7;
        }
    })
}

/// An operator that never matters in the picture cannot be missed, so the share is not quite 1.
fn share_of_mistakes_found(core: &CoreSpec, frame: &Frame) -> f64 {
    let bench = Bench::new(frame, core, "core").unwrap();
    assert_eq!(run(&bench).fault(), None);
    let (mut made, mut found) = (0, 0);
    for node in 0..bench.design.nodes.len() {
        let Some(op) = mistaken(bench.design.nodes[node].op) else { continue };
        let mut broken = Bench::new(frame, core, "core").unwrap();
        broken.design.nodes[node].op = op;
        made += 1;
        let outcome = run(&broken);
        let reported = outcome.comparison.mismatches > 0 || outcome.violation.is_some();
        assert_eq!(outcome.agrees(), !reported);
        found += usize::from(reported);
        if !reported {
            println!("not found: {} as {op:?}", bench.design.full_name(NodeId(node as u32)));
        }
    }
    println!("{found} of {made} mistakes found");
    assert!(made > 50);
    found as f64 / made as f64
}

#[test]
fn mistaken_operators_of_lyons_cross_product_are_reported() {
    let frame = picture();
    assert!(
        share_of_mistakes_found(&coarse(&frame, Difference::HalfwayCrossNormal), &frame) > 0.95
    );
}

#[test]
fn mistaken_operators_of_lyons_reflection_are_reported() {
    let frame = picture();
    assert!(
        share_of_mistakes_found(&coarse(&frame, Difference::ReflectionMinusLight), &frame) > 0.95
    );
}

#[test]
fn mistaken_operators_of_the_hybrid_are_reported() {
    let frame = picture();
    assert!(share_of_mistakes_found(&spec(&frame, Method::Hybrid), &frame) > 0.9);
}

/// A core that was built from another spec than the model's, and than the one that the spans are
/// set up for.
#[test]
fn another_spec_is_reported() {
    let frame = picture();
    let core = spec(&frame, Method::Lyon);
    let others = [
        lyon(&frame, |lyon| lyon.squarings += 1),
        lyon(&frame, |lyon| lyon.normalisation = Normalisation::G1),
        lyon(&frame, |lyon| lyon.formats.shape.fraction_bits = 6),
        lyon(&frame, |lyon| lyon.formats.vector.fraction_bits -= 1),
        lyon(&frame, |lyon| (lyon.normalisation, lyon.newton_steps) = (Normalisation::G1, 0)),
    ];
    for other in others {
        let mut bench = Bench::new(&frame, &core, "core").unwrap();
        bench.design = specula_hdl::elaborate(&other, "core").unwrap();
        let outcome = run(&bench);
        assert!(!outcome.agrees() && outcome.comparison.mismatches > 0, "{other:?}");
        let first = outcome.comparison.first_mismatch.unwrap();
        assert_ne!(first.simulated, first.expected);
        let span = &frame.spans[first.span];
        assert_eq!((first.x, first.y), (span.x + first.pixel, span.y));
        let at = (first.y * frame.width + first.x) as usize;
        assert_eq!(outcome.simulated.pixels[at], first.simulated);
        assert_eq!(outcome.comparison.expected.pixels[at], first.expected);
    }
}

/// Pixels that are right and leave a clock late, or not at all.
#[test]
fn wrong_clocks_are_reported() {
    let frame = picture();
    let core = spec(&frame, Method::Lyon);
    for late in [true, false] {
        let mut bench = Bench::new(&frame, &core, "core").unwrap();
        let valid_out = bench.design.valid_out;
        let Op::Copy(before) = bench.design.node(valid_out).op else {
            panic!("validity is delayed")
        };
        // Of two registers in a row one is left out, or both are held.
        let earlier = bench.design.node(before).op;
        bench.design.nodes[valid_out.0 as usize].op =
            if late { earlier } else { Op::Copy(valid_out) };
        let outcome = run(&bench);
        assert!(!outcome.agrees());
        let pixels = frame.shaded_pixels() as usize;
        let first = u64::from(bench.design.latency());
        if late {
            assert_eq!(outcome.wrong_clocks, [first - 1, first + pixels as u64 - 1]);
        } else {
            assert_eq!(outcome.wrong_clocks.len(), pixels);
        }
    }
}

/// A stated fact that is untrue is reported with the clock and the value, though every pixel is
/// right.
#[test]
fn untrue_facts_are_reported() {
    let frame = picture();
    for core in [spec(&frame, Method::Lyon), spec(&frame, Method::Hybrid)] {
        let mut bench = Bench::new(&frame, &core, "core").unwrap();
        let node = bench.design.outputs[1];
        bench.design.assumptions.push(Assumption {
            fact: "green is dim".into(),
            node,
            range: Range::new(0, 100),
        });
        let outcome = run(&bench);
        assert_eq!(outcome.comparison.mismatches, 0);
        assert!(!outcome.agrees());
        let violation = outcome.violation.unwrap();
        assert_eq!(
            (violation.fact.as_str(), violation.signal.as_str()),
            ("green is dim", "core.green")
        );
        let order = frame
            .spans
            .iter()
            .flat_map(|s| (0..s.length).map(|i| (s.y * frame.width + i) as usize));
        let first = order
            .clone()
            .position(|at| outcome.simulated.pixels[at][1] > 100)
            .expect("some green is bright");
        let value = order.map(|at| outcome.simulated.pixels[at][1]).nth(first).unwrap();
        assert_eq!(
            (violation.clock, violation.value()),
            (first as u64 + u64::from(bench.design.latency()), value.into())
        );
    }
}

/// A core whose colours hold for a frame is given a frame of several materials: the first span whose
/// colours are others is told, and so is what they spoil.
#[test]
fn an_input_that_moves_within_a_frame_is_reported() {
    let mut frame = picture();
    frame.materials.truncate(1);
    frame.triangles.iter_mut().for_each(|triangle| triangle.material = 0);
    frame.materials.push(material(0.2, 0.5, 0.2, 8));
    frame.triangles[3].material = 1;
    let several = spec(&frame, Method::Lyon);
    let mut one = several.clone();
    assert!(several.parameters.several_materials);
    one.parameters.several_materials = false;
    assert_eq!(run(&Bench::new(&frame, &several, "core").unwrap()).fault(), None);
    let bench = Bench::new(&frame, &one, "core").unwrap();
    let outcome = run(&bench);
    let moved = outcome.moved_input.as_ref().expect("ambient light changes");
    let clock: u32 = frame.spans[..3].iter().map(|span| span.length).sum();
    let leaves = u64::from(clock) - 1 + u64::from(bench.design.depth());
    let wrong = Wrong::UnderWay { leaves };
    let (port, clock) = ("core.ambient_r".into(), clock.into());
    assert_eq!(moved, &MovedInput { port, span: 3, clock, wrong });
    assert!(!outcome.agrees() && outcome.comparison.mismatches > 0);
}

/// Values that idle clocks leave behind the last pixel are nobody's, and break no fact.
#[test]
fn idle_clocks_break_no_fact() {
    let frame = frame([tilted(-10.0), tilted(80.0)], 2, &[tilted(5.0)], material(0.1, 0.4, 0.4, 8));
    for core in [spec(&frame, Method::Lyon), spec(&frame, Method::Hybrid)] {
        let bench = Bench::new(&frame, &core, "core").unwrap();
        assert_eq!(run(&bench).fault(), None);
    }
}

/// A span that is longer than the core was built for is refused, not shaded wrongly.
#[test]
fn spans_too_long_for_the_core_are_refused() {
    let short = frame([tilted(-10.0), tilted(10.0)], 8, &[tilted(5.0)], material(0.1, 0.4, 0.4, 8));
    let long = frame([tilted(-10.0), tilted(10.0)], 9, &[tilted(5.0)], material(0.1, 0.4, 0.4, 8));
    for core in [spec(&short, Method::Lyon), spec(&short, Method::Hybrid)] {
        let bench = Bench::new(&long, &core, "core").unwrap();
        assert!(matches!(
            bench.run(EngineKind::RustHdl, &mut |_, _| ()),
            Err(BenchError::Packet(_))
        ));
    }
}
