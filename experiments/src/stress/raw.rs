//! Packets that no scene makes: bit patterns within the ranges of ports.
use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_golden::fixed::Model;
use specula_scene::{Needs, parse};
use specula_sim::{Engine, Fast, Flow, Stimulus};
use specula_spec::{CoreSpec, InputPort, Method, SpanPacket, SpecError};

use super::cell::Cell;
use super::draw::{Draw, tilted};
use super::requirement::Requirement;
use super::row::{PixelPlace, TrialExtent};
use super::scene::{RawSpan, SpanScene, lit};
use super::variant::Variant;
use specula_testbench::Monitor;
use specula_testbench::checker;

/// The row's name.
pub const ID: &str = "raw";
/// The row's description.
pub const INPUT: &str = "ports at 0, at all ones, at the ends of their ranges, and at random patterns, without any scene";
/// Runs a method's cores on bit patterns.
pub fn cell(method: Method, draw: &mut Draw, extent: TrialExtent) -> Cell {
    let mut cell = Cell::empty(ID, Some(method));
    let variants = if extent.every_option {
        Variant::all_of(method)
    } else {
        vec![Variant::default_of(method)]
    };
    for longest in [3, 200] {
        for variant in &variants {
            match spec(variant, longest) {
                Ok(spec) => try_spec(&mut cell, variant, &spec, draw, extent),
                Err(error) => cell.refuse(error.to_string()),
            }
        }
    }
    cell
}

/// A core with two lights, everything else as wide as a wide span with a sharp highlight needs.
fn spec(variant: &Variant, longest: u32) -> Result<CoreSpec, SpecError> {
    let spans = vec![RawSpan::between([tilted(-40.0), tilted(45.0)], longest, lit(256))];
    let scene = SpanScene::new(&[tilted(10.0), tilted(-30.0)], spans);
    // The text is written as that of every other row's scenes.
    let frame = parse("raw.toml", scene.text(""))
        .map_err(|error| SpecError::Core { message: error.to_string() })?
        .frame;
    variant.core_spec(&Needs::of(&frame))
}

fn try_spec(
    cell: &mut Cell,
    variant: &Variant,
    spec: &CoreSpec,
    draw: &mut Draw,
    extent: TrialExtent,
) {
    let design = match specula_hdl::elaborate(spec, "core") {
        Ok(design) => design,
        Err(error) => return cell.refuse(error.to_string()),
    };
    let model = Model::new(spec);
    let fits = |packet: &SpanPacket| model.shade(packet, &mut Vec::new()).is_ok();
    let packets: Vec<SpanPacket> =
        patterns(spec, draw, extent.spans).into_iter().filter(fits).collect();
    cell.cores += 1;
    cell.pixels += packets.iter().map(|packet| u64::from(packet.length)).sum::<u64>();
    let core = variant.describe();
    match simulated(&design, &packets) {
        Ok(simulated) => {
            cell.reported += simulated.breaks_a_fact.iter().filter(|&&breaks| breaks).count();
            cell.ask(&core, simulated.out_of_range(&design));
            cell.ask(&core, wrong_codes(&model, &packets, &simulated));
        }
        Err(what) => cell.ask(
            &core,
            Requirement {
                detail: Some(what),
                ..Requirement::none_of("runs that break off", 1, None)
            },
        ),
    }
}

/// Packets of every pattern that the model accepts; it refuses those without meaning.
fn patterns(spec: &CoreSpec, draw: &mut Draw, random: usize) -> Vec<SpanPacket> {
    let ports = spec.inputs();
    let of = |draw: &mut Draw, value: &mut dyn FnMut(usize, &InputPort) -> i64| SpanPacket {
        length: draw.length(spec.parameters.longest_span),
        inputs: ports
            .iter()
            .enumerate()
            .map(|(k, port)| value(k, port).clamp(port.range.0, port.range.1))
            .collect(),
    };
    let low = |port: &InputPort| port.range.0;
    let high = |port: &InputPort| port.range.1;
    let mut packets = vec![
        of(draw, &mut |_, _| 0),
        // All ones are -1 in two's complement, and the largest number if unsigned.
        of(draw, &mut |_, port| if port.format.signed { -1 } else { port.format.max_raw() }),
        of(draw, &mut |_, port| low(port)),
        of(draw, &mut |_, port| high(port)),
        of(draw, &mut |k, port| if k % 2 == 0 { low(port) } else { high(port) }),
    ];
    // One port is at either end of its range while all others are not, and vice versa.
    for alone in 0..ports.len() {
        packets.push(of(draw, &mut |k, port| if k == alone { high(port) } else { 0 }));
        packets.push(of(draw, &mut |k, port| if k == alone { low(port) } else { 0 }));
    }
    for _ in 0..8 * random {
        // Halves and quarters of ranges are refused less often.
        let shift = draw.between(0, 3);
        let mut stream = draw.fork();
        packets.push(of(draw, &mut |_, port| stream.between(low(port), high(port)) >> shift));
    }
    packets
}

