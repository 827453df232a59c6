//! The `[sequence]` table of a scene file: how many frames there are, and what moves over them.
use glam::DVec3;
use toml::Spanned;

use super::values::{Integer, Number, OneOrMore, Vector};
use super::{SourceFile, check, raw};
use crate::SceneError;
use crate::picture::{Light, LightSource, Scene};
use crate::sequence::{Change, Keys, MOST_FRAMES, Motion, Steps, Subject};

/// How many frames a sequence has, and its motions.
#[derive(Clone)]
pub struct SequenceTable {
    pub frames: u32,
    pub motions: Vec<Motion>,
}

/// The `[sequence]` of a scene.
pub(super) fn sequence(
    source: &SourceFile,
    given: &Spanned<raw::Sequence>,
    scene: &Scene,
) -> Result<SequenceTable, SceneError> {
    let raw = given.get_ref();
    let frames = check::integer(source, "frames", &raw.frames, 1..=MOST_FRAMES)?;
    let mut motions = vec![];
    for motion in &raw.motion {
        let reader = MotionReader { source, given: motion, scene, frames };
        motions.extend(reader.motions()?);
    }
    Ok(SequenceTable { frames, motions })
}

/// A `[[sequence.motion]]` and what it refers to.
struct MotionReader<'a> {
    source: &'a SourceFile,
    given: &'a Spanned<raw::Motion>,
    scene: &'a Scene,
    frames: u32,
}

