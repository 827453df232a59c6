//! Cores: units put together so that a span goes in and pixels come out, one in each clock or,
//! where lights share a pipeline, in as many as there are lights.
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
mod slerp;

use std::rc::Rc;

use specula_spec::{CoreSpec, MethodSpec};

use specula_datapath::builder::{BuildError, Builder};
use specula_datapath::design::Design;
use specula_datapath::graph::Graph;
use specula_datapath::pass::compile;
use specula_datapath::target::Generic;

/// The core that a spec asks for, elaborated under the module name `name`.
///
/// # Errors
/// [`BuildError`] if the spec's formats ask for a signal of more than 63 bits.
pub fn elaborate(spec: &CoreSpec, name: &str) -> Result<Design, BuildError> {
    let target = Rc::new(Generic);
    let graph = graph(spec, |formula| Builder::new(name, formula, target.clone()))?;
    Ok(compile(&graph, &*target)?)
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
