//! A core for some frames alone, which leaves out what their spans do not need.
use specula_datapath::InputPort;
use specula_datapath::format::power_of_two;

use crate::core_spec::CoreSpec;
use crate::frames::Frames;
use crate::given_values::GivenValues;
use crate::specialisation::{Given, Specialisation};

impl CoreSpec {
    /// The same core for a frame alone, or for several: it gives the same codes, and need not take
    /// inputs that these frames do not have.
    pub fn specialised<'a>(&self, frames: impl Into<Frames<'a>>) -> CoreSpec {
        let general = self.general();
        let ports = general.inputs();
        let values = GivenValues::of_frames(&general, &ports, frames.into());
        general.given(&ports, &values)
    }

    /// This general core, whose inputs have these ports, where they are given these values.
    pub(crate) fn given(self, ports: &[InputPort], values: &GivenValues) -> CoreSpec {
        let kept = self.specialisation.kept().clone();
        let inputs = self.method.core_inputs(&self.parameters);
        let is_free: Vec<bool> = inputs.iter().map(|input| kept.frees(input)).collect();
        let given = ports
            .iter()
            .enumerate()
            .filter_map(|(i, port)| Some((port.name.clone(), values.given(i, ports, &is_free)?)));
        CoreSpec { specialisation: Specialisation::new(given, kept), ..self }
    }

    /// As [`CoreSpec::specialised`], where another core for these frames alone is at hand,
    /// `special`. Spans are set up only if this core's inputs are not given what that one's are.
    pub fn specialised_as<'a>(
        &self,
        special: &CoreSpec,
        frames: impl Into<Frames<'a>>,
    ) -> CoreSpec {
        let general = self.general();
        if general.is_given_what(&special.general()) {
            CoreSpec { specialisation: special.specialisation.clone(), ..general }
        } else {
            general.specialised(frames)
        }
    }

    /// About what [`CoreSpec::specialised`] gives, without setting up any span: what inputs are
    /// given is converted from `special`, a core with other formats for the same frame. A range is
    /// wider by up to one unit in the last place on either side, and an input that is always the
    /// same stays so.
    pub fn nearly_specialised_as(&self, special: &CoreSpec) -> CoreSpec {
        let general = self.general();
        let (own, others) = (general.inputs(), special.general().inputs());
        let converted = own.iter().filter_map(|port| {
            let given = converted_given(port, &own, &others, &special.specialisation)?;
            Some((port.name.clone(), given))
        });
        let kept = general.specialisation.kept().clone();
        CoreSpec { specialisation: Specialisation::new(converted, kept), ..general }
    }

    /// Whether a host gives both cores the same raw values in every frame: set-up rests on ports
    /// and options, and not on formats of values within the core.
    pub(crate) fn is_given_what(&self, other: &CoreSpec) -> bool {
        self.inputs() == other.inputs()
            && self.method.with_formats_of(&other.method).as_ref() == Some(&other.method)
    }
}

/// What a port is given, from what the port of the same name among `others` is; none if that is all
/// that its format allows.
fn converted_given(
    port: &InputPort,
    own: &[InputPort],
    others: &[InputPort],
    given: &Specialisation,
) -> Option<Given> {
    let named = |ports: &'_ [InputPort], name: &str| ports.iter().position(|p| p.name == name);
    match given.given(&port.name)? {
        &Given::Between([low, high]) => {
            let from = &others[named(others, &port.name)?];
            let finer = i64::from(port.format.fraction_bits) - i64::from(from.format.fraction_bits);
            let half = if finer == 0 || low == high { 0.0 } else { 0.5 };
            let scale = power_of_two(finer);
            let [low, high] = if low == high {
                [(low as f64 * scale).round(); 2]
            } else {
                [((low as f64 - half) * scale).floor(), ((high as f64 + half) * scale).ceil()]
            };
            let within = |raw: f64| (raw as i64).clamp(port.range.0, port.range.1);
            let range = (within(low), within(high));
            (range != port.range).then_some(Given::Between([range.0, range.1]))
        }
        Given::SameAs(twin) => {
            let other = &own[named(own, twin)?];
            if other.format == port.format {
                return Some(Given::SameAs(twin.clone()));
            }
            // The twin is a twin of no other: it has the range of both.
            let as_twin = InputPort { name: twin.clone(), ..port.clone() };
            converted_given(&as_twin, own, others, given)
        }
    }
}

#[cfg(test)]
mod tests {
    use specula_scene::load;

    use crate::{CoreSpec, Given, Method, SceneCore};

    /// Smallest and largest raw value that an input may be given.
    fn range(spec: &CoreSpec, input: usize) -> (i64, i64) {
        spec.inputs()[input].range
    }

    /// Converted ranges contain those of spans that were set up, but for what rounding in two formats
    /// makes of constants.
    #[test]
    fn converted_ranges_are_near_those_of_spans() {
        let mut compared = 0;
        for name in ["teapot", "lamps"] {
            let scene = load(name, Some((48, 36))).unwrap();
            for special in Method::ALL.map(|method| scene.core_spec(Some(method)).unwrap()) {
                assert_eq!(special.nearly_specialised_as(&special), special, "{name}");
                for added in [-2, 1, 2] {
                    let general = special.finer(added, &[]).unwrap();
                    let near = general.nearly_specialised_as(&special);
                    let exact = general.specialised(&scene.frame);
                    assert_eq!(near.check(), Ok(()));
                    let most = 1 + (1 << added.max(0));
                    for (input, port) in near.inputs().iter().enumerate() {
                        let (own, other) = (range(&near, input), range(&exact, input));
                        let is_twin = |spec: &CoreSpec| {
                            matches!(spec.specialisation.given(&port.name), Some(Given::SameAs(_)))
                        };
                        if is_twin(&near) || is_twin(&exact) {
                            continue;
                        }
                        let name = format!("{} {} {added}", special.method().name(), port.name);
                        assert!(own.0 <= other.0 + most && other.1 - most <= own.1, "{name}");
                        assert!((own.0 - other.0).abs() <= 2 * most, "{name}: {own:?} {other:?}");
                        assert!((own.1 - other.1).abs() <= 2 * most, "{name}: {own:?} {other:?}");
                        compared += 1;
                    }
                }
            }
        }
        assert!(compared > 500, "{compared}");
    }
}
