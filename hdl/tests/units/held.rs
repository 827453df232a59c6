//! Registers with an enable: both the enable and the load count with a valid pixel only.
use specula_datapath::Format;
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, paused, run};

use super::Bench;

#[test]
fn registers_with_an_enable_wait_for_a_pixel() {
    let bench = Bench::new();
    let byte = Format::unsigned(8, 0);
    let [value, loaded] = ["value", "loaded"].map(|name| bench.input(name, byte, (0, 255)));
    let [enable, load] =
        ["enable", "load"].map(|name| bench.input(name, Format::unsigned(1, 0), (0, 1)));
    let inside = (("value", &value), ("enable", &enable), ("loaded", &loaded), ("load", &load));
    let [held, held_or_loaded]: [_; 2] = bench
        .b
        .unit("holder", "", inside, |_, (value, enable, loaded, load)| {
            vec![value.held(&enable), value.held_or_loaded(&enable, &load, &loaded)]
        })
        .try_into()
        .unwrap_or_else(|_| unreachable!("two go in"));
    let design = bench.finish(&[("held", held), ("held_or_loaded", held_or_loaded)]);
    assert_eq!(design.size().multiplexers, 2, "an enable is no multiplexer");

    let mut draw = Draw::new(6);
    let mut row = |number: u32| {
        // The first pixel takes both over.
        let bit = |draw: &mut Draw| i64::from(number == 0 || draw.below(4) == 0);
        let mut byte = || draw.between(0, 255);
        let [value, loaded] = [byte(), byte()];
        vec![value, loaded, bit(&mut draw), bit(&mut draw)]
    };
    let rows: Vec<Vec<i64>> = (0..200).map(&mut row).collect();
    let [mut held, mut kept] = [0; 2];
    let wanted: Vec<Vec<i64>> = rows
        .iter()
        .map(|row| {
            let [value, loaded, enable, load] = row[..] else { unreachable!("a row has four") };
            held = if enable == 1 { value } else { held };
            kept = match [enable, load] {
                [_, 1] => loaded,
                [1, _] => value,
                _ => kept,
            };
            vec![held, kept]
        })
        .collect();
    let drives: Vec<Drive> = rows.into_iter().map(Drive::pixel).collect();
    assert_eq!(run(&design, drives.clone()), wanted);
    assert_eq!(run(&design, paused(&design, &drives, &mut draw)), wanted);
}
