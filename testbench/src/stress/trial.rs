//! One scene through one core.
use std::panic::{AssertUnwindSafe, catch_unwind};

use serde::Serialize;
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_scene::{CoreSpec, Frame, Needs, SceneError, parse};

use super::row::{Case, Place, Shaded, Want};
use super::scene::SpanScene;
use super::variant::Variant;
use crate::{Bench, BenchError, EngineKind, Outcome};

/// What is not as it must be, and where.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fault {
    /// What.
    pub what: String,
    /// Number of the span in its scene.
    pub span: usize,
    /// Number of the pixel in the span.
    pub pixel: u32,
}

/// What a core did that was built.
#[derive(Clone, Debug)]
pub struct Ran {
    /// Pixels shaded.
    pub pixels: u64,
    /// Largest errors in LSBs: total, of the method, of quantisation.
    pub errors: [f64; 3],
    /// What the core's quantisation error is proven to stay within.
    pub bound: f64,
    /// Where the total error is largest.
    pub worst: Place,
    /// What is wrong.
    pub fault: Option<Fault>,
}

/// What came of it.
#[derive(Clone, Debug)]
pub enum Tried {
    /// The core is the same as that of options tried before.
    Again,
    /// There is no such core, for a reason that the user is told.
    Refused(String),
    /// It ran.
    Ran(Ran),
}

/// A case as methods are tried on it.
pub struct Prepared<'a> {
    scene: &'a SpanScene,
    want: &'a Want,
    frame: Frame,
    needs: Needs,
}

impl<'a> Prepared<'a> {
    /// Reads the scene from its own text, so that what is tried is what the file says.
    ///
    /// # Errors
    /// [`SceneError`] if it is no scene.
    pub fn new(case: &'a Case) -> Result<Prepared<'a>, SceneError> {
        Prepared::of(&case.scene, &case.want)
    }

    fn of(scene: &'a SpanScene, want: &'a Want) -> Result<Prepared<'a>, SceneError> {
        let frame = parse("stress.toml", scene.text(""))?.frame;
        let needs = Needs::of(&frame);
        Ok(Prepared { scene, want, frame, needs })
    }

    /// Tries a variant, unless its core is one of `before`, to which it is added.
    pub fn run(&self, variant: &Variant, before: &mut Vec<CoreSpec>) -> Tried {
        let spec = match variant.core_spec(&self.needs) {
            Ok(spec) if before.contains(&spec) => return Tried::Again,
            Ok(spec) => spec,
            Err(error) => return Tried::Refused(error.to_string()),
        };
        before.push(spec.clone());
        // A panic is a fault like another, and must not hide those of other rows.
        match catch_unwind(AssertUnwindSafe(|| self.shade(&spec))) {
            Ok(Ok(ran)) => Tried::Ran(ran),
            Ok(Err(BenchError::TooWide(error))) => Tried::Refused(error.to_string()),
            Ok(Err(error)) => Tried::Ran(broken(error.to_string())),
            Err(_) => Tried::Ran(broken("a panic".to_owned())),
        }
    }

    /// The scene file in which the fault, or the largest error, is to be seen: of its span alone if that suffices.
    pub fn reproducer(&self, variant: &Variant, ran: &Ran) -> String {
        let place = ran.fault.as_ref().map_or(ran.worst.span, |fault| fault.span);
        let alone = self.scene.only(place);
        let is_as_bad = match (&ran.fault, Prepared::of(&alone, self.want).map(|alone| alone.run(variant, &mut Vec::new()))) {
            (Some(_), Ok(Tried::Ran(alone))) => alone.fault.is_some(),
            (None, Ok(Tried::Ran(_))) => true,
            _ => false,
        };
        if is_as_bad { alone.text(&variant.core()) } else { self.scene.text(&variant.core()) }
    }

    fn shade(&self, spec: &CoreSpec) -> Result<Ran, BenchError> {
        let bench = Bench::new(&self.frame, spec, "core")?;
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ())?;
        let (errors, bound) = (&outcome.comparison.errors, bench.design.error_bound());
        let fault = self.fault(&bench, &outcome, bound);
        let worst = outcome.comparison.worst_pixel.map_or(Place { span: 0, pixel: 0 }, |w| Place { span: w.span, pixel: w.pixel });
        Ok(Ran {
            pixels: outcome.pixels,
            errors: [&errors.total, &errors.method, &errors.quantisation].map(|figures| figures.max_lsb),
            bound,
            worst,
            fault,
        })
    }

    /// What is wanted everywhere, and then what is wanted here.
    fn fault(&self, bench: &Bench, outcome: &Outcome, bound: f64) -> Option<Fault> {
        let shaded = Shaded { spec: bench.spec, frame: &self.frame, outcome };
        disagreement(bench, outcome)
            .or_else(|| {
                first_pixel(&shaded, &|method, exact, _| !(is_shade(method) && is_shade(exact)))
                    .map(at("shades that are no number from 0 to 255"))
            })
            .or_else(|| {
                let beyond = |method: f64, _, code: f64| (code - method).abs() > bound;
                let largest = outcome.comparison.errors.quantisation.max_lsb;
                (largest > bound)
                    .then(|| first_pixel(&shaded, &beyond))
                    .flatten()
                    .map(at(&format!("an error of {largest:.3} LSB, beyond the proven bound of {bound:.3}")))
            })
            .or_else(|| (self.want)(&shaded).map(at("what is wanted does not happen")))
    }
}

