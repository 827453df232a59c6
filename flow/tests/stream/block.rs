//! A block's files in a folder of their own, and frames for it.
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use specula_fixtures::few_spans;
use specula_flow::host::HostCode;
use specula_flow::stream::{File, FrameVectors, Handshake, StreamCore, StreamShape, files};
use specula_scene::{Frame, Needs};
use specula_spec::{CoreOptions, CoreSpec, Method, Positions, SpecFile, WordWidth};
use specula_testbench::{FrameSpans, expected_codes};
use tempfile::TempDir;

/// A block's files.
pub struct Block {
    folder: TempDir,
    pub words_a_packet: u32,
    pub latency: u32,
    /// What the data sheet draws.
    pub handshake: Handshake,
}

/// Every shape of streams.
pub fn shapes() -> Vec<StreamShape> {
    let positions = [Positions::Sent, Positions::Absent];
    let shape = |word: WordWidth| positions.map(|positions| StreamShape { word, positions });
    WordWidth::ALL.into_iter().flat_map(shape).collect()
}

/// Two frames of some spans of one material, which a core of their needs may shade one after the
/// other: in the second the lights have changed places and all colours are another.
pub fn frames(seed: u64) -> Vec<Frame> {
    let mut frame = few_spans::frame(seed, 2, 12);
    frame.materials.truncate(1);
    frame.triangles.iter_mut().for_each(|triangle| triangle.material = 0);
    let mut later = frame.clone();
    later.lights.reverse();
    later.spans.truncate(7);
    for material in &mut later.materials {
        material.diffuse = [0.1, 0.4, 0.2];
        material.specular = [0.3, 0.1, 0.5];
    }
    vec![frame, later]
}

/// A core of a method for the needs of the first frame, whatever it is given.
pub fn core(method: Method, frames: &[Frame], shared: bool) -> CoreSpec {
    let pipelines = if shared { "shared" } else { "each" };
    let options: CoreOptions =
        format!("light_pipelines = \"{pipelines}\"").parse().expect("it is TOML");
    CoreSpec::for_scene(&Needs::of(&frames[0]), Some(&options), Some(method)).expect("it is one")
}

/// The name of every core.
const NAME: &str = "shader";

/// What `used` makes of a core with streams and of these frames' vectors.
pub fn with_core<T>(
    spec: &CoreSpec,
    frames: &[Frame],
    shape: StreamShape,
    used: impl FnOnce(&StreamCore, &[FrameVectors]) -> T,
) -> T {
    let design = specula_hdl::elaborate(spec, NAME).expect("it can be built");
    let text = SpecFile { name: NAME.to_owned(), spec: spec.clone() }.text();
    let vectors = |frame: &Frame| {
        let spans = FrameSpans::new(frame, spec);
        let codes = expected_codes(spec, &spans, frame.spans.len()).expect("packets fit");
        FrameVectors::new(&frame.spans, &spans, &codes)
    };
    let vectors: Vec<FrameVectors> = frames.iter().map(vectors).collect();
    used(&StreamCore::new(spec, &design, shape, &text), &vectors)
}

impl Block {
    /// Writes the files of a core with these frames as vectors.
    pub fn new(spec: &CoreSpec, frames: &[Frame], shape: StreamShape) -> Block {
        with_core(spec, frames, shape, |core, vectors| {
            let folder = TempDir::new().expect("there is room for a folder");
            let header = specula_datapath::verilog::Header::default();
            let text = specula_datapath::verilog::print(&core.design.to_block(), &header);
            let own = File { name: format!("{NAME}.v"), text };
            let call = HostCode::new(core).call();
            let files = files(core, vectors, "specula generate", call);
            for File { name, text } in files.iter().chain([&own]) {
                fs::write(folder.path().join(name), text).expect("a file can be written");
            }
            let handshake = Handshake::new(core, vectors).expect("there is a span");
            let (words_a_packet, latency) = (core.words(), core.design.latency());
            Block { folder, words_a_packet, latency, handshake }
        })
    }

    /// The texts of all files.
    pub fn files(&self) -> Vec<File> {
        let file = |name: String| {
            let text = fs::read_to_string(self.path(&name)).expect("the file is there");
            File { name, text }
        };
        self.names().into_iter().map(file).collect()
    }

    /// The path of a file.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The names of all files.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).expect("the folder is there");
        let name = |entry: std::io::Result<fs::DirEntry>| {
            entry.expect("it can be read").file_name().to_string_lossy().into_owned()
        };
        entries.map(name).collect()
    }

    /// Changes the lowest bit of an expected pixel.
    pub fn spoil_pixel(&self, number: usize) {
        let path = self.path("shader_pixels.hex");
        let text = fs::read_to_string(&path).expect("the file is there");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let line = &mut lines[1 + number];
        let value = u64::from_str_radix(line, 16).expect("it is a number");
        *line = format!("{:0width$x}", value ^ 1, width = line.len());
        fs::write(path, lines.join("\n")).expect("it can be written");
    }

    /// Runs `make`, which has to succeed, and gives what it prints.
    pub fn make(&self, arguments: &[&str]) -> String {
        let (succeeded, said) = self.run("make", arguments);
        assert!(succeeded, "{arguments:?}: {said}");
        said
    }

    /// Runs a program in the folder; whether it succeeds, and what it prints.
    pub fn run(&self, program: &str, arguments: &[&str]) -> (bool, String) {
        let folder: &Path = self.folder.path();
        let ended = Command::new(program)
            .args(arguments)
            .current_dir(folder)
            .output()
            .expect("the program runs");
        let said = [ended.stdout, ended.stderr].concat();
        (ended.status.success(), String::from_utf8_lossy(&said).into_owned())
    }
}
