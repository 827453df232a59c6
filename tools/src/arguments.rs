//! Arguments that several subcommands share, and their meaning.
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use specula_experiments::auto;
use specula_experiments::formats::{
    self, DefaultCore, FAITHFUL, Products, core_of_sequence, default_core,
};
use specula_experiments::search::{self, Measured};
use specula_hdl::module_name;
use specula_scene::picture::limits;
use specula_scene::{Frame, LoadedScene};
use specula_spec::{
    ANY_METHOD, CoreSpec, Frames, Method, SceneCore, SpecFile, Specialise, UnnamedFormats,
};
use specula_testbench::EngineKind;
use specula_testbench::trace::Choice;

use crate::error::ToolError;
use crate::target_arguments::TargetArguments;

/// The folder to be written.
#[derive(Clone, Debug, Args)]
pub struct OutputArguments {
    /// Folder to write [default: out/NAME, by the scene's name]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

impl OutputArguments {
    /// The folder to write for something called `name`.
    pub fn folder(&self, name: &str) -> PathBuf {
        self.output.clone().unwrap_or_else(|| PathBuf::from("out").join(name))
    }
}

/// The name of the core.
#[derive(Clone, Debug, Default, Args)]
pub struct NameArguments {
    /// Name of the core's module and of its file, such as shader_2 [default: the scene's]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
}

impl NameArguments {
    /// Gives the core the name that the user asked for, if any.
    ///
    /// # Errors
    /// [`ToolError::Name`] if a Verilog module cannot have that name.
    pub fn rename(&self, file: &mut SpecFile) -> Result<(), ToolError> {
        let Some(name) = &self.name else { return Ok(()) };
        let possible: String =
            module_name(name, &file.spec).chars().take(SpecFile::LONGEST_NAME).collect();
        if possible != *name {
            return Err(ToolError::Name { name: name.clone(), possible });
        }
        file.name.clone_from(name);
        Ok(())
    }
}

/// The scene and the size of its picture.
#[derive(Clone, Debug, Args)]
pub struct SceneArguments {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    pub scene: String,
    #[command(flatten)]
    pub picture: PictureArguments,
}

impl SceneArguments {
    /// Loads the scene in that size.
    pub fn load(&self) -> Result<LoadedScene, ToolError> {
        Ok(crate::scene::load(&self.scene, self.picture.size)?)
    }

    /// Loads the scene for a command that looks at one frame alone, which is told if there are more.
    pub fn load_frame(&self) -> Result<LoadedScene, ToolError> {
        let mut scene = self.load()?;
        if let Some(sequence) = scene.sequence.take() {
            let frames = sequence.frames();
            let which = match scene.number {
                0 => format!("the first of {frames} alone is looked at"),
                number => format!(
                    "frame {number} alone is looked at, the first of {frames} in which something is visible"
                ),
            };
            // A closed standard error is no reason to stop.
            let _ = writeln!(io::stderr(), "frames: {which}");
        }
        Ok(scene)
    }
}

/// The size of a scene's picture.
#[derive(Clone, Debug, Default, Args)]
pub struct PictureArguments {
    /// Width and height of the picture in pixels, such as 640x480 [default: what the scene says]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = parse_size)]
    pub size: Option<(u32, u32)>,
}

/// The core that the user asks for.
#[derive(Clone, Debug, Default, Args)]
pub struct CoreArguments {
    /// Shading method; auto chooses the smallest core whose total error stays within 2 LSB on a sample
    /// of pixels [default: what the scene says, else auto]
    #[arg(long, value_parser = wished_method_parser())]
    pub method: Option<WishedMethod>,
    /// A core for this scene alone, without what the scene does not need, or a general one
    /// [default: what the scene says, else scene]
    #[arg(long, value_name = "FOR", value_parser = specialise_parser())]
    pub specialise: Option<Specialise>,
    /// Formats that the scene does not name: faithful, the cheapest for which the quantisation error
    /// is proven to be below 1 LSB; or recommended, without a search [default: what the scene says,
    /// else faithful]
    #[arg(long, value_name = "FORMATS", value_parser = formats_parser(), conflicts_with_all = ["bound", "max_error", "max_quantisation"])]
    pub formats: Option<UnnamedFormats>,
    /// Find the cheapest formats for which the quantisation error is proven to be below this, such
    /// as 0.75lsb, without shading a pixel
    #[arg(long, value_name = "LSB", allow_hyphen_values = true, value_parser = parse_error, conflicts_with_all = ["max_error", "max_quantisation"])]
    pub bound: Option<f64>,
    /// Narrow all formats as far as the total error against exact shading, measured on every pixel
    /// of this scene, stays within this, such as 2lsb
    #[arg(long, value_name = "LSB", allow_hyphen_values = true, value_parser = parse_error, conflicts_with = "max_quantisation")]
    pub max_error: Option<f64>,
    /// The same for the quantisation error alone, against exact shading by the method
    #[arg(long, value_name = "LSB", allow_hyphen_values = true, value_parser = parse_error)]
    pub max_quantisation: Option<f64>,
    #[command(flatten)]
    pub made_for: TargetArguments,
}

impl CoreArguments {
    /// The core for a scene.
    pub fn core(&self, scene: &LoadedScene) -> Result<DefaultCore, ToolError> {
        let DefaultCore { spec, not_faithful } = self.in_formats(scene)?;
        Ok(DefaultCore { spec: self.made_for.made_for(spec)?, not_faithful })
    }

