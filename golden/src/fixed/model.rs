//! The model of a core.
use specula_spec::{CoreSpec, InputPort, MethodSpec, SpanPacket};

use super::consistent::Consistent;
use super::direct::Direct;
use super::duff::Duff;
use super::error::PacketError;
use super::gouraud::Gouraud;
use super::hybrid::Hybrid;
use super::lyon::Lyon;
use super::observer::Observation;
use super::packet;
use super::phong::Phong;
use super::reflection::Reflection;
use super::shader::{ShadeSpan, Shader};
use super::slerp::Slerp;

/// The bit-true model of a core.
pub struct Model {
    ports: Vec<InputPort>,
    longest_span: u32,
    method: Box<dyn ShadeSpan>,
}

impl Model {
    /// The model of the core that a spec describes. The spec is one that `CoreSpec::check` accepts;
    /// the widths in which numbers are exact here rest on it.
    pub fn new(spec: &CoreSpec) -> Model {
        let core = &spec.parameters;
        let method: Box<dyn ShadeSpan> = match &spec.method {
            MethodSpec::Lyon(lyon) => Shader::boxed(Lyon::new(core, lyon), core, spec.ports(lyon)),
            MethodSpec::Phong(phong) => {
                Shader::boxed(Phong::new(core, phong), core, spec.ports(phong))
            }
            MethodSpec::Hybrid(hybrid) => {
                Shader::boxed(Hybrid::new(core, hybrid), core, spec.ports(hybrid))
            }
            MethodSpec::Duff(duff) => Shader::boxed(Duff::new(core, duff), core, spec.ports(duff)),
            MethodSpec::Gouraud(gouraud) => {
                Shader::boxed(Gouraud::new(gouraud), core, spec.ports(gouraud))
            }
            MethodSpec::Reflection(reflection) => {
                Shader::boxed(Reflection::new(core, reflection), core, spec.ports(reflection))
            }
            MethodSpec::Consistent(consistent) => {
                Shader::boxed(Consistent::new(core, consistent), core, spec.ports(consistent))
            }
            MethodSpec::Slerp(slerp) => {
                Shader::boxed(Slerp::new(core, slerp), core, spec.ports(slerp))
            }
            MethodSpec::Direct(direct) => {
                Shader::boxed(Direct::new(core, direct), core, spec.ports(direct))
            }
        };
        Model { ports: spec.inputs(), longest_span: core.longest_span, method }
    }

    /// Appends one code per pixel of the packet to `out`, red, green and blue, first pixel first.
    ///
    /// # Errors
    /// [`PacketError`] if the packet is not one for this core; `out` is then as it was.
    pub fn shade(&self, packet: &SpanPacket, out: &mut Vec<[u8; 3]>) -> Result<(), PacketError> {
        let extent = packet::check(packet, &self.ports, self.longest_span)?;
        self.method.shade(packet, extent, out)
    }

    /// The sums of ambient, diffuse and specular light that [`Model::shade`] rounds to codes: of
    /// each pixel red, green and blue, in LSBs, 0 or more and not yet cut off at 255.
    ///
    /// # Errors
    /// [`PacketError`] if the packet is not one for this core.
    pub fn sums(&self, packet: &SpanPacket) -> Result<Vec<[f64; 3]>, PacketError> {
        let extent = packet::check(packet, &self.ports, self.longest_span)?;
        self.method.sums(packet, extent)
    }