impl MotionReader<'_> {
    /// The same change for each subject that the table names.
    fn motions(&self) -> Result<Vec<Motion>, SceneError> {
        let change = self.change()?;
        let subjects = self.subjects()?;
        subjects.iter().try_for_each(|&subject| self.check(subject, &change))?;
        let motion = |&subject: &Subject| Motion { subject, change: change.clone() };
        Ok(subjects.iter().map(motion).collect())
    }

    fn subjects(&self) -> Result<Vec<Subject>, SceneError> {
        let of = &self.given.get_ref().of;
        let words: Vec<&str> = of.get_ref().split_whitespace().collect();
        let (objects, lights) = (self.scene.objects.len(), self.scene.lights.len());
        match words[..] {
            ["camera"] => Ok(vec![Subject::Camera]),
            ["objects"] => Ok((0..objects).map(Subject::Object).collect()),
            ["lights"] => Ok((0..lights).map(Subject::Light).collect()),
            ["object", number] => Ok(vec![Subject::Object(self.index(number, "object", objects)?)]),
            ["light", number] => Ok(vec![Subject::Light(self.index(number, "light", lights)?)]),
            _ => {
                let problem =
                    format!("there is nothing called \"{}\" that could move", of.get_ref());
                let help =
                    "`of` is \"camera\", \"objects\", \"object 1\", \"lights\" or \"light 1\"";
                Err(self.source.error(of.span(), problem, help))
            }
        }
    }

    /// The index of a thing by its number, which counts from 1 in the order of the file.
    fn index(&self, number: &str, kind: &str, count: usize) -> Result<usize, SceneError> {
        let index = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
        index.filter(|&index| index < count).ok_or_else(|| {
            let problem = format!("there is no {kind} {number}");
            let help =
                format!("the scene has {kind} 1 to {count}, counted in the order of the file");
            self.source.error(self.given.get_ref().of.span(), problem, help)
        })
    }

    fn change(&self) -> Result<Change, SceneError> {
        let raw = self.given.get_ref();
        let change = match (&raw.turn, &raw.orbit, &raw.translate) {
            (Some(turn), None, None) => Change::Turn {
                degrees: self.keys("turn", turn.span(), self.degrees("turn", turn)?)?,
                axis: self.axis()?,
            },
            (None, Some(orbit), None) => Change::Orbit {
                degrees: self.keys("orbit", orbit.span(), self.degrees("orbit", orbit)?)?,
                axis: self.axis()?,
                centre: raw
                    .centre
                    .as_ref()
                    .map(|centre| check::vector(self.source, "centre", centre))
                    .transpose()?,
            },
            (None, None, Some(way)) => {
                Change::Translate { way: self.keys("translate", way.span(), self.ways(way)?)? }
            }
            _ => {
                let problem = "a motion is one of `turn`, `orbit` and `translate`";
                let help = "give one of them in each `[[sequence.motion]]`: a thing may have several motions";
                return Err(self.source.error(self.given.span(), problem, help));
            }
        };
        self.no_strangers(&change)?;
        Ok(change)
    }

    /// Keys that this kind of change has no use for.
    fn no_strangers(&self, change: &Change) -> Result<(), SceneError> {
        let raw = self.given.get_ref();
        let (axis, centre) =
            (raw.axis.as_ref().map(Spanned::span), raw.centre.as_ref().map(Spanned::span));
        let stranger = match change {
            Change::Orbit { .. } => None,
            Change::Turn { .. } => centre.map(|at| ("centre", at)),
            Change::Translate { .. } => {
                axis.map(|at| ("axis", at)).or(centre.map(|at| ("centre", at)))
            }
        };
        let Some((key, at)) = stranger else { return Ok(()) };
        let help = "`axis` goes with `turn` and `orbit`, `centre` with `orbit`";
        Err(self.source.error(at, format!("this motion has no `{key}`"), help))
    }

    fn axis(&self) -> Result<DVec3, SceneError> {
        let Some(axis) = &self.given.get_ref().axis else { return Ok(DVec3::Y) };
        let axis = check::direction(self.source, "axis", axis)?;
        // The largest component is made 1 first, so that squares neither vanish nor overflow.
        Ok((axis / axis.abs().max_element()).normalize())
    }

    fn degrees(
        &self,
        name: &str,
        given: &Spanned<OneOrMore<Number>>,
    ) -> Result<Vec<f64>, SceneError> {
        let check = |number: &Number| {
            check::number(self.source, name, &Spanned::new(given.span(), *number))
        };
        given.get_ref().0.iter().map(check).collect()
    }

    fn ways(&self, given: &Spanned<OneOrMore<Vector>>) -> Result<Vec<DVec3>, SceneError> {
        let check = |vector: &Vector| {
            check::vector(self.source, "translate", &Spanned::new(given.span(), *vector))
        };
        given.get_ref().0.iter().map(check).collect()
    }

    /// Values at key frames: those of `at`, or else from nothing at the first frame to the only value
    /// where the frame after the last one would be, so that a full turn has no frame twice.
    fn keys<T>(
        &self,
        name: &str,
        at: std::ops::Range<usize>,
        values: Vec<T>,
    ) -> Result<Keys<T>, SceneError>
    where
        T: Copy
            + Default
            + std::ops::Add<Output = T>
            + std::ops::Sub<Output = T>
            + std::ops::Mul<f64, Output = T>,
    {
        let steps = [("linear", Steps::Linear), ("smooth", Steps::Smooth)];
        let steps = check::word(self.source, "steps", self.given.get_ref().steps.as_ref(), &steps)?;
        let keys = match (&self.given.get_ref().at, &values[..]) {
            (None, &[value]) => vec![(0.0, T::default()), (f64::from(self.frames), value)],
            (Some(frames), values) if frames.get_ref().len() == values.len() => {
                let frames = frames.get_ref().iter().map(|&Integer(frame)| frame as f64);
                frames.zip(values.iter().copied()).collect()
            }
            _ => {
                let problem = format!("`{name}` has {} values", values.len());
                let help = "one value is reached at the end of the sequence; more go with `at`, the frame of each, as in at = [0, 24, 72]";
                return Err(self.source.error(at, problem, help));
            }
        };
        Keys::new(keys, steps.unwrap_or_default()).ok_or_else(|| {
            let at = self.given.get_ref().at.as_ref().map_or(at, Spanned::span);
            self.source.error(
                at,
                "key frames do not ascend",
                "`at` is a list of frames, the earliest first",
            )
        })
    }

    /// Whether a change makes sense for a subject.
    fn check(&self, subject: Subject, change: &Change) -> Result<(), SceneError> {
        let wrong =
            |problem: &str, help: &str| Err(self.source.error(self.given.span(), problem, help));
        match (subject, change) {
            (Subject::Camera, Change::Translate { .. }) if self.scene.camera.target.is_none() => {
                wrong(
                    "the camera frames the objects by itself and cannot be moved",
                    "give the camera a `target`",
                )
            }
            (Subject::Light(index), change) => match (&self.scene.lights[index], change) {
                (
                    Light { source: LightSource::Directional { .. }, .. },
                    Change::Translate { .. },
                ) => wrong("a directional light is at infinity and cannot be shifted", "`turn` it"),
                (Light { source: LightSource::Point { .. }, .. }, Change::Turn { .. }) => wrong(
                    "a point light shines in all directions alike, so that turning it changes nothing",
                    "let it `orbit` a `centre`, or `translate` it",
                ),
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }
}
