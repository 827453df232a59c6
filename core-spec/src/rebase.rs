//! A core that is changed as another one differs from a third.
use specula_datapath::Format;
use toml::Value;

use crate::core_spec::CoreSpec;
use crate::error::SpecError;

impl CoreSpec {
    /// This core for any scene, changed as `to` differs from `from`, all by one method: what is not
    /// the same in both is as in `to`, and a format has as many bits more or fewer. So a core whose
    /// formats were narrowed keeps that.
    ///
    /// # Errors
    /// [`SpecError`] if no such core can be built.
    pub fn rebased(&self, from: &CoreSpec, to: &CoreSpec) -> Result<CoreSpec, SpecError> {
        let fail = |message: String| SpecError::Core { message };
        let value = |spec: &CoreSpec| {
            Value::try_from(spec.general()).map_err(|error| fail(error.to_string()))
        };
        let rebased = rebased(value(self)?, &value(from)?, &value(to)?);
        let spec: CoreSpec = rebased
            .try_into()
            .map_err(|error: toml::de::Error| fail(error.message().to_owned()))?;
        spec.check()?;
        Ok(spec)
    }
}

fn rebased(own: Value, from: &Value, to: &Value) -> Value {
    match (own, from, to) {
        (own, from, to) if from == to => own,
        (Value::Table(own), Value::Table(from), Value::Table(to)) => {
            let entry = |(key, own): (String, Value)| {
                let value = match (from.get(&key), to.get(&key)) {
                    (Some(from), Some(to)) => rebased(own, from, to),
                    _ => own,
                };
                (key, value)
            };
            Value::Table(own.into_iter().map(entry).collect())
        }
        (own, from, to) => wider(&own, from, to).unwrap_or_else(|| to.clone()),
    }
}

/// A format with as many bits more as `to` has more than `from`; `None` if they are no formats, or
/// a bit count would be negative.
fn wider(own: &Value, from: &Value, to: &Value) -> Option<Value> {
    let format = |value: &Value| value.as_str()?.parse::<Format>().ok();
    let (own, from, to) = (format(own)?, format(from)?, format(to)?);
    let bits = |own: u32, from: u32, to: u32| (own + to).checked_sub(from);
    let wider = Format {
        signed: to.signed,
        integer_bits: bits(own.integer_bits, from.integer_bits, to.integer_bits)?,
        fraction_bits: bits(own.fraction_bits, from.fraction_bits, to.fraction_bits)?,
    };
    Some(wider.to_string().into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Method, SceneCore};
    use specula_scene::limits::LONGEST_SPAN;
    use specula_scene::{Needs, load};

    #[test]
    fn narrowed_formats_stay_narrowed_and_what_differs_is_changed() {
        let scene = load("teapot", Some((32, 24))).unwrap();
        let needs = Needs::of(&scene.frame);
        let of = |needs: &Needs| scene.core_for(needs, Some(Method::Hybrid)).unwrap();
        let from = of(&needs);
        let to = of(&Needs { longest_span: LONGEST_SPAN, uneven_shininess: Some(3), ..needs });
        assert_eq!(from.rebased(&from, &to), Ok(to.clone()));
        let base = |spec: &CoreSpec| {
            spec.narrowing_points().iter().find(|point| point.name == "base").unwrap().format
        };
        let narrow = Format { fraction_bits: base(&from).fraction_bits - 2, ..base(&from) };
        let rebased = from.with_formats(&[("base", narrow)]).unwrap().rebased(&from, &to).unwrap();
        assert_eq!((base(&rebased), rebased.parameters.longest_span), (narrow, LONGEST_SPAN));
        assert_eq!(rebased.with_formats(&[("base", base(&to))]), Ok(to));
    }
}
