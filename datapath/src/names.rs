//! Names: words that languages keep for themselves, names that are taken, and names that a module
//! may have, whatever it is called after.
use std::collections::HashSet;
use std::sync::LazyLock;

use rustc_hash::FxHashSet;

use crate::design::ScopeId;

/// Names of every module's control ports.
pub const CONTROL: [&str; 2] = ["clock", "reset"];

/// Names of every core's other ports that carry no data of a span.
const PIXEL: [&str; 6] = ["valid", "start", "valid_out", "red", "green", "blue"];

/// Whether Verilog, or SystemVerilog, as which many tools read it, keeps the word for itself.
pub fn is_reserved(word: &str) -> bool {
    // Every signal of every design is asked for.
    static RESERVED: LazyLock<HashSet<&str>> = LazyLock::new(|| VERILOG.split(' ').collect());
    RESERVED.contains(word)
}

/// `name`, or with a number behind it where the unit has it already; a word that Verilog keeps for
/// itself gets a number too.
pub fn unique(names: &mut FxHashSet<(ScopeId, String)>, scope: ScopeId, name: &str) -> String {
    first_taken(name, |candidate| names.insert((scope, candidate.to_owned())))
}

/// `name`, or with a number behind it, as `take` takes it; a word that Verilog keeps for itself gets
/// a number too.
pub fn first_taken(name: &str, mut take: impl FnMut(&str) -> bool) -> String {
    let mut candidate = if is_reserved(name) { format!("{name}_1") } else { name.to_owned() };
    let mut number = 2;
    while !take(&candidate) {
        candidate = format!("{name}_{number}");
        number += 1;
    }
    candidate
}

/// A name for the module of a core from a scene's name: small letters, digits and single
/// underscores between them. It is the scene's own where it can be, and has `_core` behind it where
/// it is one of the core's `ports`, which would be hidden, or a word that a hardware description
/// language or a file system keeps for itself.
pub fn module_name<'a>(scene: &str, ports: impl IntoIterator<Item = &'a str>) -> String {
    let name = legal(scene);
    let is_port = CONTROL.iter().chain(&PIXEL).any(|port| *port == name)
        || ports.into_iter().any(|port| port == name);
    let is_kept = is_reserved(&name) || ELSEWHERE.split(' ').any(|reserved| reserved == name);
    if is_port || is_kept { format!("{name}_core") } else { name }
}

fn legal(scene: &str) -> String {
    let words = scene.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name = words.collect::<Vec<_>>().join("_").to_ascii_lowercase();
    match name.chars().next() {
        None => "scene".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("scene_{name}"),
        Some(_) => name,
    }
}

/// IEEE Std 1800-2017, annex B.
const VERILOG: &str = "\
accept_on alias always always_comb always_ff always_latch and assert assign assume automatic \
before begin bind bins binsof bit break buf bufif0 bufif1 byte case casex casez cell chandle \
checker class clocking cmos config const constraint context continue cover covergroup \
coverpoint cross deassign default defparam design disable dist do edge else end endcase \
endchecker endclass endclocking endconfig endfunction endgenerate endgroup endinterface \
endmodule endpackage endprimitive endprogram endproperty endsequence endspecify endtable \
endtask enum event eventually expect export extends extern final first_match for force \
foreach forever fork forkjoin function generate genvar global highz0 highz1 if iff ifnone \
ignore_bins illegal_bins implements implies import incdir include initial inout input inside \
instance int integer interconnect interface intersect join join_any join_none large let \
liblist library local localparam logic longint macromodule matches medium modport module \
nand negedge nettype new nexttime nmos nor noshowcancelled not notif0 notif1 null or output \
package packed parameter pmos posedge primitive priority program property protected pull0 \
pull1 pulldown pullup pulsestyle_ondetect pulsestyle_onevent pure rand randc randcase \
randsequence rcmos real realtime ref reg reject_on release repeat restrict return rnmos \
rpmos rtran rtranif0 rtranif1 s_always s_eventually s_nexttime s_until s_until_with scalared \
sequence shortint shortreal showcancelled signed small soft solve specify specparam static \
string strong strong0 strong1 struct super supply0 supply1 sync_accept_on sync_reject_on \
table tagged task this throughout time timeprecision timeunit tran tranif0 tranif1 tri tri0 \
tri1 triand trior trireg type typedef union unique unique0 unsigned until until_with untyped \
use uwire var vectored virtual void wait wait_order wand weak weak0 weak1 while wildcard \
wire with within wor xnor xor";

/// What VHDL keeps besides, its usual libraries, and what Windows takes for devices.
const ELSEWHERE: &str = "\
abs access after all architecture array assume_guarantee attribute aux block body buffer bus \
component con configuration constant disconnect downto elsif entity exit fairness file \
generic group guarded ieee impure in inertial is label linkage literal loop map mod next nul \
of on open others out port postponed private prn procedure process range record register \
reject rem report restrict_guarantee rol ror select severity shared signal sla sll sra srl \
std subtype then to transport unaffected units variable view vmode vprop vunit when work";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_kept() {
        assert!(["bit", "always", "xor", "always_ff"].into_iter().all(is_reserved));
        assert!(["entity", "bits", ""].into_iter().all(|word| !is_reserved(word)));
    }

    #[test]
    fn names_are_legal_in_every_language() {
        let names = ["teapot", "7up", "Stanford Bunny", "", "\u{fc}nder", "_3d__scan_"].map(legal);
        assert_eq!(
            names,
            ["teapot", "scene_7up", "stanford_bunny", "scene", "nder", "scene_3d_scan"]
        );
    }
}