/// The codes of packets, and the packets that break a fact which hosts guarantee.
struct Simulated {
    codes: Vec<[u8; 3]>,
    breaks_a_fact: Vec<bool>,
    /// Signals that left their proven ranges, each with the packet that caused it.
    leaves: Vec<(NodeId, usize)>,
}

impl Simulated {
    /// The requirement on signals that left their ranges with a packet that breaks no fact.
    fn out_of_range(&self, design: &Design) -> Requirement {
        let out: Vec<&(NodeId, usize)> =
            self.leaves.iter().filter(|(_, span)| !self.breaks_a_fact[*span]).collect();
        let first = out.first();
        let place = first.map(|(_, span)| PixelPlace { span: *span, pixel: 0 });
        let detail = first.map(|(signal, _)| format!("`{}`", design.full_name(*signal)));
        Requirement {
            detail,
            ..Requirement::none_of("signals outside their proven ranges", out.len() as u64, place)
        }
    }
}

fn simulated(design: &Design, packets: &Vec<SpanPacket>) -> Result<Simulated, String> {
    let stimulus = Stimulus::whole(packets, design);
    let mut monitor = Monitor::new(design, &stimulus);
    let mut breaks_a_fact = vec![false; packets.len()];
    let (mut leaves, watched) = (Vec::new(), design.variables());
    // The first span begins with the first clock in which a pixel enters.
    let span_of = |entry: u64| {
        (1..packets.len()).find(|&span| stimulus.begin_of(span) > entry).unwrap_or(packets.len())
            - 1
    };
    let run = Fast::new(design).run(&stimulus, &watched, &mut |batch| {
        monitor.take(batch);
        for entry in checker::entries_that_violate(design, &stimulus, batch) {
            breaks_a_fact[span_of(entry)] = true;
        }
        let out = checker::signals_out_of_range(design, &stimulus, batch);
        leaves.extend(out.into_iter().map(|(signal, entry)| (signal, span_of(entry))));
        Flow::Continue
    });
    run.map_err(|error| error.to_string())?;
    let Monitor { codes, wrong_clocks, .. } = monitor;
    match wrong_clocks.first() {
        Some(clock) => Err(format!("a pixel that comes or fails to come in clock {clock}")),
        None => Ok(Simulated { codes, breaks_a_fact, leaves }),
    }
}

/// The requirement on packets that break no fact and have another code than the model's.
fn wrong_codes(model: &Model, packets: &[SpanPacket], simulated: &Simulated) -> Requirement {
    let mut rest = &simulated.codes[..];
    let mut wrong: Vec<(PixelPlace, String)> = Vec::new();
    for (span, packet) in packets.iter().enumerate() {
        let (given, later) = rest.split_at((packet.length as usize).min(rest.len()));
        rest = later;
        if !simulated.breaks_a_fact[span] {
            wrong.extend(
                wrong_code(model, packet, given)
                    .map(|(pixel, what)| (PixelPlace { span, pixel }, what)),
            );
        }
    }
    let first = wrong.first();
    let number = wrong.len() as u64;
    let (place, detail) = (first.map(|(place, _)| *place), first.map(|(_, what)| what.clone()));
    Requirement {
        detail,
        ..Requirement::none_of("packets with codes other than the model's", number, place)
    }
}

/// The first code of a packet that differs from the model's.
fn wrong_code(model: &Model, packet: &SpanPacket, given: &[[u8; 3]]) -> Option<(u32, String)> {
    let mut expected = Vec::new();
    if let Err(error) = model.shade(packet, &mut expected) {
        return Some((0, error.to_string()));
    }
    let pixel = (0..expected.len()).find(|&i| given.get(i) != Some(&expected[i]))?;
    let (got, wanted) = (given.get(pixel), expected[pixel]);
    Some((
        pixel as u32,
        format!("the code {got:?}, and the model has {wanted:?}; inputs {:?}", packet.inputs),
    ))
}
