//! A method with the inputs of one core: what all methods do alike.
use specula_spec::{
    CoreInputs, CoreParameters, Format, InputGroup, InputPort, LightInputs, Quadratic, SpanPacket,
};

use super::attenuation::Attenuation;
use super::colour::{Colour, sum_format};
use super::error::PacketError;
use super::method::{Inputs, Intensities, Method};
use super::number::{Wide, from_raw};
use super::observer::{Nobody, Notebook, Observation, Observer, OfLight, Sums};
use super::span_extent::SpanExtent;

/// A method, once it has read its packets itself.
pub(super) trait ShadeSpan: Send + Sync {
    fn shade(
        &self,
        packet: &SpanPacket,
        extent: SpanExtent,
        out: &mut Vec<[u8; 3]>,
    ) -> Result<(), PacketError>;

    fn sums(&self, packet: &SpanPacket, extent: SpanExtent) -> Result<Vec<[f64; 3]>, PacketError>;

    fn trace(
        &self,
        packet: &SpanPacket,
        extent: SpanExtent,
        i: u32,
    ) -> Result<Vec<Observation>, PacketError>;
}

/// A method, and the ports that its inputs come by.
pub(super) struct Shader<M, S, L> {
    method: M,
    ports: CoreInputs<S, L, InputPort>,
    /// What distance leaves of lights, where it takes any.
    attenuation: Option<Attenuation>,
    /// Format of the sum of all light.
    colour: Format,
}

impl<M, S, L> Shader<M, S, L>
where
    M: Method + Send + Sync + 'static,
    S: InputGroup<Value = InputPort, Mapped<Wide> = M::Span> + Send + Sync + 'static,
    L: InputGroup<Value = InputPort, Mapped<Wide> = M::Light> + Send + Sync + 'static,
{
    /// A method in the formats of `core`, whose inputs have these ports.
    pub fn boxed(
        method: M,
        core: &CoreParameters,
        ports: CoreInputs<S, L, InputPort>,
    ) -> Box<dyn ShadeSpan> {
        let attenuation = Attenuation::new(core);
        let formats = [Some(method.formats()), attenuation.as_ref().map(Attenuation::formats)];
        let colour = sum_format(core, formats.into_iter().flatten());
        Box::new(Shader { method, ports, attenuation, colour })
    }

    /// Names a packet's inputs, and checks them. The packet has one for each port.
    fn read(&self, packet: &SpanPacket, extent: SpanExtent) -> Result<Inputs<M>, PacketError> {
        let mut raw_values = packet.inputs.iter();
        let inputs = self.ports.map(|port| {
            let raw = raw_values.next().expect("packet::check has counted the inputs");
            from_raw(*raw, port.format)
        });
        self.method.check(&inputs, extent)?;
        for (index, light) in inputs.lights.iter().enumerate() {
            if let Some((attenuation, along)) = self.attenuation(light) {
                attenuation.check(index, along, extent)?;
            }
        }
        Ok(inputs)
    }

    /// What distance leaves of a light, where it takes any.
    fn attenuation<'a>(
        &'a self,
        light: &'a LightInputs<M::Light, Wide>,
    ) -> Option<(&'a Attenuation, &'a Quadratic<Wide>)> {
        self.attenuation.as_ref().zip(light.attenuation.as_ref())
    }

    /// The code of pixel `i`, where `state` is what the pixel before has left; it is then what this
    /// one leaves.
    fn next_pixel(
        &self,
        inputs: &Inputs<M>,
        state: &mut Option<M::State>,
        i: u32,
        observer: &mut impl Observer,
    ) -> [u8; 3] {
        let at_pixel = self.method.state(&inputs.span, *state, i, observer);
        *state = Some(at_pixel);
        let pixel = self.method.pixel(&inputs.span, at_pixel, i, observer);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let shaded = self.method.light(&pixel, &light.light, &mut observer);
            let Intensities { diffuse, specular } = match self.attenuation(light) {
                Some((attenuation, along)) => attenuation.of(along, i, shaded, &mut observer),
                None => shaded,
            };
            colour.add(&light.diffuse, diffuse);
            colour.add(&light.specular, specular);
        }
        colour.code(self.colour, observer)
    }
}

impl<M, S, L> ShadeSpan for Shader<M, S, L>
where
    M: Method + Send + Sync + 'static,
    S: InputGroup<Value = InputPort, Mapped<Wide> = M::Span> + Send + Sync + 'static,
    L: InputGroup<Value = InputPort, Mapped<Wide> = M::Light> + Send + Sync + 'static,
{
    fn shade(
        &self,
        packet: &SpanPacket,
        extent: SpanExtent,
        out: &mut Vec<[u8; 3]>,
    ) -> Result<(), PacketError> {
        let inputs = self.read(packet, extent)?;
        let mut state = None;
        out.extend(
            (0..packet.length).map(|i| self.next_pixel(&inputs, &mut state, i, &mut Nobody)),
        );
        Ok(())
    }

    fn sums(&self, packet: &SpanPacket, extent: SpanExtent) -> Result<Vec<[f64; 3]>, PacketError> {
        let inputs = self.read(packet, extent)?;
        let mut state = None;
        let sums_of = |i| {
            let mut sums = Sums::default();
            self.next_pixel(&inputs, &mut state, i, &mut sums);
            sums.0
        };
        Ok((0..packet.length).map(sums_of).collect())
    }

    fn trace(
        &self,
        packet: &SpanPacket,
        extent: SpanExtent,
        i: u32,
    ) -> Result<Vec<Observation>, PacketError> {
        let inputs = self.read(packet, extent)?;
        let mut state = (0..i)
            .fold(None, |before, i| Some(self.method.state(&inputs.span, before, i, &mut Nobody)));
        let mut notebook = Notebook::default();
        self.next_pixel(&inputs, &mut state, i, &mut notebook);
        Ok(notebook.0)
    }
}
