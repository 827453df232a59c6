//! Cores: units put together so that a span goes in and pixels come out, one in each clock or,
//! where lights share a pipeline, in as many as there are lights; where components take turns, in
//! three.
mod attenuation;
mod common;
mod consistent;
mod direct;
mod duff;
mod forward;
mod gouraud;
mod hybrid;
mod lyon;
mod phong;
mod reflection;
mod share;
mod slerp;
mod spot;
mod vector_ways;
mod ways;

use specula_spec::{CoreSpec, MethodSpec};

use specula_datapath::builder::{BuildError, Builder};
use specula_datapath::design::Design;
use specula_datapath::graph::Graph;
use specula_datapath::pass::{ClockLimit, Pipelining, bounds, compile};

/// The core that a spec asks for, elaborated under the module name `name`.
///
/// # Errors
/// [`BuildError`] if the spec's formats ask for a signal of more than 63 bits.
pub fn elaborate(spec: &CoreSpec, name: &str) -> Result<Design, BuildError> {
    let graph = graph(spec, |formula| Builder::new(name, formula))?;
    // A spec's target is one of those there are, which `CoreSpec::check` asks for.
    let target =
        spec.target.as_ref().and_then(|clock| Some((clock.target().ok()?, clock.clock_mhz)));
    let pipelining = match &target {
        Some((target, mhz)) => Pipelining::ForClock { target, mhz: *mhz },
        None => Pipelining::EachOperator,
    };
    Ok(compile(&graph, &pipelining)?)
}

/// The proven bound of a core's quantisation error, in LSBs: that of its design, which is not made.
///
/// # Errors
/// As [`elaborate`].
pub fn error_bound(spec: &CoreSpec) -> Result<f64, BuildError> {
    let graph = graph(spec, |formula| Builder::new("core", formula))?;
    Ok(bounds(&graph).of_outputs(&graph))
}

/// The highest clock, in MHz, that the target of a spec allows its core; that of the spec where it
/// has none.
///
/// # Errors
/// As [`elaborate`].
pub fn highest_clock(spec: &CoreSpec) -> Result<f64, BuildError> {
    let Some(clock) = &spec.target else { return Ok(f64::INFINITY) };
    let graph = graph(spec, |formula| Builder::new("core", formula))?;
    let target = clock.target().ok();
    Ok(target
        .map_or(clock.clock_mhz, |target| specula_datapath::pass::highest_clock(&graph, &target)))
}

/// The highest clock, in MHz, that the target of a spec allows its core, and what limits it; none
/// where the spec has no target.
///
/// # Errors
/// As [`elaborate`].
pub fn clock_limit(
    spec: &CoreSpec,
    name: &str,
) -> Result<Option<(f64, Option<ClockLimit>)>, BuildError> {
    let Some(target) = spec.target.as_ref().and_then(|clock| clock.target().ok()) else {
        return Ok(None);
    };
    let graph = graph(spec, |formula| Builder::new(name, formula))?;
    let mhz = specula_datapath::pass::highest_clock(&graph, &target);
    Ok(Some((mhz, specula_datapath::pass::clock_limit(&graph, &target, mhz))))
}

/// The core that a spec asks for, before any pass, described with the builder for its formula.
///
/// # Errors
/// As [`elaborate`].
pub fn graph(
    spec: &CoreSpec,
    builder: impl FnOnce(&'static str) -> Builder,
) -> Result<Graph, BuildError> {
    match &spec.method {
        MethodSpec::Lyon(lyon) => lyon::core(
            builder("Lyon's reformulation of Phong shading [Lyon, TR 43]"),
            &spec.parameters,
            lyon,
            &spec.ports(lyon),
        ),
        MethodSpec::Phong(phong) => phong::core(
            builder("Phong shading with true normalisation [lecture, eq. 2.1, 4.1, 4.2]"),
            &spec.parameters,
            phong,
            &spec.ports(phong),
        ),
        MethodSpec::Hybrid(hybrid) => hybrid::core(
            builder("Gouraud diffuse, specular p/q by forward differences [Hast et al.]"),
            &spec.parameters,
            hybrid,
            &spec.ports(hybrid),
        ),
        MethodSpec::Duff(duff) => duff::core(
            builder("Diffuse p/sqrt q by forward differences [Hast et al.]"),
            &spec.parameters,
            duff,
            &spec.ports(duff),
        ),
        MethodSpec::Gouraud(gouraud) => gouraud::core(
            builder("Intensities of vertices or of polygons [lecture, eq. 2.1, 3.2-3.6]"),
            &spec.parameters,
            gouraud,
            &spec.ports(gouraud),
        ),
        MethodSpec::Reflection(reflection) => reflection::core(
            builder("Reflection shading: quotients of quadratics [Hast et al.]"),
            &spec.parameters,
            reflection,
            &spec.ports(reflection),
        ),
        MethodSpec::Consistent(consistent) => consistent::core(
            builder("Consistent normal interpolation [Reshetov, Soupikov and Mark]"),
            &spec.parameters,
            consistent,
            &spec.ports(consistent),
        ),
        MethodSpec::Slerp(slerp) => slerp::core(
            builder(
                "Incremental spherical interpolation of N.L and N.V [lecture, eq. 4.5, 4.7-4.12]",
            ),
            &spec.parameters,
            slerp,
            &spec.ports(slerp),
        ),
        MethodSpec::Direct(direct) => direct::core(
            builder("Fast Phong shading, evaluated at every pixel [lecture, eq. 4.3-4.6]"),
            &spec.parameters,
            direct,
            &spec.ports(direct),
        ),
    }
}
