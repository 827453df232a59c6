//! The properties that are proven of a block's streams and registers.
use specula_datapath::design::NodeId;
use specula_spec::Positions;

use super::StreamCore;
use super::fill::{bounds, clocking, is_input};
use super::template::Values;

/// Clocks of the pipeline that stands in place of the core.
const STAND_IN_CLOCKS: u32 = 2;
/// Bits of a pixel's number that tell it from all others under way, with a memory of 4 places.
const NUMBER_BITS: u32 = 3;

/// Adds what the template of the properties asks for besides.
pub fn values(core: &StreamCore, values: &mut Values) {
    let (word, words) = (core.word.bits(), core.words());
    let index_bits = u32::BITS - words.leading_zeros();
    values.set("WORDS_BITS", words * word);
    values.set("LAST_WORD", words - 1);
    values.set("INDEX_BITS", index_bits);
    values.set("INDEX_TOP", index_bits - 1);
    values.set("FORMAL_DRAIN", STAND_IN_CLOCKS - 1);
    let (marks, tag_marks) = match core.layout.positions {
        Positions::Absent => (2, "tag"),
        Positions::Sent => (4, "tag[18], tag[2], tag[1:0]"),
    };
    values.set("MARKS", marks);
    values.set("TAG_MARKS", tag_marks);
    let inputs = core.frame_inputs();
    let bits: u32 = inputs.iter().map(|input| input.format.width()).sum();
    let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
    values.set("FRAME_INPUT_BITS", bits);
    values.set("FRAME_INPUT_NAMES", names.join(", "));
    stand_in(core, values);
}

/// The pipeline in place of the core: ports of the same names.
fn stand_in(core: &StreamCore, values: &mut Values) {
    let design = core.design;
    let name = |id: NodeId| design.node(id).name.as_str();
    let port = |direction: &str, id: NodeId| {
        format!("    {direction} wire {}{}", bounds(design.node(id).width()), name(id))
    };
    let clocking = clocking(design);
    values.flag("reset", clocking.contains(&"reset"));
    let mut ports: Vec<String> =
        clocking.iter().map(|name| format!("    input wire {name}")).collect();
    let controls = [design.valid, design.start].into_iter().filter(|&id| is_input(design, id));
    ports.extend(
        controls.chain(design.inputs.iter().flatten().copied()).map(|id| port("input", id)),
    );
    let leaving = std::iter::once(design.valid_out).chain(design.outputs.iter().copied());
    ports.extend(leaving.map(|id| port("output", id)));
    values.set("STAND_IN_PORTS", ports.join(",\n"));
    values.set("VALID_OUT", name(design.valid_out));
    let width = |id: NodeId| design.node(id).width();
    let colour = |&id: &NodeId| format!("  assign {} = number[{}:0];", name(id), width(id) - 1);
    values
        .set("STAND_IN_COLOURS", design.outputs.iter().map(colour).collect::<Vec<_>>().join("\n"));
    // Without a channel there is no number, and a narrow one has its lowest bits.
    let widest = (0..).zip(&design.outputs).max_by_key(|(_, id)| width(**id).min(NUMBER_BITS));
    values.flag("numbered", widest.is_some());
    if let Some((channel, &id)) = widest {
        let bits = width(id).min(NUMBER_BITS);
        values.set("NUMBER_LOW", 8 * channel);
        values.set("NUMBER_TOP", 8 * channel + bits - 1);
        values.set("ORDER_TOP", bits - 1);
    }
}
