//! `slerp`, bit for bit [lecture, eq. 4.7, 4.9 to 4.12; METHODS.md A10, A11; `docs/arithmetic/slerp.md`].
use std::cell::RefCell;

use specula_scene::Format;
use specula_scene::spec::slerp::{SlerpFormats, SlerpInputs, SlerpLight, SlerpSpec};
use specula_scene::spec::{CoreSpec, InputPort};

use super::colour::{Colour, sum_format};
use super::course::Course;
use super::method::{Method, Values};
use super::number::{Wide, round_to};
use super::observer::{Observer, OfLight, narrow};
use super::packet::PacketError;
use super::raised::Raised;

/// The method in one core's formats.
pub(super) struct Slerp {
    power: Raised,
    formats: SlerpFormats,
    colour: Format,
    ports: SlerpInputs<InputPort>,
}

/// A packet, and what the rotation has made of it so far.
pub(super) struct Turning {
    inputs: SlerpInputs<Wide>,
    /// c and s of the pixels from the first on, as many as have been asked for.
    states: RefCell<Vec<[Wide; 2]>>,
}

impl Slerp {
    pub fn new(core: &CoreSpec, slerp: &SlerpSpec) -> Slerp {
        Slerp {
            power: Raised::new(core, slerp.power_unit()),
            formats: slerp.formats.clone(),
            colour: sum_format(core, slerp.formats.diffuse, slerp.power_unit().format()),
            ports: slerp.inputs(core),
        }
    }
}

impl Method for Slerp {
    type Inputs = Turning;

    fn read(&self, mut values: Values<'_>) -> Turning {
        let inputs = self.ports.map(|port| values.next(port));
        Turning { inputs, states: RefCell::new(vec![[Wide::ONE, Wide::ZERO]]) }
    }

    /// A turn that stretches would leave every range: its squares add up to 1 but for the host's rounding.
    fn check(&self, Turning { inputs, .. }: &Turning, _: Course) -> Result<(), PacketError> {
        let length = inputs.turn_cosine * inputs.turn_cosine + inputs.turn_sine * inputs.turn_sine;
        let longest = Wide::ONE + (Wide::ONE >> (self.formats.turn.fraction_bits - 1));
        if length <= longest { Ok(()) } else { Err(PacketError::Turn) }
    }

    fn pixel(&self, turning: &Turning, i: u32, observer: &mut impl Observer) -> [u8; 3] {
        let (f, inputs) = (&self.formats, &turning.inputs);
        let [cosine, sine] = self.state(turning, i);
        observer.see(format_args!("state_cosine"), cosine, f.state);
        observer.see(format_args!("state_sine"), sine, f.state);
        let c = narrow(observer, format_args!("weight_cosine"), cosine, f.weight);
        let s = narrow(observer, format_args!("weight_sine"), sine, f.weight);
        let n_dot_v = narrow(observer, format_args!("n_dot_v"), c * inputs.view_start + s * inputs.view_across, f.cosine);
        let correction = narrow(observer, format_args!("correction"), Wide::from_num(2) - (c * c + s * s), f.cosine);
        let corrected = narrow(observer, format_args!("corrected"), n_dot_v * correction, f.cosine);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let n_dot_l = c * light.light_start + s * light.light_across;
            let n_dot_l = narrow(&mut observer, format_args!("n_dot_l"), n_dot_l, f.cosine);
            colour.add(&light.diffuse, self.diffuse(n_dot_l, &mut observer));
            let base = self.base(n_dot_l, corrected, light, &mut observer);
            colour.add(&light.specular, self.power.of(&mut observer, base, inputs.exponent));
        }
        colour.code(self.colour, observer)
    }
}

impl Slerp {
    /// c and s after `i` turns.
    fn state(&self, turning: &Turning, i: u32) -> [Wide; 2] {
        let (cosine, sine) = (turning.inputs.turn_cosine, turning.inputs.turn_sine);
        let mut states = turning.states.borrow_mut();
        while states.len() <= i as usize {
            let [c, s] = states[states.len() - 1];
            let turned = [c * cosine - s * sine, s * cosine + c * sine];
            states.push(turned.map(|x| round_to(x, self.formats.state.fraction_bits)));
        }
        states[i as usize]
    }

    /// J, kept within 0 to 1.
    fn diffuse(&self, n_dot_l: Wide, observer: &mut impl Observer) -> Wide {
        let diffuse = round_to(n_dot_l, self.formats.diffuse.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        diffuse
    }

    /// 2 J K - L·V, kept within 0 to 1.
    fn base(&self, n_dot_l: Wide, n_dot_v: Wide, light: &SlerpLight<Wide>, observer: &mut impl Observer) -> Wide {
        let base = n_dot_l * n_dot_v * 2 - light.light_dot_view;
        let base = round_to(base, self.formats.base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("base"), base, self.formats.base);
        base
    }
}
