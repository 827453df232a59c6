//! Cores with what hosts are given for the spans of a frame, and what hosts have to make of it.
use specula_datapath::Design;
use specula_fixtures::{Draw, any_spec, few_spans};
use specula_flow::host::{ExampleSpan, Holder, HostCode, Kind, Source, files, host_value};
use specula_flow::stream::{StreamCore, StreamShape};
use specula_scene::{Frame, Needs, Span, load};
use specula_spec::{
    CoreSpec, Method, Positions, SceneCore, SetUp, SpanHeader, Specialise, WordWidth,
};

/// A core, and the spans of a frame.
pub struct HostedCore {
    pub name: String,
    pub spec: CoreSpec,
    design: Design,
    shape: StreamShape,
    pub frame: Frame,
}

/// What the code of a language gives.
pub struct HostResult {
    /// Addresses and words.
    pub registers: Vec<(u32, u32)>,
    /// The words of all packets.
    pub words: Vec<u64>,
}

/// The cores of a method for built-in scenes of these names, as a small picture: made for the scene,
/// or for any.
pub fn built_in(method: Method, names: &[&str], made_for: Specialise) -> Vec<HostedCore> {
    let mut cores = vec![];
    for name in names {
        let scene = load(name, Some((96, 72))).expect("it is built in");
        let spec = scene.core_spec(Some(method)).expect("every method serves it");
        let shape = StreamShape { word: WordWidth::Bits32, positions: Positions::Sent };
        let spec = match made_for {
            Specialise::Scene => spec,
            Specialise::General => spec.general(),
        };
        let name = format!("{name}_{}", made_for.name());
        cores.extend(HostedCore::new(name, spec, shape, scene.frame));
    }
    cores
}

/// Cores of a method with options and formats at random.
pub fn drawn(method: Method, draw: &mut Draw) -> Vec<HostedCore> {
    let mut cores = vec![];
    for number in 0..8 {
        let mut frame = few_spans::frame(number, if number > 4 { 3 } else { 2 }, 40);
        let keeps = number % 3 == 0;
        if number > 4 {
            few_spans::place_lights(&mut frame);
        }
        if keeps {
            frame.materials.truncate(1);
            frame.triangles.iter_mut().for_each(|triangle| triangle.material = 0);
        }
        let spec = any_spec(&Needs::of(&frame), method, |low, high| {
            draw.between(low.into(), high.into()) as u32
        });
        let spec = if number % 2 == 0 { spec.specialised(&frame) } else { spec };
        let word = WordWidth::ALL[number as usize / 2 % 2];
        let positions = if number % 4 == 0 { Positions::Sent } else { Positions::Absent };
        let shape = StreamShape { word, positions };
        cores.extend(HostedCore::new(format!("drawn{number}"), spec, shape, frame));
    }
    cores
}

/// The general core of a method for the teapot, with options.
pub fn with_options(method: Method, options: &str) -> HostedCore {
    let frame = load("teapot", Some((96, 72))).expect("it is built in").frame;
    let table = format!("[{}]\n{options}", method.name()).parse().expect("it is TOML");
    let spec = CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(method));
    let shape = StreamShape { word: WordWidth::Bits32, positions: Positions::Sent };
    HostedCore::new("teapot".to_owned(), spec.expect("the method serves it"), shape, frame)
        .expect("it can be built")
}

impl HostedCore {
    /// The core of a spec. None where it cannot be built.
    fn new(name: String, spec: CoreSpec, shape: StreamShape, frame: Frame) -> Option<HostedCore> {
        let design = specula_hdl::elaborate(&spec, &name).ok()?;
        Some(HostedCore { name, spec, design, shape, frame })
    }

    /// The block of the core.
    pub fn stream(&self) -> StreamCore<'_> {
        StreamCore::new(&self.spec, &self.design, self.shape, "")
    }

    /// Bits of a word.
    pub fn word_bits(&self) -> u32 {
        self.shape.word.bits()
    }

    /// The text of a file of its host code.
    pub fn text(&self, suffix: &str) -> String {
        let example =
            ExampleSpan { frame: &self.frame, span: &self.frame.spans[0], is_last: false };
        let name = format!("{}{suffix}", self.name);
        let stream = self.stream();
        let mut files = files(&HostCode::new(&stream), &example).into_iter();
        files.find(|file| file.name == name).expect("it is written").text
    }

    /// What its host code says of itself.
    pub fn with_code<T>(&self, look: impl FnOnce(&HostCode) -> T) -> T {
        look(&HostCode::new(&self.stream()))
    }

    /// The values that a host has: those of the frame, and those of each span, in the order in which
    /// structs have them, the material's last.
    pub fn values(&self) -> Vec<f64> {
        self.with_code(|code| {
            let mut values = vec![];
            let spans = &self.frame.spans;
            let mut add = |span: &Span, sources: Vec<&Source>| {
                for source in sources {
                    values.extend(
                        host_value(&self.spec, &self.frame, span, source).expect("it is known"),
                    );
                }
            };
            add(&spans[0], code.frame_sources());
            let mut rows = vec![];
            for span in spans {
                let header = self.header(span);
                let [x, y] = header.position;
                rows.extend([header.pixels, u32::from(header.last), x, y].map(f64::from));
                for source in code.span_sources() {
                    rows.extend(
                        host_value(&self.spec, &self.frame, span, source).expect("it is known"),
                    );
                }
            }
            values.extend(rows);
            values
        })
    }

    /// How many spans there are.
    pub fn spans(&self) -> usize {
        self.frame.spans.len()
    }

    fn header(&self, span: &Span) -> SpanHeader {
        let last = self.frame.spans.last() == Some(span);
        SpanHeader { pixels: span.length, last, position: [span.x, span.y] }
    }

    /// Whether its host code may compute with float.
    pub fn has_float(&self) -> bool {
        HostCode::new(&self.stream()).has_float()
    }

    /// What Rust's set-up gives.
    pub fn expected(&self) -> HostResult {
        let (core, set_up) = (self.stream(), SetUp::new(&self.spec, &self.frame));
        let (mut words, mut registers) = (vec![], vec![]);
        for (number, span) in self.frame.spans.iter().enumerate() {
            let mut inputs = vec![];
            set_up.append(span, &mut inputs);
            words.extend(core.layout.pack(&self.header(span), &inputs, self.shape.word));
            if number == 0 {
                let of = core.frame_inputs();
                registers = of.iter().flat_map(|input| input.words(inputs[input.number])).collect();
            }
        }
        HostResult { registers, words }
    }

    /// Asserts that a language's code gives the very words of Rust's.
    pub fn assert_words(&self, language: &str, result: &HostResult) {
        let expected = self.expected();
        let name = format!("{language}, {}: {:?}", self.name, self.spec);
        assert_eq!(result.registers, expected.registers, "{name}");
        assert_eq!(result.words.len(), expected.words.len(), "{name}");
        let per_packet = expected.words.len() / self.spans();
        for (place, (own, other)) in result.words.iter().zip(&expected.words).enumerate() {
            let (span, word) = (place / per_packet, place % per_packet);
            assert_eq!(own, other, "span {span}, word {word}: {own:x}, {other:x}; {name}");
        }
    }
}

/// How many numbers a value has.
pub fn length(source: &Source) -> usize {
    match source.kind {
        Kind::Vector | Kind::Colour => 3,
        Kind::Real | Kind::Whole | Kind::Steps => 1,
    }
}

/// Whether a value belongs to a material.
pub fn is_of_material(source: &Source) -> bool {
    source.holder == Holder::Material
}
