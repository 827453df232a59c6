//! Whether a core that is there can shade a frame, and if not, what it lacks.
use specula_datapath::InputPort;
use specula_scene::frame::{Colour, DirectionalLight, EYE, Frame};
use specula_scene::needs::{LocalKind, Needs};

use crate::core_spec::CoreSpec;
use crate::error::SpecError;
use crate::given_values::GivenValues;
use crate::parameters::{CoreParameters, FULL_SCALE};
use crate::shading_method::Viewpoint;
use crate::specialisation::Given;

/// Of a light that is not there.
const DARK: Colour = [0.0; 3];

/// A core and a frame that fit each other.
#[derive(Clone, Debug)]
pub struct FittedCore {
    /// The frame, with dark lights where the core has more than the scene.
    pub frame: Frame,
    /// The very same hardware. What is said of the frames that it is for, on which error bounds
    /// alone rest, is said of this one too.
    pub spec: CoreSpec,
}

impl CoreSpec {
    /// This core for a frame that it was not made for.
    ///
    /// # Errors
    /// [`SpecError`] says what the frame needs and the core lacks.
    pub fn fit_to(&self, frame: &Frame) -> Result<FittedCore, SpecError> {
        let needs = Needs::of(frame);
        self.parameters.check_lights(&needs)?;
        self.check_attenuation(&needs)?;
        self.parameters.check_sizes(&needs)?;
        self.method.shading().check_compatible(&needs)?;
        let mut frame = frame.clone();
        let dark = DirectionalLight { direction: EYE, colour: DARK };
        frame.lights.resize(self.parameters.lights_at_infinity(), dark);
        self.check_inputs(&frame)?;
        let view_cosine = self.least_view_cosine(&needs);
        let parameters = self.parameters.clone().with_bounds_for(&needs, view_cosine);
        Ok(FittedCore { frame, spec: CoreSpec { parameters, ..self.clone() } })
    }

    /// The same core, of which is said too what is said of another one with the same hardware.
    pub fn with_bounds_of(self, other: &CoreSpec) -> CoreSpec {
        let parameters = self.parameters.with_bounds_of(&other.parameters);
        CoreSpec { parameters, ..self }
    }

    /// Lights that become weaker with distance, where pixels have to know.
    fn check_attenuation(&self, needs: &Needs) -> Result<(), SpecError> {
        let own = self.parameters.attenuation.iter().flat_map(|attenuation| &attenuation.lights);
        let own: Vec<usize> = own.copied().collect();
        let serves = self.places_seen_from() == Viewpoint::Vertex
            || needs.attenuated_lights.iter().all(|light| own.contains(light));
        let named = |lights: &[usize]| match lights {
            [] => "none".to_owned(),
            lights => {
                lights.iter().map(|light| (light + 1).to_string()).collect::<Vec<_>>().join(", ")
            }
        };
        if serves {
            return Ok(());
        }
        lacks(
            format!("of its lights at places, these become weaker with distance: {}", named(&own)),
            format!("has such lights: {}", named(&needs.attenuated_lights)),
        )
    }

    /// Whether inputs are given what the core was built for.
    fn check_inputs(&self, frame: &Frame) -> Result<(), SpecError> {
        let general = self.general();
        let ports = general.inputs();
        let mut values = GivenValues::none(&ports);
        values.add_frame(&general, frame);
        let mut wrong = (0..ports.len())
            .filter_map(|input| Some((input, self.left_out(input, &ports, &values)?)));
        let Some((input, (has, needs))) = wrong.next() else { return Ok(()) };
        let (port, role) = (&ports[input], self.input_roles()[input]);
        let others = match wrong.count() {
            0 => String::new(),
            others => format!(", and {others} other inputs likewise"),
        };
        lacks(
            format!("{}: its input `{}` {has}", role.in_words(), port.name),
            format!("{needs}{others}"),
        )
    }

    /// What is known of an input and is not so over the frame.
    fn left_out(
        &self,
        input: usize,
        ports: &[InputPort],
        values: &GivenValues,
    ) -> Option<(String, String)> {
        let port = &ports[input];
        let (low, high) = values.range(input)?;
        let in_words = |low: i64, high: i64| match [low, high].map(|raw| port.format.value(raw)) {
            [low, high] if low == high => low.to_string(),
            [low, high] => format!("{low} to {high}"),
        };
        let given = in_words(low, high);
        match self.specialisation.given(&port.name)? {
            &Given::Between([lowest, highest]) if lowest <= low && high <= highest => None,
            &Given::Between([lowest, highest]) => {
                let kind = if lowest == highest {
                    "was left out, being always"
                } else {
                    "was narrowed to"
                };
                Some((format!("{kind} {}", in_words(lowest, highest)), format!("gives it {given}")))
            }
            Given::SameAs(twin) => {
                let is_twin = |&earlier: &usize| ports[earlier].name == *twin;
                let same = values.twins(input).iter().any(is_twin);
                (!same).then(|| {
                    (
                        format!("was left out, being always what `{twin}` is"),
                        format!("gives it {given}"),
                    )
                })
            }
        }
    }
}

