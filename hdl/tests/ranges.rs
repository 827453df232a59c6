//! Every signal stays in its proven range, and every stated fact holds, whatever spec and scene
//! are.
use specula_fixtures::clocked::{Drive, run};
use specula_fixtures::{Draw, drawn, each_method};
use specula_spec::Method;

fn stays_in_range(seed: u64, method: Method) {
    let mut draw = Draw::new(seed);
    let longest = draw.one_of(&[1, 2, 3, 20, 200]);
    let frame = drawn::frame(&mut draw, longest);
    let spec = drawn::spec(&mut draw, &frame, method);
    println!("{spec:?}");
    // A spec whose formats are too fine is refused, which is an answer too; panics are none.
    let Ok(design) = specula_hdl::elaborate(&spec, "core") else { return };
    let packets: Vec<_> = frame.spans.iter().map(|span| spec.packet(&frame, span)).collect();
    run(&design, packets.iter().flat_map(Drive::span));
}

fn every_signal_stays_in_its_range(method: Method) {
    let specs = if matches!(method, Method::Slerp | Method::Direct) { 250 } else { 80 };
    (0..specs).for_each(|seed| stays_in_range(seed, method));
}

each_method!(every_signal_stays_in_its_range);
