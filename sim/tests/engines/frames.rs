//! Frames one after the other: every signal at every clock in every engine, while what holds for a
//! frame changes in between.
use specula_fixtures::specs::{packets, spec};
use specula_fixtures::{each_method, few_spans};
use specula_scene::Frame;
use specula_sim::Stimulus;
use specula_spec::{CoreSpec, Hold, LightPipelines, Method, SpanPacket};

use crate::elaborated;
use crate::pausing::engines_agree;

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
        for count in [1, frames.len()] {
            let packets: Vec<SpanPacket> =
                frames[..count].iter().flat_map(|frame| packets(&spec, frame)).collect();
            engines_agree(&design, &Stimulus::whole(&packets, &design));
            if count > 1 {
                engines_agree(&design, &Stimulus::whole(&packets, &design).with_bubbles(seed));
            }
        }
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
