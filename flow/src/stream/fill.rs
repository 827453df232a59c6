//! What of a core is filled into the templates.
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op};
use specula_spec::{FieldContent, Format, Positions};

use super::StreamCore;
use super::register_map::{FrameInput, IDENTITY, VERSION};
use super::template::Values;

/// Everything that templates of Verilog ask for.
pub fn values(core: &StreamCore) -> Values {
    let mut values = Values::default();
    streams(core, &mut values);
    core_instance(core, &mut values);
    frame(core, &mut values);
    registers(core, &mut values);
    values
}

/// Widths and lengths of the streams.
fn streams(core: &StreamCore, values: &mut Values) {
    let (word, words, bits) = (core.word.bits(), core.words(), core.layout.bits);
    let positions = core.layout.positions == Positions::Sent;
    let header_bits = header_bits(core);
    values.set("NAME", core.name());
    values.set("LAYOUT", format!("{}.md", core.name()));
    values.set("WORD", word);
    values.set("WORD_TOP", word - 1);
    values.set("WORDS", words);
    values.set("WORDS_TOP", words - 1);
    values.set("PACKET_TOP", bits - 1);
    values.set("HEADER_BITS", header_bits);
    let longest = core.spec.parameters.longest_span;
    let count_bits = (u32::BITS - longest.leading_zeros()).max(2);
    values.set("LONGEST", longest);
    values.set("COUNT_BITS", count_bits);
    values.set("COUNT_TOP", count_bits - 1);
    let over_bits = 16 - count_bits;
    values.set("OVER_BITS", over_bits);
    values.set("UNUSED_COUNT", format!(", {}", selected_bits("packet", count_bits, over_bits)));
    values.set("PIXEL_TOP", core.pixel_bits() - 1);
    values.set("PIXEL_BITS", core.pixel_bits());
    values.set("TAG_BITS", core.tag_bits());
    values.set("TAG_TOP", core.tag_bits() - 1);
    values.set("LOG2_DEPTH", core.log2_depth());
    values.set("DEPTH_NEEDED", core.depth_needed());
    values.set(
        "POSITION_ABOUT",
        if positions { ",\n// its column in 24 to 39, its row in 40 to 55" } else { "" },
    );
    let take = |place: u32| {
        let (low, high) = (place * word, bits.min((place + 1) * word) - 1);
        format!("    if (accept & at[{place}]) packet[{high}:{low}] <= word[{}:0];", high - low)
    };
    values.set("TAKE_WORDS", (0..words).map(take).collect::<Vec<_>>().join("\n"));
    values.set("SURPLUS", bits);
    values.flag("surplus", words == 1 && bits < word);
    values.flag("scene", !core.spec.specialisation.is_general());
    values.flag("several", words > 1);
    values.flag("long", words > 2);
    values.set("LATER", ["", ", a clock later", ", two clocks later"][(words.min(3) - 1) as usize]);
    values.flag("positions", positions);
    values.flag("inputs", bits > header_bits);
    let interval = core.design.interval;
    values.set("INTERVAL", interval);
    values.set("LAST_SLOT", interval - 1);
    let clocks = if interval == 1 { "a clock".to_owned() } else { format!("{interval} clocks") };
    values.set("CLOCKS_A_PIXEL", clocks);
    values.flag("slots", interval > 1);
    memories(core, values);
}

/// The memory for pixels.
fn memories(core: &StreamCore, values: &mut Values) {
    let target = core.spec.target.as_ref().map(|target| target.name.as_str());
    let is_ice40 = target.is_some_and(|name| name.starts_with("ice40"));
    // Places of a memory of the device: of look-up tables, or of a block RAM.
    let log2_bank = match target {
        Some("xilinx7") => 5,
        _ if is_ice40 => 8,
        _ => 4,
    };
    values.set("LOG2_BANK", log2_bank);
    values.set("BANK", 1 << log2_bank);
    values.flag("lut_ram", !is_ice40);
    // Short memories of look-up tables are faster than block RAM without its output register.
    let style = "(* ram_style = \"distributed\" *) ";
    values.set("RAM_STYLE", if target.is_some() && !is_ice40 { style } else { "" });
    let is_ecp5 = target == Some("ecp5");
    let memory = |bits| {
        let is_large = bits << core.log2_depth() >= LEAST_BLOCK_RAM_BITS;
        let fits = core.log2_depth() <= MOST_LOG2_BLOCK_RAM_PLACES;
        if is_ecp5 && is_large && fits { "block_memory" } else { "memory" }
    };
    let [tag, colour] = [core.tag_bits(), COLOUR_BITS].map(memory);
    let block_ram = [tag, colour].contains(&"block_memory");
    values.set("TAG_MEMORY", tag);
    values.set("COLOUR_MEMORY", colour);
    values.flag("block_ram", block_ram);
    values.set("DEPTH_RANGE", if block_ram { "2 to 9" } else { "2 or more" });
}

