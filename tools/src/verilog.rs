//! The Verilog file of a core and its header comment. The same spec gives the same lines: there are
//! no dates or paths in them.
use std::path::Path;

use specula_datapath::Design;
use specula_datapath::verilog::{self, Header};
use specula_scene::builtin_names;
use specula_spec::{ANY_METHOD, CoreSpec, SpecFile, TargetClock};

use crate::arguments::{CoreArguments, NameArguments, SceneArguments, WishedMethod};
use crate::made_for::MadeFor;
use crate::ports::{Port, inputs};
use crate::table;
use crate::target_arguments::ANY_DEVICE;

/// The Verilog of a core as text.
pub fn text(origin: &Origin, spec: &CoreSpec, design: &Design) -> String {
    verilog::print(&design.to_block(), &header(origin, spec, design))
}

/// The name of the file that holds the module `module`: lint tools ask for the same name.
pub fn file_name(module: &str) -> String {
    format!("{module}.v")
}

/// The scene and the command, as the header names them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// The scene as the user wrote it; of a path, only the file name.
    pub scene: String,
    /// The command that makes the same Verilog.
    pub command: String,
}

impl Origin {
    /// The origin of a core `spec` that is made for a scene with the arguments `core`, of which the
    /// method is `wished`. The device matters where formats are the cheapest on it.
    pub fn of_scene(
        scene: &SceneArguments,
        core: &CoreArguments,
        wished: Option<WishedMethod>,
        spec: &CoreSpec,
    ) -> Origin {
        let size = scene
            .picture
            .size
            .map(|(width, height)| format!(" --size {width}x{height}"))
            .unwrap_or_default();
        let scene = scene_name(&scene.scene);
        let method = match wished {
            Some(WishedMethod::Auto) => ANY_METHOD,
            _ => spec.method().name(),
        };
        let specialise = core
            .specialise
            .map(|wish| format!(" --specialise {}", wish.name()))
            .unwrap_or_default();
        let formats = core.formats_in_words();
        let device = core
            .made_for
            .device
            .as_ref()
            .filter(|_| core.is_searched_by_proof())
            .map(|device| format!(" --device {}", device.name))
            .unwrap_or_default();
        let target = target_in_words(spec);
        let command = format!(
            "specula generate {}{size} --method {method}{specialise}{formats}{device}{target}",
            quoted(&scene)
        );
        Origin { scene, command }
    }

    /// The origin of a core that was read from a file.
    pub fn of_file(path: &Path, file: &SpecFile) -> Origin {
        let path = path
            .file_name()
            .filter(|_| !path.is_dir())
            .map_or(SpecFile::NAME.into(), |name| name.to_string_lossy());
        Origin {
            scene: file.name.clone(),
            command: format!("specula generate --spec {}", quoted(&printable(&path))),
        }
    }
}

impl Origin {
    /// The origin of a core that is made for another target than its file says.
    pub fn with_target(mut self, spec: &CoreSpec) -> Origin {
        let any_device = || format!(" --target {ANY_DEVICE}");
        let target = spec.target.as_ref().map_or_else(any_device, |_| target_in_words(spec));
        self.command += &target;
        self
    }

    /// The origin of a core that was given a name.
    pub fn with_name(mut self, name: &NameArguments) -> Origin {
        if let Some(name) = &name.name {
            self.command += &format!(" --name {}", quoted(name));
        }
        self
    }
}

/// The arguments that say what a core is made for.
fn target_in_words(spec: &CoreSpec) -> String {
    let words = |TargetClock { name, clock_mhz }: &TargetClock| {
        format!(" --target {name} --clock {clock_mhz}")
    };
    spec.target.as_ref().map(words).unwrap_or_default()
}

fn scene_name(scene: &str) -> String {
    let file = Path::new(scene).file_name().filter(|_| !builtin_names().contains(&scene));
    let name = file.map_or(scene.into(), |file| file.to_string_lossy());
    printable(&name)
}

/// The text without characters that could end the comment's line, or that tools read differently.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect()
}

