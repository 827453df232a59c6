//! What it costs to add increments, as the papers print them, beside a weight that multiplies them
//! [lecture, eq. 4.1 to 4.4; Lyon, TR 43, fig. 6 and 7; decision 0041].
use rayon::prelude::*;
use specula_datapath::resources::Resources;
use specula_datapath::target::Target;
use specula_scene::{Frame, Needs};
use specula_spec::{
    CoreSpec, Increments, Method, MethodSpec, PacketLayout, Positions, TargetClock,
};
use specula_testbench::BenchError;

use crate::formats::{DefaultCore, Products, default_core};
use crate::search::largest_error;
use crate::stress::variant::Variant;

/// What cores are made for, in the table of decision 0041 too.
const TARGET: &str = "ecp5";
/// The clock in MHz.
const CLOCK_MHZ: f64 = 250.0;

/// A core, and what it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct IncrementCost {
    /// The method.
    pub method: Method,
    /// What becomes of its increments.
    pub increments: Increments,
    /// Cells of an ECP5, estimated.
    pub resources: Resources,
    /// Bits of registers.
    pub register_bits: u64,
    /// Clocks from a pixel's entry to its exit.
    pub latency: u32,
    /// Bits of the packet of a span.
    pub packet_bits: u32,
    /// The proven bound of the quantisation error, in LSBs.
    pub bound: f64,
    /// The largest quantisation error over the frame's pixels, in LSBs.
    pub quantisation_lsb: f64,
}

/// What a frame's cores take with increments multiplied and added, for each method that has the
/// choice, and of `duff`, which adds all of them and N·N's too; each in the cheapest formats that are
/// found for which it is faithful.
///
/// # Errors
/// [`BenchError`] if a core cannot be built for the frame.
pub fn costs(frame: &Frame) -> Result<Vec<IncrementCost>, BenchError> {
    let choices = Method::ALL.into_iter().flat_map(|method| {
        let choices: &[Increments] = match method {
            Method::Duff => &[Increments::Added],
            _ if method.option_domains().iter().any(|domain| domain.key == "increments") => {
                &[Increments::Multiplied, Increments::Added]
            }
            _ => &[],
        };
        choices.iter().map(move |&increments| (method, increments))
    });
    let choices: Vec<(Method, Increments)> = choices.collect();
    choices.into_par_iter().map(|(method, increments)| cost(frame, method, increments)).collect()
}

fn cost(
    frame: &Frame,
    method: Method,
    increments: Increments,
) -> Result<IncrementCost, BenchError> {
    // The target has a table.
    let target = Target::named(TARGET).expect("ecp5 is a target");
    let mut start = Variant::default_of(method).core_spec(&Needs::of(frame))?;
    match &mut start.method {
        MethodSpec::Lyon(lyon) => lyon.increments = increments,
        MethodSpec::Phong(phong) => phong.increments = increments,
        MethodSpec::Direct(direct) => direct.increments = increments,
        _ => (),
    }
    start.target = Some(TargetClock { name: TARGET.to_owned(), clock_mhz: CLOCK_MHZ });
    let start = start.specialised(frame);
    let products = Products::Of(Box::new(target.clone()));
    let DefaultCore { spec, .. } = default_core(start, frame, &[], products)?;
    measured(frame, &spec, (increments, &target))
}

fn measured(
    frame: &Frame,
    spec: &CoreSpec,
    (increments, target): (Increments, &Target),
) -> Result<IncrementCost, BenchError> {
    let design = specula_hdl::elaborate(spec, "core")?;
    Ok(IncrementCost {
        method: spec.method(),
        increments,
        resources: Resources::of(&design, target),
        register_bits: design.size().register_bits,
        latency: design.latency(),
        packet_bits: PacketLayout::of(spec, Positions::Absent).bits,
        bound: design.output_errors.iter().copied().fold(0.0, f64::max),
        quantisation_lsb: largest_error(spec, frame)?,
    })
}
