//! `.ply` files as different programs write them, each of the same shape.
use super::shape::Shape;

/// A text file of a shape, in which lines and words can be replaced.
#[derive(Clone, Debug)]
pub struct Text {
    /// Lines before the elements of vertices.
    pub header: Vec<String>,
    pub vertices: Vec<String>,
    pub faces: Vec<String>,
}

impl Text {
    /// The file as most programs write it.
    pub fn plain(shape: &Shape) -> Text {
        Text::with(shape, "float x|float y|float z", |[x, y, z]| format!("{x} {y} {z}"))
    }

    /// A file with these properties of vertices, each line of them written from a place.
    pub fn with(shape: &Shape, properties: &str, vertex: impl Fn([f32; 3]) -> String) -> Text {
        let mut header = vec![
            "ply".into(),
            "format ascii 1.0".into(),
            format!("element vertex {}", shape.positions.len()),
        ];
        header.extend(properties.split('|').map(|property| format!("property {property}")));
        header.push(format!("element face {}", shape.triangles.len()));
        header.push("property list uchar int vertex_indices".into());
        header.push("end_header".into());
        let vertices = shape.positions.iter().map(|p| vertex(*p)).collect();
        Text {
            header,
            vertices,
            faces: shape.triangles.iter().map(|[a, b, c]| format!("3 {a} {b} {c}")).collect(),
        }
    }

    /// Inserts a line of the header before line `at`, counted from 0.
    pub fn insert(mut self, at: usize, line: &str) -> Text {
        self.header.insert(at, line.into());
        self
    }

    /// The file, lines ended by `end`; a `?` stands for a byte that is not UTF-8.
    pub fn file(&self, end: &str) -> Vec<u8> {
        let lines = [&self.header[..], &self.vertices, &self.faces].concat();
        let text = lines.iter().map(|line| format!("{line}{end}")).collect::<String>();
        text.bytes().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect()
    }
}

/// Order of bytes in a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    Little,
    Big,
}

/// A binary file: places in floats behind a list of bytes that nobody needs, faces behind a number,
/// lines of the header ended by `end`.
pub fn binary(shape: &Shape, order: Order, end: &str) -> Vec<u8> {
    let name = if order == Order::Little { "binary_little_endian" } else { "binary_big_endian" };
    let header = format!(
        "ply|format {name} 1.0|comment ?|element vertex {}|property list uint8 char junk|property float32 x|property float32 y|\
         property float32 z|element face {}|property float64 quality|property list ushort uint32 vertex_index|end_header|",
        shape.positions.len(),
        shape.triangles.len()
    );
    let mut file: Vec<u8> = header
        .replace('|', end)
        .bytes()
        .map(|byte| if byte == b'?' { 0xff } else { byte })
        .collect();
    let mut number = |bytes: &[u8]| match order {
        Order::Little => file.extend(bytes),
        Order::Big => file.extend(bytes.iter().rev()),
    };
    for (k, position) in shape.positions.iter().enumerate() {
        // The first byte is a line feed where there are ten.
        let junk = [10, 0, 3][k % 3];
        number(&[junk]);
        (0..junk).for_each(|byte| number(&[byte]));
        position.iter().for_each(|x| number(&x.to_le_bytes()));
    }
    for triangle in &shape.triangles {
        number(&f64::NAN.to_le_bytes());
        number(&3_u16.to_le_bytes());
        triangle.iter().for_each(|k| number(&k.to_le_bytes()));
    }
    file
}

/// Files that show the shape, each in a dialect of its own, with its name. Their vertices and
/// triangles are those of the shape.
pub fn dialects(shape: &Shape) -> Vec<(String, Vec<u8>)> {
    let files =
        [numbers(shape), beside(shape), strips(shape), lines(shape), binaries(shape)].concat();
    files.into_iter().map(|(name, file)| (format!("{name}.ply"), file)).collect()
}

type Files = Vec<(String, Vec<u8>)>;

/// Numbers in different forms.
fn numbers(shape: &Shape) -> Files {
    let places = "float x|float y|float z";
    let file = |name: &str, form: fn(f32) -> String| {
        let text = Text::with(shape, places, |p| p.map(form).join(" "));
        (name.to_owned(), text.file("\n"))
    };
    let doubles = Text::with(shape, "double x|float64 y|double z", |p| {
        p.map(|x| f64::from(x).to_string()).join(" ")
    });
    let mut counts = Text::plain(shape);
    counts.faces = shape
        .triangles
        .iter()
        .map(|[a, b, c]| format!("3.0 +{a} {b}.000000e+00 0x{c:x}"))
        .collect();
    vec![
        file("plus-signs", |x| format!("{x:+}")),
        file("exponents", exponent),
        file("no-digit-before-the-point", |x| {
            let text = x.to_string();
            text.strip_prefix("0.").map_or(text.clone(), |digits| format!(".{digits}"))
        }),
        file("no-digit-behind-the-point", |x| {
            if x.fract() == 0.0 { format!("{x}.") } else { format!("{x}") }
        }),
        file("hexadecimal", hexadecimal),
        file("decimal-commas", |x| x.to_string().replace('.', ",")),
        ("doubles".into(), doubles.file("\n")),
        ("indices-as-fractions".into(), counts.file("\n")),
    ]
}