/// The word quoted for a shell.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._-+,".contains(c);
    if word.chars().all(plain) && !word.starts_with('-') {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// The header of a core's Verilog file.
pub fn header(origin: &Origin, spec: &CoreSpec, design: &Design) -> Header {
    let method = spec.method();
    let mut lines = vec![
        format!(
            "Specula {}: the shading core for the scene {}.",
            env!("CARGO_PKG_VERSION"),
            origin.scene
        ),
        String::new(),
        format!("Method {}: {}.", method.name(), method.summary()),
    ];
    let options: Vec<[String; 2]> =
        spec.options().into_iter().map(|(name, value)| [name.to_owned(), value]).collect();
    lines.extend(indented(&table::lines(&options)));
    lines.push("Values are rounded, to nearest and ties up, in these places and no others. S1.10 has a sign, 1 integer".into());
    lines.push("bit and 10 fraction bits; U has no sign.".into());
    let points = spec.narrowing_points();
    let points: Vec<[String; 3]> = points
        .iter()
        .map(|p| [p.name.to_owned(), p.format.to_string(), p.value.to_owned()])
        .collect();
    lines.extend(indented(&table::lines(&points)));
    let clocks = if design.interval == 1 { "clock" } else { "clocks" };
    lines.push(format!(
        "Initiation interval {} {clocks}; latency {} clocks.",
        design.interval,
        design.latency()
    ));
    lines.push(format!(
        "Error bound: {} of the 8-bit output, against the same method in exact arithmetic.",
        bound(design.error_bound())
    ));
    if let Some(made_for) = MadeFor::of(spec, design) {
        lines.push(format!("Made for {}.", made_for.in_words()));
    }
    lines.extend(inputs_in_words(spec, design));
    let protocol = protocol(design);
    lines.extend(
        ["", &protocol, "", "Made by:"].iter().flat_map(|text| text.split('\n')).map(str::to_owned),
    );
    lines.push(format!("  {}", origin.command));
    lines.push("What Specula emits belongs to whoever ran it.".to_owned());
    Header { lines }
}

/// What each data input is, and how the host computes it.
fn inputs_in_words(spec: &CoreSpec, design: &Design) -> Vec<String> {
    let cells = |port: Port| {
        let Port { name, held_for, unit, meaning, computed, .. } = port;
        let computed = computed.unwrap_or_default();
        [name, format!("a {held_for}"), unit.to_owned(), format!("{meaning}: {computed}")]
    };
    let rows: Vec<[String; 4]> = inputs(spec, design).into_iter().map(cells).collect();
    if rows.is_empty() {
        return vec![];
    }
    let about = "\
Data inputs, for how long they are held, their unit, what they are and how the host computes them,
before it rounds them to the format of the port. L and V = (0, 0, 1) are directions to a light and to
the eye, N is the normal; x is to the right, y up, z to the eye.";
    about.lines().map(str::to_owned).chain(indented(&table::folded(&rows, 100))).collect()
}

/// How the core is fed.
fn protocol(design: &Design) -> String {
    let (entering, leaving) = match design.interval {
        1 => (
            "`valid` is high in each clock in which a pixel enters".to_owned(),
            format!("A pixel that enters in clock c leaves in clock c + {}", design.depth()),
        ),
        clocks => (
            format!("a pixel takes {clocks} clocks, one for each light; `valid` is high in them"),
            format!("A pixel whose last clock is c leaves in clock c + {}", design.depth()),
        ),
    };
    format!(
        "\
Feeding it: {entering}, and `start` in the
first clock of a span only. A span's data inputs are held from its first clock to its last. Between any
two of these clocks there may be any number in which `valid` is low: the core waits, and `start` means
nothing. The next span may follow at once. {leaving}, with
`valid_out` high. Inputs are taken at the rising edge of `clock`. `reset` is synchronous and clears
validity only: data registers have no reset.{}",
        between_frames(design).map(|rule| format!("\n{rule}")).unwrap_or_default()
    )
}

/// When inputs that hold for a frame may change, if there are any.
pub fn between_frames(design: &Design) -> Option<String> {
    let after = design.depth() + 1;
    let then = match design.settling() {
        0 => "in that clock".to_owned(),
        1 => "1 clock later".to_owned(),
        clocks => format!("{clocks} clocks later"),
    };
    (!design.frame_inputs().is_empty()).then(|| {
        format!(
            "Inputs that hold for the frame change between frames only, while no pixel is under way: in clock
c + {after} of the last pixel or later, and the next one may enter {then}."
        )
    })
}

fn indented(text: &str) -> Vec<String> {
    text.lines().map(|line| format!("  {line}")).collect()
}

/// An error bound as text; more than three digits would be of no use.
pub fn bound(lsb: f64) -> String {
    if lsb.is_finite() { format!("{lsb:.3} LSB") } else { "no finite number of LSBs".to_owned() }
}

#[cfg(test)]
mod tests {
    use specula_spec::SceneCore;

    use super::*;
    use crate::arguments::PictureArguments;

    fn origin(scene: &str, size: Option<(u32, u32)>) -> Origin {
        let arguments =
            SceneArguments { scene: scene.to_owned(), picture: PictureArguments { size } };
        let scene = specula_scene::load("icosahedron", Some((8, 6))).expect("it is built in");
        let spec = scene.core_spec(None).expect("it has a core");
        Origin::of_scene(&arguments, &CoreArguments::default(), None, &spec)
    }

    #[test]
    fn commands_name_no_places() {
        let plain = origin("teapot", None);
        assert_eq!(plain.command, "specula generate teapot --method lyon");
        let file = origin("/home/somebody/scans/bunny.ply", Some((64, 48)));
        assert_eq!(
            (file.scene.as_str(), file.command.as_str()),
            ("bunny.ply", "specula generate bunny.ply --size 64x48 --method lyon")
        );
    }

    #[test]
    fn odd_names_stay_on_their_line_and_in_their_word() {
        assert_eq!(
            origin("a\nb c.obj", None).command,
            "specula generate 'a?b c.obj' --method lyon"
        );
        assert_eq!(
            origin("it's.toml", None).command,
            "specula generate 'it'\\''s.toml' --method lyon"
        );
        assert_eq!(origin("\u{e9}t\u{e9}.stl", None).scene, "?t?.stl");
    }
}