impl CoreParameters {
    /// The same hardware, of which is said too what is so of a frame with these needs.
    fn with_bounds_for(self, needs: &Needs, view_cosine: f64) -> CoreParameters {
        CoreParameters {
            shortest_normal: self.shortest_normal.min(needs.shortest_normal),
            shortest_way: self.shortest_way.min(needs.shortest_way),
            shortest_unit_way: self.shortest_unit_way.min(needs.shortest_unit_way),
            shortest_halfway: self.shortest_halfway.min(needs.shortest_halfway),
            least_cone_cosine: self.least_cone_cosine.min(needs.least_cone_cosine),
            least_view_cosine: self.least_view_cosine.min(view_cosine),
            ..self
        }
    }

    /// The same hardware, of which is said too what is said of another.
    fn with_bounds_of(self, other: &CoreParameters) -> CoreParameters {
        CoreParameters {
            shortest_normal: self.shortest_normal.min(other.shortest_normal),
            shortest_way: self.shortest_way.min(other.shortest_way),
            shortest_unit_way: self.shortest_unit_way.min(other.shortest_unit_way),
            shortest_halfway: self.shortest_halfway.min(other.shortest_halfway),
            least_cone_cosine: self.least_cone_cosine.min(other.least_cone_cosine),
            least_view_cosine: self.least_view_cosine.min(other.least_view_cosine),
            ..self
        }
    }

    fn check_lights(&self, needs: &Needs) -> Result<(), SpecError> {
        let (here, there) = (self.lights_at_infinity(), needs.lights - needs.local_lights.len());
        if there > here {
            return lacks(format!("its lights at infinity are {here}"), format!("has {there}"));
        }
        let pairs = || self.local_lights.iter().zip(&needs.local_lights);
        let alike = self.local_lights.len() == needs.local_lights.len()
            && pairs().all(|(core, scene)| shades(*core, *scene));
        if !alike {
            let [has, needs] =
                [&self.local_lights, &needs.local_lights].map(|lights| in_words(lights));
            return lacks(format!("its lights at places are: {has}"), format!("has: {needs}"));
        }
        if needs.materials > 1 && !self.several_materials {
            let has = "its colours and exponents hold for a frame".to_owned();
            return lacks(has, format!("has {} materials", needs.materials));
        }
        let eye = |local: bool| if local { "at a place" } else { "at infinity" };
        if self.local_eye != needs.local_eye {
            return lacks(
                format!("its eye is {}", eye(self.local_eye)),
                format!("is seen from an eye {}", eye(needs.local_eye)),
            );
        }
        Ok(())
    }

    fn check_sizes(&self, needs: &Needs) -> Result<(), SpecError> {
        if needs.longest_span > self.longest_span {
            let has = format!("it takes spans of up to {} pixels", self.longest_span);
            return lacks(has, format!("has one of {}", needs.longest_span));
        }
        if needs.largest_shininess > self.largest_shininess {
            let has = format!("it takes exponents up to {}", self.largest_shininess);
            return lacks(has, format!("has a material with {}", needs.largest_shininess));
        }
        let (brightest, most) = (
            FULL_SCALE * needs.brightest_coefficient,
            self.coefficient.value(self.coefficient.max_raw()),
        );
        if brightest > most + self.coefficient.ulp() / 2.0 {
            return lacks(
                format!("its colours go up to {most} LSB"),
                format!("has one of {brightest:.1} LSB"),
            );
        }
        Ok(())
    }
}

/// Whether hardware for one kind of light shades with another.
fn shades(hardware: LocalKind, light: LocalKind) -> bool {
    match (hardware, light) {
        (LocalKind::Point, LocalKind::Point) => true,
        (LocalKind::Spot { exponent: largest }, LocalKind::Spot { exponent }) => {
            exponent <= largest
        }
        _ => false,
    }
}

fn in_words(lights: &[LocalKind]) -> String {
    let word = |light: &LocalKind| match light {
        LocalKind::Point => "a point".to_owned(),
        LocalKind::Spot { exponent } => format!("a spot with exponents up to {exponent}"),
    };
    if lights.is_empty() {
        "none".to_owned()
    } else {
        lights.iter().map(word).collect::<Vec<_>>().join(", ")
    }
}

fn lacks(has: String, needs: String) -> Result<(), SpecError> {
    Err(SpecError::Lacks { has, needs })
}
