//! What the layout of a packet says of the hardware, and what it is with every option.
use specula_fixtures::any_spec;
use specula_flow::stream::{StreamCore, StreamShape};
use specula_scene::Needs;
use specula_spec::{CoreSpec, FieldContent, Hold, Method, Positions, WordWidth};

use crate::block::frames;

/// Fields of a packet are exactly those inputs of the hardware that hold for a span, as wide as
/// they are there, and registers the others.
#[test]
fn packets_and_registers_have_what_the_hardware_has() {
    let frame = frames(13).swap_remove(0);
    let needs = Needs::of(&frame);
    let mut random = fastrand::Rng::with_seed(14);
    let (mut fields, mut registers) = (0, 0);
    for method in Method::ALL {
        for _ in 0..4 {
            let spec = any_spec(&needs, method, |low, high| random.u32(low..=high));
            for spec in [spec.specialised(&frame), spec] {
                let [own_fields, own_registers] = checked(&spec);
                fields += own_fields;
                registers += own_registers;
            }
        }
    }
    assert!(fields > 500 && registers > 100, "{fields} {registers}");
}

/// How many fields and registers inputs have, each of which is as it is in the hardware.
fn checked(spec: &CoreSpec) -> [usize; 2] {
    let Ok(design) = specula_hdl::elaborate(spec, "shader") else { return [0; 2] };
    let shape = StreamShape { word: WordWidth::Bits32, positions: Positions::Sent };
    let core = StreamCore::new(spec, &design, shape, "");
    let mut places = vec![None; design.inputs.len()];
    let (mut next, mut fields) = (0, 0);
    for field in &core.layout.fields {
        assert_eq!(field.first_bit, next, "{spec:?}");
        next += field.format.width();
        if let FieldContent::Input(number) = field.content {
            places[number] = Some((Hold::Span, field.format, field.name.clone()));
            fields += 1;
        }
    }
    assert_eq!(core.layout.bits, next);
    let registers = core.frame_inputs();
    for input in &registers {
        places[input.number] = Some((Hold::Frame, input.format, input.name.clone()));
    }
    for (place, input) in places.into_iter().zip(&design.inputs) {
        let built = input.map(|id| {
            let node = design.node(id);
            let hold = if node.still { Hold::Frame } else { Hold::Span };
            (hold, node.format(), node.name.clone())
        });
        assert_eq!(place, built, "{spec:?}");
    }
    [fields, registers.len()]
}
