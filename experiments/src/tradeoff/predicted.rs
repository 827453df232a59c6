//! The clock that a target's delays predict for a core.
use specula_datapath::Design;
use specula_datapath::timing::Timing;
use specula_spec::CoreSpec;

/// The clock, in MHz, that the delays of a core's target predict for its design; none of a core for
/// any device.
pub fn predicted_mhz(spec: &CoreSpec, design: &Design) -> Option<f64> {
    let target = spec.target.as_ref()?.target().ok()?;
    Some(Timing::of(design, &target)?.mhz())
}
