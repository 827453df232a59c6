//! Prints how many packets a second the C host code of each method makes on one core, for the spans of
//! a scene with one material:
//!
//!     cargo run --release -p specula-flow --example host_speed -- teapot
//!     cargo run --release -p specula-flow --example host_speed -- teapot slerp 'edges = "slerp"'
//!
//! The second is of one method with options of its table.
//!
//! The time is that of many passes over all spans, structs in memory to words in memory; compiled by
//! gcc with -O2. `docs/host.md` has the figures.
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::process::Command;

use specula_flow::host::{ExampleSpan, HostCode, c_frame, c_header, c_span};
use specula_flow::stream::{StreamCore, StreamShape};
use specula_scene::{Frame, Needs, load};
use specula_spec::{CoreSpec, Method, Positions, SceneCore, WordWidth};

/// Spans whose structs are compiled into a program.
const MOST_SPANS: usize = 2000;
/// Packets that are made in all.
const PACKETS: usize = 20_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "teapot".to_owned());
    let scene = load(&name, None)?;
    let Some(method) = arguments.next() else {
        return Method::ALL
            .into_iter()
            .try_for_each(|method| print_speeds(&scene.core_spec(Some(method))?, &scene.frame));
    };
    let method = Method::from_name(&method)?;
    let options = arguments.next().unwrap_or_default();
    let table = format!("[{}]\n{options}", method.name()).parse()?;
    let spec = CoreSpec::for_scene(&Needs::of(&scene.frame), Some(&table), Some(method))?;
    print_speeds(&spec.specialised(&scene.frame), &scene.frame)
}

/// Those of a core for any scene, and of the same for the frame alone.
fn print_speeds(spec: &CoreSpec, frame: &Frame) -> Result<(), Box<dyn Error>> {
    for (kind, spec) in [("general", &spec.general()), ("scene", spec)] {
        let (method, rate) = (spec.method().name(), packets_a_second(spec, frame)?);
        println!("{method:12} {kind:8} {:6.1} million packets a second", rate / 1e6);
    }
    Ok(())
}

fn packets_a_second(spec: &CoreSpec, frame: &Frame) -> Result<f64, Box<dyn Error>> {
    let design = specula_hdl::elaborate(spec, "core")?;
    let shape = StreamShape { word: WordWidth::Bits32, positions: Positions::Sent };
    if spec.parameters.several_materials {
        return Err("the scene has several materials".into());
    }
    let core = StreamCore::new(spec, &design, shape, "");
    let folder = tempfile::tempdir()?;
    let path = |name: &str| folder.path().join(name);
    fs::write(path("core.h"), c_header(&HostCode::new(&core)))?;
    fs::write(path("speed.c"), program(&HostCode::new(&core), frame)?)?;
    let arguments = ["-std=c99", "-O2", "-o", "speed", "speed.c", "-lm"];
    let compiled = Command::new("gcc").args(arguments).current_dir(folder.path()).status()?;
    if !compiled.success() {
        return Err("gcc does not compile the host code".into());
    }
    let said = Command::new(path("speed")).output()?.stdout;
    Ok(String::from_utf8(said)?.trim().parse()?)
}

/// A program that prints packets a second.
fn program(code: &HostCode, frame: &Frame) -> Result<String, std::fmt::Error> {
    let spans = &frame.spans[..frame.spans.len().min(MOST_SPANS)];
    let example = |span| ExampleSpan { frame, span, is_last: false };
    let mut text = "#include <stdio.h>\n#include <time.h>\n#include \"core.h\"\n".to_owned();
    if code.has_frame() {
        let fields = c_frame(code, &example(&spans[0]));
        writeln!(text, "static struct core_frame frame = {{\n{fields}}};")?;
    }
    writeln!(text, "static struct core_span spans[] = {{")?;
    for span in spans {
        writeln!(text, "{{\n{}}},", c_span(code, &example(span)))?;
    }
    let argument = if code.packets_need_the_frame() { "&frame, " } else { "" };
    let (count, passes) = (spans.len(), PACKETS / spans.len());
    writeln!(
        text,
        "}};\nstatic uint32_t words[{count}][CORE_WORDS];\nint main(void) {{\n  int pass, i;\n  \
         clock_t end, begin = clock();\n  for (pass = 0; pass < {passes}; ++pass) \
         {{\n    spans[0].last = pass & 1;\n    for (i = 0; i < {count}; ++i) \
         core_packet({argument}&spans[i], words[i]);\n    __asm__ volatile(\"\" ::: \"memory\");\n  }}\n  \
         end = clock();\n  printf(\"%.0f\\n\", {passes}.0 * {count} * \
         CLOCKS_PER_SEC / (double)(end - begin));\n  return 0;\n}}"
    )?;
    Ok(text)
}