    /// Every named value of pixel `i`, in the order of the data. `<l>` counts lights, `<s>` steps,
    /// both from 0.
    ///
    /// | `docs/arithmetic.md` | name |
    /// |---|---|
    /// | a_acc, a | `weight_accumulator`, `weight` |
    /// | N' | `interpolated_x`, `_y`, `_z`; by additions, before it is rounded: `interpolated_x_accumulator` |
    /// | H, p, q, v of wrapped normals | `interpolated_x`, `wrap_p`, `wrap_q`, `wrap_ratio` |
    /// | H, p, q, v of wrapped directions | `light<l>_way_interpolated_x`, `light<l>_way_wrap_p`, `_q`, `_ratio`; of the eye with `eye_` |
    /// | z, g | `length_squared`, `gain` |
    /// | s, h, g of a Newton step | `newton<s>_square`, `newton<s>_factor`, `newton<s>_gain` |
    /// | n | `normal_x`, `_y`, `_z` |
    /// | d | `light<l>_diffuse` |
    /// | w, D | `light<l>_twice_n_dot_v`, `light<l>_difference_x`, `_y`, `_z` |
    /// | w of D2, p | `light<l>_twice_n_dot_l`, `light<l>_h_dot_n` |
    /// | u | `light<l>_scaled_difference_x`, `_y`, `_z` |
    /// | x, max(0, 1 - x), f² | `light<l>_shape_argument`, `light<l>_shape`, `light<l>_square<s>` |
    /// | q_acc, q | `denominator_accumulator`, `denominator` |
    /// | p_acc, p | `light<l>_numerator_accumulator`, `light<l>_numerator` |
    /// | b, b² | `light<l>_base`, `light<l>_square<s>` |
    /// | d_acc | `light<l>_intensity_accumulator` |
    /// | s | `root` |
    /// | p_acc, p, c of `duff` | `light<l>_p_accumulator`, `light<l>_p`, `light<l>_cosine` |
    /// | r_acc, r, v, h | `view_accumulator`, `view`, `view_cosine`, or `light<l>_halfway_accumulator`, ... |
    /// | t | `light<l>_quotient` |
    /// | acc | `light<l>_diffuse_accumulator`, `light<l>_specular_accumulator` |
    /// | f of `gouraud` | `light<l>_specular` |
    /// | w, v of `reflection` | `reciprocal`, `view_cosine` |
    /// | t_acc, t, T, q | `angle_accumulator`, `angle`, `tangent`, `contraction` |
    /// | b, g, s, ρ, m | `cos_beta`, `cos_gamma`, `sine_ratio_squared`, `sine_ratio`, `normal_share`; of L with `light<l>_` before |
    /// | r | `reflection_x`, `_y`, `_z`; of L with `light<l>_` before |
    /// | N_c of the eye | `consistent_normal_x`, `_y`, `_z`; before it `consistent_normal_length_squared`, `_gain` |
    /// | c, s; c_w, s_w | `state_cosine`, `state_sine`; `weight_cosine`, `weight_sine` |
    /// | N, g, n of `slerp` | `turned_x`, `gain`, `normal_x`, and `_y`, `_z` |
    /// | J; K, g, K' | `light<l>_n_dot_l`; `n_dot_v`, `correction`, `corrected` |
    /// | t, u, q, s of `direct` | `weight`, `product`, `length_squared`, `reciprocal` |
    /// | d, w, K' of `direct` | `length`, `reciprocal_square`, `n_dot_v_over_square` |
    /// | p_V, p_L | `n_dot_v_linear`, `light<l>_n_dot_l_linear` |
    /// | A_acc, A | `light<l>_attenuation_accumulator`, `light<l>_attenuation` |
    /// | d A, s A | `light<l>_attenuated_diffuse`, `light<l>_attenuated_specular` |
    /// | c, code | `colour_r`, `code_r`, and `_g`, `_b` |
    ///
    /// # Errors
    /// [`PacketError`] if the packet is not one for this core, or has no pixel `i`.
    pub fn trace(&self, packet: &SpanPacket, i: u32) -> Result<Vec<Observation>, PacketError> {
        let extent = packet::check(packet, &self.ports, self.longest_span)?;
        if i >= packet.length {
            return Err(PacketError::NoSuchPixel { pixel: i, length: packet.length });
        }
        self.method.trace(packet, extent, i)
    }
}
