//! Spans that are set up one behind the other, and cores for one frame that need none.
use specula_fixtures::each_method;
use specula_scene::{Frame, LoadedScene, load};
use specula_spec::{CoreSpec, Format, Method, SceneCore, SetUp};

each_method!(spans_are_appended);
each_method!(a_place_within_the_core_needs_no_set_up);

/// Scenes with lights at infinity and at places, small.
fn scenes() -> [LoadedScene; 2] {
    ["torus", "lamps"].map(|name| load(name, Some((32, 24))).unwrap())
}

/// The method's cores for those scenes that it can shade.
fn cores(method: Method) -> Vec<(CoreSpec, Frame)> {
    let scenes = scenes().into_iter();
    scenes.filter_map(|scene| Some((scene.core_spec(Some(method)).ok()?, scene.frame))).collect()
}

/// Every span as by itself, in the memory that there is.
fn spans_are_appended(method: Method) {
    for (core, frame) in cores(method) {
        let (set_up, ports) = (SetUp::new(&core, &frame), core.inputs().len());
        let mut inputs = Vec::with_capacity(1 + ports);
        let memory = (inputs.as_ptr(), inputs.capacity());
        for span in &frame.spans {
            inputs.clear();
            // What is there already is left as it is, whatever the first port's range.
            inputs.push(i64::MIN);
            set_up.append(span, &mut inputs);
            assert_eq!((inputs[0], &inputs[1..]), (i64::MIN, &set_up.packet(span).inputs[..]));
            assert_eq!(inputs.len(), 1 + ports);
        }
        assert_eq!((inputs.as_ptr(), inputs.capacity()), memory);
    }
}

/// A core with another format somewhere is the same for a frame alone whether its spans are set up
/// or not; where the place is within the core, they are not.
fn a_place_within_the_core_needs_no_set_up(method: Method) {
    for (core, frame) in cores(method) {
        let special = core.specialised(&frame);
        // What such a core is given is not what the frame's is.
        let first = Frame { spans: frame.spans[..1].to_vec(), ..frame.clone() };
        let of_first = core.specialised(&first);
        assert_ne!(of_first, special);
        let (mut taken, mut points) = (0, 0);
        for point in core.narrowing_points() {
            let fraction_bits = point.format.fraction_bits + 2;
            let format = Format { fraction_bits, ..point.format };
            let Ok(finer) = core.with_formats(&[(point.name, format)]) else { continue };
            let set_up = finer.specialised(&frame);
            assert_eq!(finer.specialised_as(&special, &frame), set_up, "{}", point.name);
            taken += usize::from(finer.specialised_as(&of_first, &frame) != set_up);
            points += 1;
        }
        assert!(0 < taken && taken < points, "{taken} of {points}");
    }
}