/// A core that gave nothing.
fn broken(what: String) -> Ran {
    let place = Place { span: 0, pixel: 0 };
    Ran { pixels: 0, errors: [0.0; 3], bound: 0.0, worst: place, fault: Some(at(&what)(place)) }
}

fn at(what: &str) -> impl FnOnce(Place) -> Fault {
    let what = what.to_owned();
    move |place| Fault { what, span: place.span, pixel: place.pixel }
}

/// Pixels that are not the model's, clocks without them, and facts that do not hold.
fn disagreement(bench: &Bench, outcome: &Outcome) -> Option<Fault> {
    if let Some(wrong) = &outcome.comparison.first_mismatch {
        let what = format!("the code {:?}, and the bit-true model has {:?}", wrong.simulated, wrong.expected);
        return Some(Fault { what, span: wrong.span, pixel: wrong.pixel });
    }
    if let Some(clock) = outcome.wrong_clocks.first() {
        return Some(at(&format!("a pixel that comes or fails to come in clock {clock}"))(pixel_of(bench, *clock)));
    }
    outcome.violation.as_ref().map(|broken| at(&broken.in_words())(pixel_of(bench, broken.clock)))
}

/// The pixel that leaves in a clock, or the last before.
fn pixel_of(bench: &Bench, clock: u64) -> Place {
    let mut left = clock.saturating_sub(u64::from(bench.design.latency()));
    let interval = u64::from(bench.design.interval);
    for (span, clocks) in bench.frame.spans.iter().map(|span| u64::from(span.length) * interval).enumerate() {
        match left.checked_sub(clocks) {
            Some(rest) => left = rest,
            // Less than a span's length.
            None => return Place { span, pixel: (left / interval) as u32 },
        }
    }
    Place { span: bench.frame.spans.len().saturating_sub(1), pixel: 0 }
}

fn is_shade(lsb: f64) -> bool {
    (0.0..=255.0).contains(&lsb)
}

/// The first pixel of which `is_bad` says so in any channel, of the method, exact shading and the code.
fn first_pixel(shaded: &Shaded, is_bad: &dyn Fn(f64, f64, f64) -> bool) -> Option<Place> {
    let image = &shaded.outcome.simulated;
    shaded.frame.spans.iter().enumerate().find_map(|(number, span)| {
        let (method, exact) = (MethodSpan::new(shaded.spec, shaded.frame, span), PhongSpan::new(shaded.frame, span));
        let bad = |&i: &u32| {
            let code = image.pixels[(span.y * image.width + span.x + i) as usize];
            let (method, exact) = (method.pixel(i), exact.pixel(i));
            (0..3).any(|c| is_bad(method[c], exact[c], f64::from(code[c])))
        };
        (0..span.length).find(bad).map(|pixel| Place { span: number, pixel })
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_scene::Method;

    use super::super::scene::{RawSpan, matt};
    use super::*;

    /// What is not wanted is found where it is, and its scene file has its span alone, with the same core.
    #[test]
    fn a_fault_is_found_and_made_small() {
        let span = |normal| RawSpan::between([normal; 2], 3, matt());
        let scene = SpanScene::new(&[DVec3::Z], vec![span(DVec3::Z), span(DVec3::X), span(DVec3::Z)]);
        let case = Case::wanting(scene, |pixel| pixel.code() == 255);
        let (prepared, variant) = (Prepared::new(&case).expect("it is a scene"), Variant::default_of(Method::Phong));
        let Tried::Ran(ran) = prepared.run(&variant, &mut Vec::new()) else { panic!("phong shades it") };
        assert_eq!(ran.fault.as_ref().map(|fault| (fault.span, fault.pixel)), Some((1, 0)));
        let text = prepared.reproducer(&variant, &ran);
        let loaded = parse("reproducer.toml", text).expect("it is a scene");
        assert_eq!((loaded.frame.spans.len(), loaded.frame.triangles[0].normals[0]), (1, DVec3::X));
        assert_eq!(loaded.core_spec(None).expect("phong shades it").method(), Method::Phong);
    }

    /// The frame is the one of the file, to the last bit.
    #[test]
    fn scenes_are_read_as_they_are_written() {
        let mut draw = super::super::draw::Draw::new(5, 0);
        let spans: Vec<RawSpan> = (0..50).map(|_| RawSpan::between(draw.ends(100.0, 80.0), draw.length(8192), matt())).collect();
        let case = Case::new(SpanScene::new(&[DVec3::Z], spans.clone()));
        let prepared = Prepared::new(&case).expect("it is a scene");
        for (triangle, span) in prepared.frame.triangles.iter().zip(&spans) {
            assert_eq!(triangle.normals, span.normals);
        }
    }
}
