//! The Verilog of units of small cores as it is read by people, and what is said of the cores.
use std::fmt::Write;

use specula_datapath::Design;
use specula_datapath::verilog::{self, Header};
use specula_fixtures::specs::small_needs;
use specula_spec::lyon::{Difference, Normalisation};
use specula_spec::{CoreSpec, Method, MethodSpec};

/// A core for one light, spans of up to 4 pixels and small exponents, in small formats.
fn design(method: Method, change: impl FnOnce(&mut CoreSpec)) -> Design {
    let mut spec = CoreSpec::for_scene(&small_needs(), None, Some(method)).unwrap();
    match &mut spec.method {
        MethodSpec::Lyon(lyon) => {
            let f = &mut lyon.formats;
            for format in [
                &mut f.weight,
                &mut f.vector,
                &mut f.length_squared,
                &mut f.gain,
                &mut f.difference,
            ] {
                format.fraction_bits = 8;
            }
            f.weight_accumulator.fraction_bits = 11;
            (f.diffuse.fraction_bits, f.shape.fraction_bits) = (6, 6);
        }
        // Its Verilog is not kept.
        MethodSpec::Consistent(_) => {}
        MethodSpec::Hybrid(hybrid) => {
            let f = &mut hybrid.formats;
            (f.diffuse_accumulator.fraction_bits, f.diffuse.fraction_bits) = (9, 6);
            (f.accumulator.fraction_bits, f.operand.fraction_bits, f.base.fraction_bits) =
                (12, 8, 4);
        }
        MethodSpec::Duff(duff) => {
            let f = &mut duff.formats;
            (
                f.linear_accumulator.fraction_bits,
                f.accumulator.fraction_bits,
                f.operand.fraction_bits,
            ) = (12, 12, 8);
            (f.root.fraction_bits, f.quotient.fraction_bits, f.cosine.fraction_bits) = (6, 6, 6);
            (f.diffuse.fraction_bits, f.base.fraction_bits) = (6, 4);
        }
        MethodSpec::Reflection(reflection) => {
            let f = &mut reflection.formats;
            (f.accumulator.fraction_bits, f.operand.fraction_bits, f.reciprocal.fraction_bits) =
                (12, 8, 6);
            (f.cosine.fraction_bits, f.diffuse.fraction_bits, f.base.fraction_bits) = (6, 6, 4);
        }
        _ => (),
    }
    change(&mut spec);
    spec.check().unwrap();
    specula_hdl::elaborate(&spec, method.name()).unwrap()
}

fn smallest_lyon() -> Design {
    design(Method::Lyon, |spec| {
        if let MethodSpec::Lyon(lyon) = &mut spec.method {
            (lyon.normalisation, lyon.squarings) = (Normalisation::G1, 1);
        }
    })
}

fn lyon_with_everything() -> Design {
    design(Method::Lyon, with_everything)
}

fn with_everything(spec: &mut CoreSpec) {
    if let MethodSpec::Lyon(lyon) = &mut spec.method {
        (lyon.difference, lyon.newton_steps) = (Difference::ReflectionMinusLight, 1);
    }
}

fn hybrid() -> Design {
    design(Method::Hybrid, |_| ())
}

fn text(design: &Design) -> String {
    let header = Header { lines: vec!["A header.".into(), String::new(), "Its last line.".into()] };
    verilog::print(&design.to_block(), &header)
}

/// A module of a core, with the comment above it.
fn module(design: &Design, name: &str) -> String {
    let text = text(design);
    let begins = |line: &&str| line.split(' ').take(2).eq(["module", name]);
    let modules = text.split_inclusive("\nendmodule\n");
    let found = modules.map(str::trim_start).find(|module| module.lines().any(|l| begins(&l)));
    let module = found.unwrap_or_else(|| panic!("there is no {name}"));
    // What stands before the first module is of the file.
    module.rfind("\n\n//").map_or(module, |at| module[at..].trim_start()).to_owned()
}

#[test]
fn verilog_of_interpolate() {
    insta::assert_snapshot!(module(&smallest_lyon(), "lyon_interpolate"));
}