    /// The core for a scene, for no clock in particular, in the formats that are asked for.
    fn in_formats(&self, scene: &LoadedScene) -> Result<DefaultCore, ToolError> {
        if self.measured().is_some() && scene.sequence.is_some() {
            return Err(ToolError::MeasuredSequence);
        }
        let spec = match self.wished_method(scene)? {
            Some(WishedMethod::Named(method)) => scene.core_spec(Some(method))?,
            Some(WishedMethod::Auto) => chosen(scene, &self.made_for.products()?)?,
            None => scene.core_spec(None)?,
        };
        if let Some(lsb) = scene.refused_wraps(&spec)? {
            // A closed standard error is no reason to stop.
            let _ = writeln!(
                io::stderr(),
                "places: true directions: wrapped ones may move colours of this scene by {lsb:.1} LSB"
            );
        }
        let start = specialised(spec.clone(), self.specialise, &scene.frame);
        match (self.measured(), &scene.sequence) {
            (Some(goal), _) => self.as_measured(&spec, &scene.frame, goal),
            (None, Some(sequence)) if !start.specialisation.is_general() => {
                let below = self.bound.unwrap_or(FAITHFUL);
                let search = |start, frames: &[Frame]| self.as_proven(start, scene, frames);
                core_of_sequence(&start, sequence, below, search)
            }
            (None, _) => self.as_proven(start, scene, &scene.frame),
        }
    }

    /// The method that is asked for here, or left open by the scene; `None` if the scene decides.
    pub fn wished_method(&self, scene: &LoadedScene) -> Result<Option<WishedMethod>, ToolError> {
        let open = scene.leaves_method_open()?.then_some(WishedMethod::Auto);
        Ok(self.method.or(open))
    }

    /// The core in the narrowest formats whose error, measured on every pixel, stays within a goal.
    fn as_measured(
        &self,
        spec: &CoreSpec,
        frame: &Frame,
        goal: (Measured, f64),
    ) -> Result<DefaultCore, ToolError> {
        // The search for narrow formats starts from the general core.
        let general = spec.specialisation.is_general();
        let wish = self.specialise.or((!general).then_some(Specialise::Scene));
        let spec = specialised(search::narrowest_formats(spec, frame, goal)??, wish, frame);
        Ok(DefaultCore { spec, not_faithful: None })
    }