/// As C's `%e` prints it.
fn exponent(x: f32) -> String {
    let text = format!("{x:.9e}");
    let (digits, power) = text.split_once('e').expect("it has a power");
    let power: i32 = power.parse().expect("it is a number");
    format!("{digits}e{}{:02}", if power < 0 { '-' } else { '+' }, power.abs())
}

/// As C's `%a` prints it, for normal numbers and 0.
fn hexadecimal(x: f32) -> String {
    let bits = f64::from(x).to_bits();
    let (sign, power, digits) =
        (if bits >> 63 == 1 { "-" } else { "" }, (bits >> 52 & 0x7ff) as i32, bits << 12 >> 12);
    if power == 0 {
        format!("{sign}0x0p+0")
    } else {
        format!("{sign}0x1.{digits:013x}p{:+}", power - 1023)
    }
}

/// What stands beside what is needed.
fn beside(shape: &Shape) -> Files {
    let places = "float x|float y|float z";
    let normals = format!("{places}|float nx|float ny|float nz");
    let with = |properties: &str, behind: &'static str| {
        Text::with(shape, properties, |[x, y, z]| format!("{x} {y} {z}{behind}"))
    };
    let before = |properties: &str, words: &'static str| {
        Text::with(shape, properties, |[x, y, z]| format!("{words} {x} {y} {z}"))
    };
    let file = |name: &str, text: Text| (name.to_owned(), text.file("\n"));
    let mut files: Files =
        ["nan", "-nan", "nan(ind)", "-nan(ind)", "1.#QNAN", "-1.#IND00", "inf", "1.#INF", "0"]
            .into_iter()
            .map(|word| {
                let text = Text::with(shape, &normals, |[x, y, z]| {
                    format!("{x} {y} {z} {word} {word} {word}")
                });
                (
                    format!(
                        "normals-{}",
                        word.trim_end_matches(['(', ')']).replace(['#', '(', ')'], "-")
                    ),
                    text.file("\n"),
                )
            })
            .collect();
    let mut ended = Text::plain(shape);
    ended.faces.push("and that is all".into());
    let mut blank = Text::plain(shape);
    blank.vertices.insert(0, " \t".into());
    blank.faces.insert(1, String::new());
    let mut words = Text::plain(shape);
    words.vertices[0].push_str("  255 0 0");
    let plain_faces = Text::plain(shape).faces;
    let mut edges = Text::plain(shape)
        .insert(2, "element edge 2")
        .insert(3, "property int a")
        .insert(4, "property list int float ?");
    edges.vertices.splice(0..0, ["0 2 nan some".to_owned(), "word 0".to_owned()]);
    let mut short = Text::plain(shape);
    short.header = short
        .header
        .iter()
        .map(|line| {
            line.replace(
                &format!("face {}", plain_faces.len()),
                &format!("face {}", plain_faces.len() + 2),
            )
        })
        .collect();
    short.faces.insert(0, "2 0 1".into());
    short.faces.push("0".into());
    files.extend([
        file("plain", Text::plain(shape)),
        file("quality-nan", with(&format!("{places}|float quality"), " nan")),
        file("quality-word", before(&format!("int quality|{places}"), "none")),
        file(
            "list-in-vertices",
            before(&format!("list uint8 float junk|uchar red|{places}"), "3 a nan 1e999 ???"),
        ),
        file("two-normals", with(&format!("{places}|float nx|float ny"), " x y")),
        file(
            "comments",
            Text::plain(shape)
                .insert(1, "comment ?t?")
                .insert(2, "obj_info ?")
                .insert(3, "comment")
                .insert(4, ""),
        ),
        file("names", with(&format!("{places}|uchar ??"), " 7")),
        file("words-behind-the-last", words),
        file("lines-behind-the-last", ended),
        file("blank-lines", blank),
        file("other-elements", edges),
        file("short-faces", short),
        file(
            "empty-elements",
            Text::plain(shape)
                .insert(2, "element nothing 3")
                .insert(3, "element none 0")
                .insert(4, "property int a"),
        ),
        file("trailing-blanks", with(places, "\t \u{b}")),
        file("unused-vertices", unused(shape)),
        ("mark".into(), [b"\xef\xbb\xbf", &Text::plain(shape).file("\n")[..]].concat()),
        ("faces-first".into(), faces_first(shape)),
    ]);
    files
}

