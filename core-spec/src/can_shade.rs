//! What a core can shade, in words.
use crate::core_input::{CoreInput, InputRole};
use crate::core_spec::CoreSpec;
use crate::specialisation::Given;

/// How much of what its ports could take is left to some inputs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Freedom {
    /// Whatever the ports take.
    All,
    /// Less than that, or the same as others.
    Some,
    /// One value each.
    None,
}

impl CoreSpec {
    /// What it can shade: surfaces, lights, materials. Whether it can shade a certain frame says
    /// [`CoreSpec::fit_to`].
    pub fn can_shade(&self) -> String {
        [self.surfaces(), self.lights(), self.materials()].join("; ")
    }

    fn surfaces(&self) -> String {
        let spans = format!("spans of up to {} pixels", self.parameters.longest_span);
        match self.freedom(|input| input.meaning.role == InputRole::Surface) {
            Freedom::All => format!("any triangle mesh in {spans}"),
            Freedom::Some | Freedom::None => {
                format!("surfaces within the ranges of what it was made for, in {spans}")
            }
        }
    }

    fn lights(&self) -> String {
        let (infinity, places) =
            (self.parameters.lights_at_infinity(), self.parameters.local_lights.len());
        let at_infinity = match (infinity, self.freedom(tells_of_a_light)) {
            (0, _) => None,
            (1, Freedom::All) => Some("one directional light anywhere".to_owned()),
            (count, Freedom::All) => Some(format!("{count} directional lights anywhere")),
            (1, Freedom::Some) => {
                Some("one directional light within the ranges of what it was made for".to_owned())
            }
            (count, Freedom::Some) => Some(format!(
                "{count} directional lights within the ranges of what it was made for"
            )),
            (1, Freedom::None) => {
                Some("one directional light from where it was made for".to_owned())
            }
            (count, Freedom::None) => {
                Some(format!("{count} directional lights from where it was made for"))
            }
        };
        let at_places = (places > 0).then(|| format!("{places} at places"));
        at_infinity.into_iter().chain(at_places).collect::<Vec<_>>().join(" and ")
    }

    fn materials(&self) -> String {
        let largest = self.parameters.largest_shininess;
        let exponents = match self.freedom(|input| input.meaning.role == InputRole::Exponent) {
            Freedom::None => format!("n = {largest}"),
            Freedom::All | Freedom::Some => format!("n up to {largest}"),
        };
        let colours = match self.freedom(is_a_colour) {
            Freedom::All => "any colours".to_owned(),
            Freedom::Some => "colours within the ranges of what it was made for".to_owned(),
            Freedom::None => "the colours it was made for".to_owned(),
        };
        format!("{exponents}, {colours}")
    }

    /// The freedom of some inputs; all where there are none.
    fn freedom(&self, are_asked: impl Fn(&CoreInput) -> bool) -> Freedom {
        let inputs = self.method.core_inputs(&self.parameters);
        let asked = inputs.iter().filter(|input| are_asked(input));
        let given: Vec<Option<&Given>> =
            asked.map(|input| self.specialisation.given(&input.port.name)).collect();
        let is_fixed = |given: &Option<&Given>| match given {
            Some(Given::Between([low, high])) => low == high,
            Some(Given::SameAs(_)) => true,
            None => false,
        };
        if given.iter().all(Option::is_none) {
            Freedom::All
        } else if given.iter().all(is_fixed) {
            Freedom::None
        } else {
            Freedom::Some
        }
    }
}

/// Whether an input depends on where a light is.
fn tells_of_a_light(input: &CoreInput) -> bool {
    match input.meaning.role {
        InputRole::Light => true,
        InputRole::Surface => input.is_of_a_light(),
        _ => false,
    }
}

fn is_a_colour(input: &CoreInput) -> bool {
    matches!(input.meaning.role, InputRole::Ambient | InputRole::Diffuse | InputRole::Specular)
}
