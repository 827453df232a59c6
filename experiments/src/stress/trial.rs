//! The trial of one scene with one core.
use std::panic::{AssertUnwindSafe, catch_unwind};

use specula_scene::{Frame, Needs, SceneError, parse};
use specula_spec::CoreSpec;

use super::measured::Measurements;
use super::requirement::{Requirement, RowVerdict};
use super::row::{Case, Figure, PixelPlace, RowRequirement};
use super::scene::SpanScene;
use super::variant::Variant;
use specula_testbench::{Bench, BenchError, EngineKind};

/// The result of a trial.
#[derive(Clone, Debug)]
pub enum Tried {
    /// The core is the same as with options that were tried before.
    Again,
    /// There is no such core, for a reason that the user would be told.
    Refused(String),
    /// The core ran, or failed with this message.
    Ran(Result<Box<Measurements>, String>),
}

/// A case, prepared for trials with methods.
pub struct Prepared<'a> {
    scene: &'a SpanScene,
    requirements: &'a [RowRequirement],
    figure: Option<Figure>,
    frame: Frame,
    needs: Needs,
}

impl<'a> Prepared<'a> {
    /// Parses the scene from its own text, so that the scene tried is the one that the file
    /// describes.
    ///
    /// # Errors
    /// [`SceneError`] if the text is not a scene.
    pub fn new(case: &'a Case) -> Result<Prepared<'a>, SceneError> {
        Prepared::of(&case.scene, &case.requirements, case.figure)
    }

    fn of(
        scene: &'a SpanScene,
        requirements: &'a [RowRequirement],
        figure: Option<Figure>,
    ) -> Result<Prepared<'a>, SceneError> {
        let frame = parse("stress.toml", scene.text(""))?.frame;
        let needs = Needs::of(&frame);
        Ok(Prepared { scene, requirements, figure, frame, needs })
    }

    /// Tries a variant, unless its core is one of `before`, to which it is added.
    pub fn run(&self, variant: &Variant, before: &mut Vec<CoreSpec>) -> Tried {
        let spec = match variant.core_spec(&self.needs) {
            Ok(spec) if before.contains(&spec) => return Tried::Again,
            Ok(spec) => spec,
            Err(error) => return Tried::Refused(error.to_string()),
        };
        before.push(spec.clone());
        // A panic is a fault, and must not hide those of other rows.
        match catch_unwind(AssertUnwindSafe(|| self.shade(&spec))) {
            Ok(Ok(measured)) => Tried::Ran(Ok(Box::new(measured))),
            Ok(Err(BenchError::TooWide(error))) => Tried::Refused(error.to_string()),
            Ok(Err(error)) => Tried::Ran(Err(error.to_string())),
            Err(_) => Tried::Ran(Err("a panic".to_owned())),
        }
    }

    /// The scene file that shows the fault or the error at `place`: only with its span if that is
    /// enough.
    pub fn reproducer(&self, variant: &Variant, place: PixelPlace, is_fault: bool) -> String {
        let alone = self.scene.only(place.span);
        let is_as_bad = match Prepared::of(&alone, self.requirements, self.figure)
            .map(|alone| alone.run(variant, &mut Vec::new()))
        {
            Ok(Tried::Ran(alone)) => !is_fault || alone.map_or(true, |alone| has_fault(&alone)),
            _ => false,
        };
        if is_as_bad { alone.text(&variant.core()) } else { self.scene.text(&variant.core()) }
    }

    fn shade(&self, spec: &CoreSpec) -> Result<Measurements, BenchError> {
        let bench = Bench::new(&self.frame, spec, "core")?;
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ())?;
        let figure =
            self.figure.filter(|figure| (figure.applies_to)(spec)).map(|figure| figure.lsb);
        Ok(Measurements::new(&bench, &outcome, self.requirements, figure))
    }
}

fn has_fault(measured: &Measurements) -> bool {
    measured.asked().iter().any(|asked: &Requirement| asked.verdict() == RowVerdict::Fault)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_spec::{Method, SceneCore};

    use super::super::row::all;
    use super::super::scene::{RawSpan, matt};
    use super::*;

    /// A fault is found in its place, and its scene file has only that span, with the same core.
    #[test]
    fn a_fault_is_found_and_made_small() {
        let span = |normal| RawSpan::between([normal; 2], 3, matt());
        let scene =
            SpanScene::new(&[DVec3::Z], vec![span(DVec3::Z), span(DVec3::X), span(DVec3::Z)]);
        let case = Case::new(scene).requiring("white", all, |pixel| pixel.code() == 255);
        let (prepared, variant) =
            (Prepared::new(&case).expect("it is a scene"), Variant::default_of(Method::Phong));
        let Tried::Ran(Ok(measured)) = prepared.run(&variant, &mut Vec::new()) else {
            panic!("phong shades it")
        };
        let asked = measured.asked();
        let fault = asked.iter().find(|asked| !asked.holds()).expect("it is dark in the middle");
        assert_eq!(
            (fault.what.as_str(), fault.place),
            ("white", Some(PixelPlace { span: 1, pixel: 0 }))
        );
        let text = prepared.reproducer(&variant, PixelPlace { span: 1, pixel: 0 }, true);
        let loaded = parse("reproducer.toml", text).expect("it is a scene");
        assert_eq!((loaded.frame.spans.len(), loaded.frame.triangles[0].normals[0]), (1, DVec3::X));
        assert_eq!(loaded.core_spec(None).expect("phong shades it").method(), Method::Phong);
    }

    /// The frame that the file describes is the original one, to the last bit.
    #[test]
    fn scenes_are_read_as_they_are_written() {
        let mut draw = super::super::draw::Draw::new(5, 0);
        let spans: Vec<RawSpan> = (0..50)
            .map(|_| RawSpan::between(draw.ends(100.0, 80.0), draw.length(8192), matt()))
            .collect();
        let case = Case::new(SpanScene::new(&[DVec3::Z], spans.clone()));
        let prepared = Prepared::new(&case).expect("it is a scene");
        for (triangle, span) in prepared.frame.triangles.iter().zip(&spans) {
            assert_eq!(triangle.normals, span.normals);
        }
    }
}