    /// The core in formats for which a bound is proven, of which it starts in others.
    fn as_proven<'a>(
        &self,
        start: CoreSpec,
        scene: &LoadedScene,
        frames: impl Into<Frames<'a>>,
    ) -> Result<DefaultCore, ToolError> {
        let products = self.made_for.products()?;
        let kept = &scene.named_formats(start.method())?;
        if let Some(below) = self.bound {
            let wanted = formats::Wanted { below, products, kept };
            let spec = formats::cheapest_formats(&start, frames, &wanted)??.spec;
            return Ok(DefaultCore { spec, not_faithful: None });
        }
        Ok(match self.formats.map_or_else(|| scene.unnamed_formats(), Ok)? {
            UnnamedFormats::Faithful => default_core(start, frames, kept, products)?,
            UnnamedFormats::Recommended => DefaultCore { spec: start, not_faithful: None },
        })
    }

    /// The error that is to be measured, and the most that it may be, in LSBs.
    fn measured(&self) -> Option<(Measured, f64)> {
        let total = self.max_error.map(|most| (Measured::Total, most));
        total.or(self.max_quantisation.map(|most| (Measured::Quantisation, most)))
    }

    /// Whether formats depend on what products take: they do where the cheapest ones within a bound
    /// are looked for.
    pub fn is_searched_by_proof(&self) -> bool {
        self.measured().is_none() && self.formats != Some(UnnamedFormats::Recommended)
    }

    /// The arguments that ask for formats, as they are written.
    pub fn formats_in_words(&self) -> String {
        let asked = [
            ("bound", self.bound),
            ("max-error", self.max_error),
            ("max-quantisation", self.max_quantisation),
        ];
        let word = |(name, lsb): (&str, Option<f64>)| Some(format!(" --{name} {}lsb", lsb?));
        let unnamed = self.formats.map(|formats| format!(" --formats {}", formats.name()));
        asked.into_iter().filter_map(word).chain(unnamed).collect()
    }
}

/// The core that is chosen where any method will do, in recommended formats; what it was chosen for
/// goes to standard error.
fn chosen(scene: &LoadedScene, products: &Products) -> Result<CoreSpec, ToolError> {
    let choice = auto::choose(scene, auto::GOAL, products)?;
    // A closed standard error is no reason to stop.
    let _ = writeln!(io::stderr(), "method: {}", choice.in_words());
    Ok(scene.as_wished(choice.spec)?)
}

/// The core for a frame, specialised as `--specialise` says; unchanged without the option.
fn specialised(spec: CoreSpec, wish: Option<Specialise>, frame: &Frame) -> CoreSpec {
    match wish {
        None => spec,
        Some(Specialise::Scene) => spec.specialised(frame),
        Some(Specialise::General) => spec.general(),
    }
}

/// Parses an error or a bound, in LSBs of the 8-bit output.
pub fn parse_error(text: &str) -> Result<f64, String> {
    let number = text
        .strip_suffix("lsb")
        .unwrap_or(text)
        .parse::<f64>()
        .ok()
        .filter(|lsb| *lsb > 0.0 && *lsb <= 255.0);
    number.ok_or_else(|| {
        "write a number of LSBs of the 8-bit output above 0 and up to 255, as in 1lsb".to_owned()
    })
}

/// Parses `--size`.
pub fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let number = |digits: &str| {
        digits.parse::<u32>().ok().filter(|_| digits.bytes().all(|b| b.is_ascii_digit()))
    };
    let numbers =
        text.split_once('x').and_then(|(width, height)| Some((number(width)?, number(height)?)));
    let size = numbers.ok_or("write width and height in pixels, as in 640x480")?;
    if limits::is_allowed(size) { Ok(size) } else { Err(limits::described()) }
}

/// Parses `--trace`.
pub fn parse_choice(text: &str) -> Result<Choice, String> {
    match (text, text.split_once('=')) {
        ("worst", _) => Ok(Choice::Worst),
        ("none", _) => Ok(Choice::None),
        ("all", _) => Ok(Choice::All),
        (_, Some(("span", number))) => number
            .parse()
            .map(Choice::Span)
            .map_err(|_| "write the number of a span, as in span=12".into()),
        (_, Some(("cycles", range))) => parse_cycles(range).map(Choice::Cycles),
        _ => Err("write worst, none, all, span=N or cycles=A..B".to_owned()),
    }
}