/// Bits of a pixel's colour.
const COLOUR_BITS: u32 = 24;
/// Bits from which on a memory is in a block RAM of an ECP5, whose output register is as fast as a
/// flip-flop, rather than in 16 memories of 16 × 4 bits and what chooses between them.
const LEAST_BLOCK_RAM_BITS: u32 = 1024;
/// The base-2 logarithm of the places that a block RAM of an ECP5 has for 36 bits.
const MOST_LOG2_BLOCK_RAM_PLACES: u32 = 9;

/// Bits of a packet before the core's inputs.
fn header_bits(core: &StreamCore) -> u32 {
    match core.layout.positions {
        Positions::Absent => 32,
        Positions::Sent => 64,
    }
}

/// The pins of the core's instance, and what it gives.
fn core_instance(core: &StreamCore, values: &mut Values) {
    let design = core.design;
    let name = |id: NodeId| &design.node(id).name;
    let net = |port: &str| if port == "clock" { "aclk" } else { port }.to_owned();
    let mut pins: Vec<(String, String)> =
        clocking(design).into_iter().map(|port| (port.to_owned(), net(port))).collect();
    let start = if design.interval == 1 { "at_first" } else { "at_first & first_slot" };
    let controls = [(design.valid, "enter"), (design.start, start)];
    let controls = controls.into_iter().filter(|&(id, _)| is_input(design, id));
    pins.extend(controls.map(|(id, net)| (name(id).clone(), net.to_owned())));
    let inputs = input_pins(core);
    pins.extend(inputs.iter().map(|pin| (pin.port.clone(), pin.taken.clone())));
    let unused = inputs.iter().filter_map(|pin| pin.unused.as_ref());
    values.set("UNUSED_INPUTS", unused.map(|bits| format!(", {bits}")).collect::<String>());
    pins.push((name(design.valid_out).clone(), "leaves".to_owned()));
    let channels: Vec<String> = design.outputs.iter().map(|&id| name(id).clone()).collect();
    pins.extend(channels.iter().map(|channel| (channel.clone(), format!("core_{channel}"))));
    let pins: Vec<String> =
        pins.iter().map(|(port, net)| format!("      .{port}({net})")).collect();
    values.set("CORE_PINS", pins.join(",\n"));
    let net = |&id: &NodeId| {
        let width = design.node(id).width();
        format!("  wire {}core_{};", bounds(width), name(id))
    };
    values.set("CHANNELS", design.outputs.iter().map(net).collect::<Vec<_>>().join("\n"));
    let byte = |channel: usize| match design.outputs.get(channel) {
        None => "8'd0".to_owned(),
        Some(&id) => {
            let (width, net) = (design.node(id).width(), format!("core_{}", name(id)));
            if width < 8 { format!("{{{}'d0, {net}}}", 8 - width) } else { net }
        }
    };
    for (channel, key) in ["RED", "GREEN", "BLUE"].into_iter().enumerate() {
        values.set(key, byte(channel));
    }
}

/// The ports for clock and reset that the core has.
pub(super) fn clocking(design: &Design) -> Vec<&'static str> {
    let clock = design.nodes.iter().any(Node::registered).then_some("clock");
    let reset = design.to_block().has_reset().then_some("reset");
    clock.into_iter().chain(reset).collect()
}

/// Whether the core has this control signal as an input.
pub(super) fn is_input(design: &Design, id: NodeId) -> bool {
    design.node(id).op == Op::Input
}

/// A data input of the core: its port, the bits that go there, and the copies of their highest bit
/// above them, which the format has and the port has not.
struct InputPin {
    port: String,
    taken: String,
    unused: Option<String>,
}

/// The pins of all data inputs, those of the packet first.
fn input_pins(core: &StreamCore) -> Vec<InputPin> {
    let of_span = core.layout.fields.iter().filter_map(|field| match field.content {
        FieldContent::Input(number) => Some((number, "span", field.first_bit, field.format)),
        _ => None,
    });
    let of_frame = core.frame_inputs();
    let of_frame =
        of_frame.iter().map(|input| (input.number, input.name.as_str(), 0, input.format));
    let pin = |(number, net, low, format): (usize, &str, u32, Format)| {
        let node = core.design.node(core.design.inputs[number]?);
        let (width, field) = (node.width(), format.width());
        let is_scalar = net != "span" && field == 1;
        let taken = if is_scalar { net.to_owned() } else { selected_bits(net, low, width) };
        let unused = (field > width).then(|| selected_bits(net, low + width, field - width));
        Some(InputPin { port: node.name.clone(), taken, unused })
    };
    of_span.chain(of_frame).filter_map(pin).collect()
}

/// Some bits of a vector.
fn selected_bits(net: &str, low: u32, width: u32) -> String {
    match width {
        1 => format!("{net}[{low}]"),
        _ => format!("{net}[{}:{low}]", low + width - 1),
    }
}