#[test]
fn verilog_of_normalise() {
    insta::assert_snapshot!(module(&smallest_lyon(), "lyon_normalise"));
}

#[test]
fn verilog_of_shape() {
    insta::assert_snapshot!(module(&smallest_lyon(), "lyon_shape"));
}

#[test]
fn verilog_of_reflection_minus_light() {
    insta::assert_snapshot!(module(&lyon_with_everything(), "lyon_reflection_minus_light"));
}

#[test]
fn verilog_of_newton_step() {
    insta::assert_snapshot!(module(&lyon_with_everything(), "lyon_newton_step"));
}

#[test]
fn verilog_of_quadratic() {
    insta::assert_snapshot!(module(&hybrid(), "hybrid_quadratic"));
}

#[test]
fn verilog_of_divider_row() {
    insta::assert_snapshot!(module(&hybrid(), "hybrid_divider_row"));
}

#[test]
fn verilog_of_channel() {
    insta::assert_snapshot!(module(&hybrid(), "hybrid_channel"));
}

#[test]
fn verilog_of_delay() {
    insta::assert_snapshot!(module(&lyon_with_everything(), "lyon_delay"));
}

#[test]
fn verilog_of_delay_memory() {
    // Colours wait for highlights where each span may have others.
    let several_materials = design(Method::Lyon, |spec| {
        with_everything(spec);
        spec.parameters.several_materials = true;
    });
    insta::assert_snapshot!(module(&several_materials, "lyon_delay_memory"));
}

/// A core itself, with its validity and its delay lines.
#[test]
fn verilog_of_a_gouraud_core() {
    insta::assert_snapshot!(module(&design(Method::Gouraud, |_| ()), "gouraud"));
}

/// What was left out and why, the size of each unit and of the whole, and what tells one text from
/// another.
fn summary(design: &Design) -> String {
    let mut out = String::from("left out\n");
    for left_out in &design.left_out {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "  {}: {}, since {}", left_out.unit, left_out.what, left_out.why);
    }
    out.push_str("\nunits\n");
    for unit in design.unit_sizes() {
        let _ = writeln!(out, "  {}, {} clocks: {:?}", unit.path, unit.latency, unit.size);
    }
    let _ = writeln!(out, "\nwhole, {} clocks: {:?}", design.latency(), design.size());
    out.push_str("\nfacts\n");
    for assumption in &design.assumptions {
        let (name, range) = (design.full_name(assumption.node), assumption.range);
        let _ = writeln!(out, "  {name} from {} to {}: {}", range.low, range.high, assumption.fact);
    }
    let _ = writeln!(out, "\nerror at most {:.6} LSB", design.error_bound());
    let text = text(design);
    let (lines, hash) = (text.lines().count(), crc32fast::hash(text.as_bytes()));
    let _ = writeln!(out, "\nVerilog of {lines} lines, CRC-32 {hash:08x}");
    out
}

#[test]
fn summary_of_the_smallest_lyon_core() {
    insta::assert_snapshot!(summary(&smallest_lyon()));
}

#[test]
fn summary_of_a_lyon_core_with_newton_and_reflection() {
    insta::assert_snapshot!(summary(&lyon_with_everything()));
}

#[test]
fn summary_of_a_hybrid_core() {
    insta::assert_snapshot!(summary(&hybrid()));
}

/// No `$` but in `$signed`, no `initial` but in a memory, no blanket waiver; every module is
/// closed.
#[test]
fn verilog_keeps_to_the_rules() {
    for design in [smallest_lyon(), lyon_with_everything(), hybrid()] {
        let text = text(&design);
        assert!(!text.replace("$signed", "").contains('$'));
        let memories = text.matches("reg [WIDTH-1:0] memory [").count();
        assert_eq!(text.matches("initial").count(), memories);
        assert_eq!(
            text.matches("verilator lint_off").count(),
            text.matches("verilator lint_off DECLFILENAME").count()
        );
        let opened = text.lines().filter(|line| line.starts_with("module ")).count();
        assert_eq!(opened, text.matches("endmodule").count());
        assert!(text.is_ascii(), "tools of old read ASCII alone");
        assert!(text.lines().all(|line| line == line.trim_end()), "no blanks at the end of a line");
    }
}
