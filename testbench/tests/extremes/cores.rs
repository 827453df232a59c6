//! Cores with several options of a method.
use specula_fixtures::specs::{lyon, spec};
use specula_scene::Frame;
use specula_spec::duff::Highlight;
use specula_spec::lyon::Difference;
use specula_spec::reflection;
use specula_spec::{CoreSpec, Method, MethodSpec};

/// `lyon` with D = R - L and k squarings.
pub fn reflection_form(frame: &Frame, squarings: u32) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.difference, lyon.squarings) = (Difference::ReflectionMinusLight, squarings)
    })
}

/// `lyon` with D = H × N and k squarings.
pub fn cross_form(frame: &Frame, squarings: u32) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.difference, lyon.squarings) = (Difference::HalfwayCrossNormal, squarings)
    })
}

/// `duff` with one of its highlights.
pub fn duff(frame: &Frame, highlight: Highlight) -> CoreSpec {
    let mut core = spec(frame, Method::Duff);
    if let MethodSpec::Duff(duff) = &mut core.method {
        duff.specular = highlight;
    }
    core.check().unwrap();
    core
}

/// `duff` with each of its highlights.
pub fn duffs(frame: &Frame) -> [CoreSpec; 4] {
    [Highlight::Blinn, Highlight::Quotient, Highlight::Eq33, Highlight::Eq34]
        .map(|highlight| duff(frame, highlight))
}

/// `reflection` with each of its highlights, and with both fixed normals.
pub fn reflections(frame: &Frame) -> [CoreSpec; 3] {
    use reflection::{Bisector, Highlight};
    let with = |(bisector, specular)| {
        let mut core = spec(frame, Method::Reflection);
        if let MethodSpec::Reflection(reflection) = &mut core.method {
            (reflection.bisector, reflection.specular) = (bisector, specular);
        }
        core.check().unwrap();
        core
    };
    let (span, triangle) = (Bisector::Span, Bisector::Triangle);
    [(span, Highlight::Blinn), (triangle, Highlight::Hybrid), (triangle, Highlight::Eq34)].map(with)
}

/// `lyon` with both differences, `duff` and `reflection` with each of their highlights, and the
/// other methods.
pub fn cores(frame: &Frame) -> Vec<CoreSpec> {
    let several = [Method::Lyon, Method::Duff, Method::Reflection];
    let others = Method::ALL
        .into_iter()
        .filter(|method| !several.contains(method))
        .map(|method| spec(frame, method));
    let lyons = [cross_form(frame, 2), reflection_form(frame, 2)];
    lyons.into_iter().chain(duffs(frame)).chain(reflections(frame)).chain(others).collect()
}
