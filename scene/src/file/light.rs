//! Lights in a scene file.
use glam::DVec3;
use toml::Spanned;

use super::values::{Integer, Number, Vector};
use super::{SourceFile, check, raw};
use crate::attenuation::Attenuation;
use crate::error::SceneError;
use crate::limits::LARGEST_SHININESS;
use crate::picture::{Light, LightSource, LightSpace};

/// The exponent of a spot whose table has none.
const EXPONENT: u32 = 16;

#[derive(Clone, Copy)]
enum Kind {
    Directional,
    Point,
    Spot,
}

/// A `[[light]]`.
pub(super) fn light(source: &SourceFile, given: &Spanned<raw::Light>) -> Result<Light, SceneError> {
    let raw = given.get_ref();
    let kinds = [("directional", Kind::Directional), ("point", Kind::Point), ("spot", Kind::Spot)];
    let kind = check::word(source, "kind", raw.kind.as_ref(), &kinds)?.unwrap_or(Kind::Directional);
    let spaces = [("world", LightSpace::World), ("view", LightSpace::View)];
    Ok(Light {
        source: source_of(&Keys { source, given }, kind)?,
        space: check::word(source, "space", raw.space.as_ref(), &spaces)?
            .unwrap_or(LightSpace::World),
        colour: check::colour(source, "colour", raw.colour.as_ref(), 0.0..=1.0, [1.0; 3])?,
    })
}

fn source_of(keys: &Keys, kind: Kind) -> Result<LightSource, SceneError> {
    let raw = keys.given.get_ref();
    match kind {
        Kind::Directional => {
            keys.none_of(
                "directional",
                &[
                    ("position", span(&raw.position)),
                    ("target", span(&raw.target)),
                    ("exponent", span(&raw.exponent)),
                    ("attenuation", span(&raw.attenuation)),
                ],
            )?;
            Ok(LightSource::Directional {
                direction: check::direction(
                    keys.source,
                    "direction",
                    keys.needed("direction", &raw.direction)?,
                )?,
            })
        }
        Kind::Point => {
            keys.none_of(
                "point",
                &[
                    ("direction", span(&raw.direction)),
                    ("target", span(&raw.target)),
                    ("exponent", span(&raw.exponent)),
                ],
            )?;
            Ok(LightSource::Point { position: keys.position()?, attenuation: keys.attenuation()? })
        }
        Kind::Spot => {
            keys.none_of("spot", &[("direction", span(&raw.direction))])?;
            let position = keys.position()?;
            let target = keys.needed("target", &raw.target)?;
            let axis = check::vector(keys.source, "target", target)? - position;
            if axis == DVec3::ZERO {
                return Err(keys.source.error(
                    target.span(),
                    "`target` is at the light's `position`",
                    "move it away from `position`",
                ));
            }
            let exponent = |given: &Spanned<Integer>| {
                check::integer(keys.source, "exponent", given, 1..=LARGEST_SHININESS)
            };
            Ok(LightSource::Spot {
                position,
                axis,
                exponent: raw.exponent.as_ref().map_or(Ok(EXPONENT), exponent)?,
                attenuation: keys.attenuation()?,
            })
        }
    }
}

/// The keys of one light.
struct Keys<'a> {
    source: &'a SourceFile,
    given: &'a Spanned<raw::Light>,
}

impl Keys<'_> {
    fn position(&self) -> Result<DVec3, SceneError> {
        check::vector(
            self.source,
            "position",
            self.needed("position", &self.given.get_ref().position)?,
        )
    }

    /// How the light becomes weaker with distance, if it does.
    fn attenuation(&self) -> Result<Option<Attenuation>, SceneError> {
        let Some(given) = &self.given.get_ref().attenuation else { return Ok(None) };
        let raw = given.get_ref();
        let part = |name: &str, part: &Option<Spanned<Number>>| match part {
            Some(part) => check::nonnegative(self.source, name, part),
            None => Ok(0.0),
        };
        let attenuation = Attenuation {
            constant: part("constant", &raw.constant)?,
            linear: part("linear", &raw.linear)?,
            quadratic: part("quadratic", &raw.quadratic)?,
        };
        let Attenuation { constant, linear, quadratic } = attenuation;
        if constant + linear + quadratic > 0.0 {
            return Ok(Some(attenuation));
        }
        Err(self.source.error(
            given.span(),
            "`attenuation` is 0 and would divide by nothing",
            "give `constant`, `linear` or `quadratic`, as in { constant = 1, quadratic = 0.1 }; \
             without `attenuation` the light does not become weaker",
        ))
    }

    fn needed<'a>(
        &self,
        name: &str,
        value: &'a Option<Spanned<Vector>>,
    ) -> Result<&'a Spanned<Vector>, SceneError> {
        let help = "a directional light has a `direction`, a point light a `position`, a spot a `position` and a `target`";
        value.as_ref().ok_or_else(|| {
            self.source.error(self.given.span(), format!("the light has no `{name}`"), help)
        })
    }

    fn none_of(
        &self,
        kind: &str,
        others: &[(&str, Option<std::ops::Range<usize>>)],
    ) -> Result<(), SceneError> {
        match others.iter().find_map(|(name, span)| span.clone().map(|span| (name, span))) {
            Some((name, span)) => {
                let problem = format!("a {kind} light has no `{name}`");
                Err(self.source.error(
                    span,
                    problem,
                    "leave it out, or change `kind` to \"directional\", \"point\" or \"spot\"",
                ))
            }
            None => Ok(()),
        }
    }
}

fn span<T>(value: &Option<Spanned<T>>) -> Option<std::ops::Range<usize>> {
    value.as_ref().map(Spanned::span)
}