/// Bounds of a vector and a blank; nothing for a single bit.
pub(super) fn bounds(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

/// Inputs that hold for a frame, outside the registers.
fn frame(core: &StreamCore, values: &mut Values) {
    let inputs = core.frame_inputs();
    let lines = |line: &dyn Fn(&FrameInput) -> String| {
        inputs.iter().map(line).collect::<Vec<_>>().join("\n")
    };
    values.flag("frames", !inputs.is_empty());
    let port = |kind: &str, input: &FrameInput| {
        let FrameInput { name, format, meaning, .. } = input;
        format!("    {kind} {}{name},  // {}; {format}", bounds(format.width()), meaning.what)
    };
    values.set("FRAME_PORTS", lines(&|input| port("input wire", input)));
    values.set("FRAME_OUTPUTS", lines(&|input| port("output reg", input)));
    values.set("FRAME_PINS", lines(&|FrameInput { name, .. }| format!("      .{name}({name}),")));
    values.set(
        "FRAME_WIRES",
        lines(&|FrameInput { name, format, .. }| {
            format!("  wire {}{name};", bounds(format.width()))
        }),
    );
    let (drain, settling) = (core.design.depth().saturating_sub(1), core.design.settling());
    let width = u32::BITS - drain.max(settling).max(1).leading_zeros();
    values.set("DRAIN", drain);
    values.set("DRAIN_WIDTH", width);
    values.set("DRAIN_TOP", width - 1);
    values.set("SETTLING", settling);
    values.set("SETTLED", u32::from(settling == 0));
}

/// Registers and their bits.
fn registers(core: &StreamCore, values: &mut Values) {
    let inputs = core.frame_inputs();
    let hex = |word: u32| format!("{word:08x}");
    values.set("IDENTITY", hex(IDENTITY));
    values.set("VERSION", hex(VERSION));
    values.set("CORE", hex(core.identity));
    values.set("CAPABILITY", hex(core.capability()));
    values.set("PACKET", hex(core.packet_size()));
    let each = |line: &dyn Fn(&FrameInput) -> Vec<String>| {
        inputs.iter().flat_map(line).collect::<Vec<_>>().join("\n")
    };
    values.set(
        "SHADOW_DECLARATIONS",
        each(&|FrameInput { name, format, .. }| {
            vec![format!("  reg {}next_{name};", bounds(format.width()))]
        }),
    );
    values.set("SHADOW_RESETS", each(&|input| vec![reset(input)]));
    values.set(
        "TAKE_OVER",
        each(&|FrameInput { name, .. }| vec![format!("      {name} <= next_{name};")]),
    );
    let parts = |input: &FrameInput| {
        let place = input.address / 4;
        let low = (place, 0, input.format.width().min(32));
        let high = (place + 1, 32, input.high_bits());
        [low, high].into_iter().filter(|part| part.2 > 0).collect::<Vec<_>>()
    };
    values.set(
        "WRITE_KNOWN",
        each(&|input| {
            let known = |&(place, ..): &(u32, u32, u32)| {
                format!("      10'h{place:03x}: known = 1'b1;  // {}", input.name)
            };
            parts(input).iter().map(known).collect()
        }),
    );
    values.set(
        "SHADOW_WRITES",
        each(&|input| {
            let write = |&(place, from, bits): &(u32, u32, u32)| {
                let (target, source) = (selected(input, from, bits), word_bits(bits));
                format!("        10'h{place:03x}: next_{target} <= s_axi_wdata{source};")
            };
            parts(input).iter().map(write).collect()
        }),
    );
    values.set(
        "SHADOW_READS",
        each(&|input| {
            let read = |&(place, from, bits): &(u32, u32, u32)| {
                let shown = extended(input, from, bits);
                format!("      10'h{place:03x}: of_input = {shown};")
            };
            parts(input).iter().map(read).collect()
        }),
    );
    let used = inputs.iter().map(|input| input.format.width().min(32)).max().unwrap_or(0).max(3);
    let is_all = used == 32;
    values.set("UNUSED", if is_all { String::new() } else { format!(", s_axi_wdata[31:{used}]") });
    values.set("UNUSED_ABOUT", if is_all { "" } else { ", and no register has all bits" });
}

/// The value of an input after reset.
fn reset(FrameInput { name, format, reset, .. }: &FrameInput) -> String {
    let width = format.width();
    let bits = (*reset as u64) & (u64::MAX >> (u64::BITS - width));
    format!("      next_{name} <= {width}'h{bits:x};")
}

/// Some bits of what waits for the next frame, without its prefix.
fn selected(FrameInput { name, format, .. }: &FrameInput, from: u32, bits: u32) -> String {
    let is_whole = format.width() == bits;
    if is_whole { name.clone() } else { format!("{name}[{}:{from}]", from + bits - 1) }
}

/// The lowest bits of a word.
fn word_bits(bits: u32) -> String {
    match bits {
        32 => String::new(),
        1 => "[0]".to_owned(),
        _ => format!("[{}:0]", bits - 1),
    }
}

/// Some bits of what waits for the next frame as a word, with the sign before it.
fn extended(input: &FrameInput, from: u32, bits: u32) -> String {
    let net = format!("next_{}", selected(input, from, bits));
    let width = input.format.width();
    match (32 - bits, input.format.signed) {
        (0, _) => net,
        (more, false) => format!("{{{more}'d0, {net}}}"),
        (more, true) if width == 1 => format!("{{{{{more}{{{net}}}}}, {net}}}"),
        (more, true) => format!("{{{{{more}{{next_{}[{}]}}}}, {net}}}", input.name, width - 1),
    }
}
