//! Spans that are set up one behind the other, and cores for one frame that need none.
use specula_fixtures::each_method;
use specula_scene::{Frame, LoadedScene, Needs, load};
use specula_spec::{CoreOptions, CoreSpec, Format, Hold, Method, SceneCore, SetUp};

each_method!(spans_are_appended);
each_method!(a_place_within_the_core_needs_no_set_up);
each_method!(what_holds_for_a_frame_is_the_same_in_every_span);

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

/// In every scene, with every option of the method, and in a frame with a span that has no normal.
/// What does not hold for a frame differs somewhere, or need not.
fn what_holds_for_a_frame_is_the_same_in_every_span(method: Method) {
    let mut frames: Vec<Frame> = specula_fixtures::still_scenes()
        .iter()
        .map(|name| load(name, Some((48, 36))).expect("it is built in").frame)
        .collect();
    frames.push(without_a_normal(frames[0].clone()));
    for frame in &frames {
        let needs = Needs { uneven_shininess: None, ..Needs::of(frame) };
        for table in tables(method) {
            let Ok(core) = CoreSpec::for_scene(&needs, Some(&table), Some(method)) else {
                continue;
            };
            assert_eq!(moving_input(&core, frame), None, "{core:?}");
        }
    }
    // The teapot has one material under lights at infinity.
    let core = CoreSpec::for_scene(&Needs::of(&frames[0]), None, Some(method)).unwrap();
    let held = core.inputs().iter().filter(|port| port.hold == Hold::Frame).count();
    assert!(held >= 9, "colours at least, and not {held}");
}

/// The first input that holds for a frame and is not the same in every span.
fn moving_input(core: &CoreSpec, frame: &Frame) -> Option<String> {
    let set_up = SetUp::new(core, frame);
    let first = set_up.packet(&frame.spans[0]).inputs;
    let mut others = frame.spans[1..].iter().map(|span| set_up.packet(span).inputs);
    let ports = core.inputs();
    let moves = |inputs: Vec<i64>| {
        let mut held = (0..ports.len()).filter(|&input| ports[input].hold == Hold::Frame);
        held.find(|&input| inputs[input] != first[input])
    };
    others.find_map(moves).map(|input| ports[input].name.clone())
}

/// The same frame, the last span of which has no normal.
fn without_a_normal(mut frame: Frame) -> Frame {
    let last = frame.spans.last().expect("it shows something").triangle;
    frame.triangles[last].normals = Default::default();
    frame
}

/// The options of a method: none, and each with each of its values.
fn tables(method: Method) -> impl Iterator<Item = CoreOptions> {
    let options = method
        .option_domains()
        .iter()
        .flat_map(|option| option.values.iter().map(|value| format!("{} = {value}", option.key)));
    [String::new()].into_iter().chain(options).map(move |option| {
        let beside = if option.starts_with("frame ") { "form = \"vector\"" } else { "" };
        format!("[{}]\n{option}\n{beside}", method.name()).parse().expect("it is TOML")
    })
}
