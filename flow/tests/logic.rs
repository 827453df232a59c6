//! Designs in gates and in look-up tables alone.
use specula_datapath::{Builder, Design, Format, InputPort};
use specula_fixtures::tools;
use specula_flow::synth::{Cells, Logic, SynthTarget, synthesised_both_ways};

/// The product of two numbers of so many bits.
fn product(bits: u32) -> Design {
    let builder = Builder::new("products", "a b");
    let control = builder.control();
    let [a, b] = ["a", "b"]
        .map(|name| builder.input(&InputPort::whole(name.to_owned(), Format::unsigned(bits, 0))));
    builder.finish(&control.valid, &[("product", &a * &b)]).unwrap()
}

#[test]
fn a_product_is_gates_or_tables_or_a_block() {
    if !tools::is_installed("yosys") {
        return;
    }
    let counted =
        synthesised_both_ways(&[1, 4, 8].map(product), &SynthTarget::ECP5, &|| {}).unwrap();
    let logic: Vec<Logic> = counted.iter().map(|(_, logic)| *logic).collect();
    // One AND gate, which is a NAND gate and an inverter, or a table; and a flip-flop behind it,
    // beside that of validity.
    assert_eq!(logic[0], Logic { gates: 2, luts: 1, flip_flops: 2 });
    // Twice as wide, and about four times the gates: n² AND gates and n² - n adders of a bit.
    let [four, eight] = [logic[1], logic[2]];
    assert!((3 * four.gates..6 * four.gates).contains(&eight.gates), "{four:?} {eight:?}");
    assert!(eight.gates > 64 * 2 && eight.luts < eight.gates, "{eight:?}");
    // Every bit of the product has a register.
    assert_eq!([four.flip_flops, eight.flip_flops], [8 + 1, 16 + 1]);
    let Cells { blocks, .. } = counted[2].0;
    assert_eq!(blocks, 1, "the device has blocks for products");
}
