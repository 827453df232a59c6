//! Frames one after the other: every signal at every clock in every engine, while what holds for a
//! frame changes in between.

use specula_datapath::{Builder, Format, InputPort};
use specula_fixtures::specs::{packets, spec};
use specula_fixtures::{each_method, few_spans};
use specula_scene::Frame;
use specula_sim::Stimulus;
use specula_spec::{CoreSpec, Hold, LightPipelines, Method, SpanPacket, TargetClock};

use crate::elaborated;
use crate::pausing::{engines_agree, own_engines_agree};

/// Frames of one material each, under other lights.
fn frames(seed: u64) -> Vec<Frame> {
    let one_material = |number: u64| {
        let mut frame = few_spans::frame(seed + number, 2, 3);
        let shown = 1 - number as usize % 2;
        frame.triangles.iter_mut().for_each(|triangle| triangle.material = shown);
        frame.materials[shown].diffuse[0] += 0.1 * number as f64;
        frame
    };
    (0..3).map(one_material).collect()
}

fn frames_follow_each_other(method: Method) {
    let seed = 1971 + method as u64;
    println!("seed {seed}");
    let frames = frames(seed);
    for pipelines in [LightPipelines::Each, LightPipelines::Shared] {
        let mut spec = spec(&frames[0], method);
        spec.parameters.light_pipelines = pipelines;
        let design = elaborated(&spec);
        assert_eq!(design.frame_inputs(), held_for_a_frame(&spec));
        let of = |frames: &[Frame]| -> Vec<SpanPacket> {
            frames.iter().flat_map(|frame| packets(&spec, frame)).collect()
        };
        let (one, all) = (of(&frames[..1]), of(&frames));
        own_engines_agree(&design, &Stimulus::whole(&one, &design));
        own_engines_agree(&design, &Stimulus::whole(&all, &design));
        let paused = Stimulus::whole(&all, &design).with_bubbles(seed);
        match pipelines {
            LightPipelines::Each => engines_agree(&design, &paused),
            LightPipelines::Shared => drop(own_engines_agree(&design, &paused)),
        }
        // Put into stages for a clock, where operators are others.
        let target = TargetClock { name: "ecp5".into(), clock_mhz: 200.0 };
        let design = elaborated(&CoreSpec { target: Some(target), ..spec.clone() });
        own_engines_agree(&design, &Stimulus::whole(&all, &design));
    }
}

/// The numbers of the spec's inputs that hold for a frame, some of which there are.
fn held_for_a_frame(spec: &CoreSpec) -> Vec<usize> {
    let held = spec.inputs().into_iter().map(|port| port.hold == Hold::Frame);
    let numbers: Vec<usize> = held.enumerate().filter(|(_, held)| *held).map(|(k, _)| k).collect();
    assert!(numbers.len() >= 15, "colours at least");
    numbers
}

each_method!(frames_follow_each_other);

/// x·c^8, where c holds for a frame: its power settles three clocks after it changes, and is read in
/// the clock in which a pixel enters.
#[test]
fn what_settles_late_is_waited_for() {
    let builder = Builder::new("core", "x c^8");
    let control = builder.control();
    let [x, c] = ["x", "c"].map(|name| InputPort::whole(name, Format::signed(3, 0)));
    let (x, c) = (builder.input(&x), builder.input(&InputPort { hold: Hold::Frame, ..c }));
    let product = x * c.squared().squared().squared();
    let design = builder.finish(&control.valid, &[("product", product)]).unwrap();
    assert_eq!((design.depth(), design.settling(), design.frame_inputs()), (1, 3, vec![1]));
    let inputs = [[3, -2], [-7, -2], [5, 7], [1, -8], [2, -8], [-8, -8], [7, 0], [7, 1]];
    let packets: Vec<SpanPacket> =
        inputs.map(|inputs| SpanPacket { length: 2, inputs: inputs.to_vec() }).to_vec();
    for stimulus in
        [Stimulus::whole(&packets, &design), Stimulus::whole(&packets, &design).with_bubbles(5)]
    {
        engines_agree(&design, &stimulus);
        let shown = own_engines_agree(&design, &stimulus);
        let [valid, product] =
            [design.valid_out, design.outputs[0]].map(|id| shown.of(id).unwrap());
        let left = valid.iter().zip(product).filter(|(valid, _)| **valid == 1);
        let wanted = inputs.iter().flat_map(|[x, c]| [x * c.pow(8); 2]);
        assert!(left.map(|(_, &product)| product).eq(wanted));
    }
}
