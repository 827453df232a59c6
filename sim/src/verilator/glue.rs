//! What `main.cpp` and `timed.cpp` must know of a core's ports.
use std::fmt::Write;

use crate::external::{Port, Ports};

/// The text of `ports.h`.
pub fn header(ports: &Ports) -> String {
    let mut out =
        String::from("// The ports of the core.\n#include <cstdint>\n\n#include \"Vcore.h\"\n\n");
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(out, "constexpr int INPUTS = {};\n", ports.inputs.len());
    setter(&mut out, "set_clock", ports.clock.then_some("clock"));
    setter(&mut out, "set_reset", ports.reset.then_some("reset"));
    let _ = writeln!(
        out,
        "static inline void set_control(Vcore& core, uint64_t valid, uint64_t start) {{ core.{} = valid; core.{} = start; }}",
        ports.valid.name, ports.start.name
    );
    let inputs = ports.inputs.iter().map(|port| format!("core.{} = value; return;", port.name));
    switch(&mut out, "void set_input(Vcore& core, int number, uint64_t value)", inputs, "return;");
    let all = ports.all().map(|port| format!("return core.{};", port.name));
    switch(&mut out, "uint64_t port(const Vcore& core, int number)", all, "return 0;");
    sums(&mut out, &ports.outputs);
    out
}

/// Functions that say whether a pixel leaves, and add its codes to sums.
fn sums(out: &mut String, outputs: &[Port]) {
    let Some((valid, codes)) = outputs.split_first() else { return };
    let _ = writeln!(out, "\nconstexpr int CODES = {};\n", codes.len());
    let _ = writeln!(
        out,
        "static inline bool leaves(const Vcore& core) {{ return core.{}; }}\n",
        valid.name
    );
    let _ = writeln!(out, "static inline void add_codes(const Vcore& core, uint32_t* sums) {{");
    for (number, code) in codes.iter().enumerate() {
        let _ = writeln!(out, "  sums[{number}] += core.{};", code.name);
    }
    let _ = writeln!(out, "}}");
}

/// A function that puts a bit to a pin, or does nothing where there is none.
fn setter(out: &mut String, function: &str, pin: Option<&str>) {
    let _ = match pin {
        Some(pin) => writeln!(
            out,
            "static inline void {function}(Vcore& core, uint64_t bit) {{ core.{pin} = bit; }}"
        ),
        None => writeln!(out, "static inline void {function}(Vcore&, uint64_t) {{}}"),
    };
}

fn switch(out: &mut String, signature: &str, cases: impl Iterator<Item = String>, otherwise: &str) {
    let _ = writeln!(out, "\nstatic inline {signature} {{\n  switch (number) {{");
    for (number, case) in cases.enumerate() {
        let _ = writeln!(out, "    case {number}: {case}");
    }
    let _ = writeln!(out, "    default: {otherwise}\n  }}\n}}");
}
