//! A core that shades single spans.
use glam::DVec3;
use specula_golden::fixed::{Model, Observation};
use specula_scene::{Frame, Material, Needs, parse};
use specula_spec::{CoreSpec, FULL_SCALE};

use crate::stress::scene::{RawSpan, SpanScene};
use crate::stress::variant::Variant;

/// A core as its bit-true model, which the simulated core equals on every pixel.
pub struct SpanCore {
    /// Its spec.
    pub spec: CoreSpec,
    model: Model,
}

/// The frame of a span between two normals under one light; `None` if a scene file could not
/// describe it.
pub fn frame(ends: [DVec3; 2], length: u32, light: DVec3, material: Material) -> Option<Frame> {
    let scene = SpanScene::new(&[light], vec![RawSpan::between(ends, length, material)]);
    parse("span.toml", scene.text("")).ok().map(|scene| scene.frame)
}

impl SpanCore {
    /// The general core of a method with options. Formats that the options do not name are those
    /// that `frame` needs.
    pub fn new(frame: &Frame, variant: &Variant) -> Option<SpanCore> {
        let spec = variant.core_spec(&Needs::of(frame)).ok()?;
        Some(SpanCore { model: Model::new(&spec), spec })
    }

    /// Every named value of pixel `i` of the first span.
    pub fn trace(&self, frame: &Frame, i: u32) -> Option<Vec<Observation>> {
        self.model.trace(&self.spec.packet(frame, &frame.spans[0]), i).ok()
    }

    /// Codes of the first span's pixels, as shares of full scale.
    pub fn shades(&self, frame: &Frame) -> Option<Vec<f64>> {
        let mut codes = vec![];
        self.model.shade(&self.spec.packet(frame, &frame.spans[0]), &mut codes).ok()?;
        Some(codes.iter().map(|code| f64::from(code[1]) / FULL_SCALE).collect())
    }
}

/// The value of that name.
pub fn value(trace: &[Observation], name: &str) -> Option<f64> {
    Observation::named(trace, name).map(Observation::value)
}

/// The vector whose components have that name.
pub fn vector(trace: &[Observation], name: &str) -> Option<DVec3> {
    let [x, y, z] = ["x", "y", "z"].map(|axis| value(trace, &format!("{name}_{axis}")));
    Some(DVec3::new(x?, y?, z?))
}
