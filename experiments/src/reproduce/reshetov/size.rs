//! The hardware cost of consistent normals.
use specula_datapath::Design;
use specula_datapath::design::Size;
use specula_scene::{Frame, Needs};
use specula_spec::{CoreOptions, CoreSpec, Method};

use specula_testbench::BenchError;

/// A core and its size.
pub struct SizedCore {
    /// Its description.
    pub name: &'static str,
    /// The core.
    pub design: Design,
    /// The size of the units for consistent normals in it.
    pub share: Size,
}

/// The units for consistent normals: q of the angle, and the reflection with it.
const UNITS: [&str; 2] = ["contraction", "consistent_reflection"];

/// Phong's core and those with both curves, for a frame.
///
/// # Errors
/// [`BenchError`] if one cannot be built for the frame.
pub fn sizes(frame: &Frame) -> Result<Vec<SizedCore>, BenchError> {
    let cores = [
        ("`phong`", Method::Phong, ""),
        ("`consistent`, rational", Method::Consistent, "consistent.curve = \"rational\""),
        ("`consistent`, trigonometric", Method::Consistent, "consistent.curve = \"trigonometric\""),
    ];
    cores.into_iter().map(|(name, method, options)| sized(frame, name, method, options)).collect()
}

fn sized(
    frame: &Frame,
    name: &'static str,
    method: Method,
    options: &str,
) -> Result<SizedCore, BenchError> {
    let options: CoreOptions = options.parse()?;
    let spec =
        CoreSpec::for_scene(&Needs::of(frame), Some(&options), Some(method))?.specialised(frame);
    let design = specula_hdl::elaborate(&spec, "core")?;
    let of_units =
        |path: &str| path.split('.').any(|unit| UNITS.iter().any(|name| unit.starts_with(name)));
    let share = design
        .unit_sizes()
        .into_iter()
        .filter(|unit| of_units(&unit.path))
        .map(|unit| unit.size)
        .fold(Size::default(), sum);
    Ok(SizedCore { name, design, share })
}

fn sum(a: Size, b: Size) -> Size {
    Size {
        multipliers: a.multipliers + b.multipliers,
        multiplier_bits: a.multiplier_bits + b.multiplier_bits,
        adders: a.adders + b.adders,
        adder_bits: a.adder_bits + b.adder_bits,
        multiplexers: a.multiplexers + b.multiplexers,
        register_bits: a.register_bits + b.register_bits,
        table_bits: a.table_bits + b.table_bits,
    }
}