fn parse_cycles(text: &str) -> Result<std::ops::Range<u64>, String> {
    let ends = text.split_once("..").and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
    let (first, end) =
        ends.ok_or("write the first cycle and the one behind the last, as in cycles=100..300")?;
    if first < end {
        Ok(first..end)
    } else {
        Err(format!("{first}..{end} is empty: the first number must be the smaller one"))
    }
}

/// Parses `--method`.
pub fn method_parser() -> impl TypedValueParser<Value = Method> {
    PossibleValuesParser::new(Method::ALL.map(Method::name))
        .try_map(|name| Method::from_name(&name))
}

/// The method that a core is asked to have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WishedMethod {
    /// The smallest core that is near enough to exact shading, by whatever method.
    Auto,
    /// One by name.
    Named(Method),
}

/// Parses a method that may be left to Specula.
pub fn wished_method_parser() -> impl TypedValueParser<Value = WishedMethod> {
    let names = Method::ALL.map(Method::name).into_iter().chain([ANY_METHOD]);
    PossibleValuesParser::new(names).try_map(|name| match name.as_str() {
        ANY_METHOD => Ok(WishedMethod::Auto),
        name => Method::from_name(name).map(WishedMethod::Named),
    })
}

/// The methods that `--methods` names, each once and in their usual order; all methods if it names
/// none.
pub fn selected_methods(named: &[Method]) -> Vec<Method> {
    Method::ALL.into_iter().filter(|method| named.is_empty() || named.contains(method)).collect()
}

/// Parses `--specialise`.
pub fn specialise_parser() -> impl TypedValueParser<Value = Specialise> {
    PossibleValuesParser::new(Specialise::ALL.map(Specialise::name)).try_map(|name| {
        Specialise::ALL.into_iter().find(|wish| wish.name() == name).ok_or("there is no such wish")
    })
}

/// Parses `--formats`.
fn formats_parser() -> impl TypedValueParser<Value = UnnamedFormats> {
    PossibleValuesParser::new(UnnamedFormats::ALL.map(UnnamedFormats::name)).try_map(|name| {
        let named = |formats: &UnnamedFormats| formats.name() == name;
        UnnamedFormats::ALL.into_iter().find(named).ok_or("there are no such formats")
    })
}

/// Parses `--engine`.
pub fn engine_parser() -> impl TypedValueParser<Value = EngineKind> {
    let names = EngineKind::ALL.iter().map(|engine| engine.name());
    PossibleValuesParser::new(names).try_map(|name| {
        EngineKind::ALL
            .into_iter()
            .find(|engine| engine.name() == name)
            .ok_or("there is no such engine")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_or_refused() {
        assert_eq!(parse_size("640x480"), Ok((640, 480)));
        for text in [
            "",
            "x",
            "640",
            "640x",
            "x480",
            "640X480",
            "+1x1",
            "-1x4",
            "1x1x1",
            "1 x1",
            "4294967296x1",
            "NaNx1",
            "6\u{664}x1",
        ] {
            assert_eq!(
                parse_size(text),
                Err("write width and height in pixels, as in 640x480".into()),
                "{text}"
            );
        }
        for text in ["0x0", "0x480", "8193x1", "100000x100000", "4294967295x4294967295"] {
            assert_eq!(parse_size(text), Err(limits::described()), "{text}");
        }
    }

    #[test]
    fn traces_are_read_or_refused() {
        assert_eq!(parse_choice("worst"), Ok(Choice::Worst));
        assert_eq!(parse_choice("none"), Ok(Choice::None));
        assert_eq!(parse_choice("all"), Ok(Choice::All));
        assert_eq!(parse_choice("span=3"), Ok(Choice::Span(3)));
        assert_eq!(parse_choice("cycles=10..20"), Ok(Choice::Cycles(10..20)));
        for text in [
            "",
            "best",
            "worst=",
            "worst=1",
            "span",
            "span=",
            "span=-1",
            "span=x",
            "cycles",
            "cycles=5",
            "cycles=5..",
            "cycles=5..5",
            "cycles=9..2",
        ] {
            assert!(parse_choice(text).is_err(), "{text}");
        }
    }
}