/// A vertex that no face names stands nowhere.
fn unused(shape: &Shape) -> Text {
    let count = shape.positions.len();
    let mut text = Text::plain(shape);
    text.vertices.push("nan 0 0".into());
    text.header = text
        .header
        .iter()
        .map(|line| line.replace(&format!("vertex {count}"), &format!("vertex {}", count + 1)))
        .collect();
    text
}

fn faces_first(shape: &Shape) -> Vec<u8> {
    let mut text = Text::plain(shape);
    text.header = vec![
        "ply".into(),
        "format ascii 1.0".into(),
        format!("element face {}", shape.triangles.len()),
        "property list uint8 uint16 vertex_index".into(),
        "property list uint8 float texcoord".into(),
        format!("element vertex {}", shape.positions.len()),
        "property float64 z".into(),
        "property float32 y".into(),
        "property float x".into(),
        "end_header".into(),
    ];
    let faces = text.faces.iter().map(|face| format!("{face} 6 0 0 1 0 nan 1")).collect();
    text.faces = shape.positions.iter().map(|[x, y, z]| format!("{z} {y} {x}")).collect();
    text.vertices = faces;
    text.file("\n")
}

/// Triangles as strips.
fn strips(shape: &Shape) -> Files {
    let file = |name: &str, list: &str, strips: Vec<Vec<i64>>| {
        let count = shape.triangles.len();
        let mut text = Text::plain(shape);
        for line in &mut text.header {
            *line = line.replace(
                &format!("element face {count}"),
                &format!("element tristrips {}", strips.len()),
            );
            *line = line.replace("list uchar int vertex_indices", list);
        }
        let words = |strip: &Vec<i64>| strip.iter().map(|k| format!(" {k}")).collect::<String>();
        text.faces =
            strips.iter().map(|strip| format!("{}{}", strip.len(), words(strip))).collect();
        (name.to_owned(), text.file("\n"))
    };
    let triangles = || shape.triangles.iter().map(|triangle| triangle.map(i64::from));
    // The second triangle of each strip is the one that is turned around.
    let odd = triangles().map(|[a, b, c]| vec![a, a, c, b, -1]).collect::<Vec<_>>().concat();
    let joined = triangles().map(|[a, b, c]| vec![a, b, c, -1]).collect::<Vec<_>>().concat();
    let unsigned =
        |end: u32| joined.iter().map(|&k| if k < 0 { i64::from(end) } else { k }).collect();
    vec![
        file("strip-restarted", "list int int vertex_indices", vec![joined.clone()]),
        file("strip-odd", "list int int vertex_index", vec![odd]),
        file("strip-unsigned", "list uint uint vertex_indices", vec![unsigned(u32::MAX)]),
        file("strip-of-shorts", "list uint ushort vertex_indices", vec![unsigned(u16::MAX.into())]),
        file("strip-of-bytes", "list uint uint8 vertex_indices", vec![unsigned(u8::MAX.into())]),
        file(
            "strip-joined",
            "list int int vertex_indices",
            vec![shape.strip().into_iter().map(i64::from).collect()],
        ),
        file(
            "strips",
            "list uint8 int32 vertex_indices",
            triangles().map(|triangle| triangle.to_vec()).collect(),
        ),
    ]
}

/// Ends of lines.
fn lines(shape: &Shape) -> Files {
    let text = Text::plain(shape).insert(1, "comment ?");
    let mut cut = text.file("\n");
    cut.pop();
    let wide = |mark: [u8; 2], unit: fn(u16) -> [u8; 2]| {
        let text = Text::plain(shape).file("\n");
        [mark.to_vec(), text.iter().flat_map(|&byte| unit(u16::from(byte))).collect()].concat()
    };
    vec![
        ("carriage-returns".into(), text.file("\r")),
        ("both".into(), text.file("\r\n")),
        ("without-the-last".into(), cut),
        ("blanks-behind-lines".into(), text.file(" \n")),
        ("utf-16-le".into(), wide([0xff, 0xfe], u16::to_le_bytes)),
        ("utf-16-be".into(), wide([0xfe, 0xff], u16::to_be_bytes)),
    ]
}

fn binaries(shape: &Shape) -> Files {
    let behind = [&binary(shape, Order::Little, "\n")[..], b"more"].concat();
    vec![
        ("little".into(), binary(shape, Order::Little, "\n")),
        ("big".into(), binary(shape, Order::Big, "\n")),
        ("little-both".into(), binary(shape, Order::Little, "\r\n")),
        ("big-both".into(), binary(shape, Order::Big, "\r\n")),
        ("little-carriage-returns".into(), binary(shape, Order::Little, "\r")),
        ("big-carriage-returns".into(), binary(shape, Order::Big, "\r")),
        ("bytes-behind".into(), behind),
    ]
}
