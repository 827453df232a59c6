//! `.obj` files as different programs write them, each of the same shape.
use super::shape::Shape;

/// A file of a shape, in which lines can be replaced and added.
#[derive(Clone, Debug)]
pub struct Obj {
    /// Lines before all others.
    pub head: Vec<String>,
    pub vertices: Vec<String>,
    /// Lines between vertices and faces.
    pub middle: Vec<String>,
    pub faces: Vec<String>,
    /// Lines behind all others.
    pub tail: Vec<String>,
    /// What ends a line.
    pub end: &'static str,
}

impl Obj {
    /// The file as most programs write it; faces may have any number of corners.
    pub fn plain(positions: &[[f32; 3]], faces: &[Vec<u32>]) -> Obj {
        let indices =
            |face: &Vec<u32>| face.iter().map(|k| format!(" {}", k + 1)).collect::<String>();
        Obj {
            head: vec![],
            vertices: positions.iter().map(|[x, y, z]| format!("v {x} {y} {z}")).collect(),
            middle: vec![],
            faces: faces.iter().map(|face| format!("f{}", indices(face))).collect(),
            tail: vec![],
            end: "\n",
        }
    }

    /// Each word of each face's line replaced, all but the first.
    fn corners(&mut self, corner: impl Fn(usize) -> String) {
        for face in &mut self.faces {
            let words = face
                .split_whitespace()
                .skip(1)
                .map(|word| corner(word.parse().expect("it is an index")));
            *face = format!("f {}", words.collect::<Vec<_>>().join(" "));
        }
    }

    /// The text; a `?` stands for a byte that is not UTF-8.
    pub fn file(&self) -> Vec<u8> {
        let lines =
            [&self.head[..], &self.vertices, &self.middle, &self.faces, &self.tail].concat();
        let text = lines.iter().map(|line| format!("{line}{}", self.end)).collect::<String>();
        text.bytes().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect()
    }
}

/// Files that show the shape, each in a dialect of its own, with its name. Vertices and triangles
/// are those of the shape.
pub fn dialects(shape: &Shape) -> Vec<(String, Vec<u8>)> {
    let faces: Vec<Vec<u32>> = shape.triangles.iter().map(|t| t.to_vec()).collect();
    of_faces(&shape.positions, &faces)
}

/// The same with faces of any number of corners.
pub fn of_faces(positions: &[[f32; 3]], faces: &[Vec<u32>]) -> Vec<(String, Vec<u8>)> {
    let plain = Obj::plain(positions, faces);
    let changed = |&(name, change): &(&'static str, Change)| {
        let mut obj = plain.clone();
        change(&mut obj);
        (name, obj.file())
    };
    let all = [NUMBERS, LINES, CONTINUED, BESIDE, NORMALS].concat();
    let files = all.iter().map(changed).chain(encoded(&plain.file()));
    files.map(|(name, file)| (format!("{name}.obj"), file)).collect()
}

/// A change to the plain file.
type Change = fn(&mut Obj);

/// Numbers and indices in different forms.
const NUMBERS: &[(&str, Change)] = &[
    ("plain", |_| {}),
    ("from-the-end", |obj| {
        let count = obj.vertices.len() as i64;
        obj.corners(|k| (k as i64 - 1 - count).to_string());
    }),
    ("texture-and-normal", |obj| {
        obj.middle.extend(["vt 0 0".into(), "vn 0 0 1".into()]);
        obj.corners(|k| format!("{k}/1/"));
    }),
    ("absurd-texture", |obj| obj.corners(|k| format!("{k}/-99999999999999999999"))),
    ("weights", |obj| obj.vertices.iter_mut().for_each(|v| v.push_str(" 1.0"))),
    ("colours", |obj| obj.vertices.iter_mut().for_each(|v| v.push_str(" 0.5 nan x"))),
    ("signs", |obj| obj.corners(|k| format!("+{k}"))),
    ("exponents", |obj| {
        for vertex in &mut obj.vertices {
            let numbers = vertex
                .split_whitespace()
                .skip(1)
                .map(|word| format!("{:E}", word.parse::<f32>().expect("a number")));
            *vertex = format!("v {}", numbers.collect::<Vec<_>>().join(" "));
        }
    }),
    ("bare-points", |obj| {
        for vertex in &mut obj.vertices {
            let bare = |word: &str| {
                if word.contains('.') {
                    word.replace("0.", ".")
                } else {
                    format!("+{word}.").replace("+-", "-")
                }
            };
            let numbers = vertex.split_whitespace().skip(1).map(bare);
            *vertex = format!("v {}", numbers.collect::<Vec<_>>().join(" "));
        }
    }),
    ("corners-twice", |obj| {
        obj.corners(|k| format!("{k} {k}"));
    }),
    ("fortran-exponents", |obj| {
        for vertex in &mut obj.vertices {
            let numbers = vertex
                .split_whitespace()
                .skip(1)
                .map(|word| format!("{:E}", word.parse::<f32>().expect("a number")));
            *vertex = format!("v {}", numbers.collect::<Vec<_>>().join(" ").replace('E', "D"));
        }
    }),
    ("faces-of-version-2", |obj| {
        obj.faces.iter_mut().for_each(|face| face.insert(1, 'o'));
    }),
    ("faces-first", |obj| std::mem::swap(&mut obj.vertices, &mut obj.faces)),
];

/// Lines and blanks.
const LINES: &[(&str, Change)] = &[
    ("cr-lf", |obj| obj.end = "\r\n"),
    ("cr", |obj| obj.end = "\r"),
    ("blank-lines", |obj| obj.end = "\n \t\n\n"),
    ("tabs", |obj| {
        let lines = obj.vertices.iter_mut().chain(&mut obj.faces);
        lines.for_each(|line| *line = format!(" \t{}\t ", line.replace(' ', "\t \t")));
    }),
    ("control-z", |obj| obj.tail.push("\u{1a}".into())),
    ("comments", |obj| {
        obj.head.push("# v 9 9 9".into());
        let lines = obj.vertices.iter_mut().chain(&mut obj.faces);
        lines.for_each(|line| line.push_str(" # 7 f 1 2 3"));
    }),
];

/// Lines that go on in the next.
const CONTINUED: &[(&str, Change)] = &[
    ("continued-faces", |obj| {
        obj.faces.iter_mut().for_each(|face| *face = face.replace(' ', " \\\n "))
    }),
    ("continued-vertices", |obj| {
        obj.vertices.iter_mut().for_each(|v| *v = v.replacen(' ', " \\\n", 1))
    }),
    ("continued-cr-lf", |obj| {
        obj.end = "\r\n";
        obj.vertices
            .iter_mut()
            .chain(&mut obj.faces)
            .for_each(|line| *line = line.replace(' ', "\\\r\n "));
    }),
    ("continued-cr", |obj| {
        obj.end = "\r";
        obj.faces.iter_mut().for_each(|face| *face = face.replace(' ', " \\ \r"));
    }),
    ("continued-at-the-end", |obj| {
        if let Some(last) = obj.faces.last_mut() {
            last.push_str(" \\");
        }
    }),
    ("continued-and-empty", |obj| obj.faces.iter_mut().for_each(|face| face.push_str(" \\\n"))),
    ("comments-do-not-continue", |obj| {
        obj.head.push("# models\\".into());
        obj.vertices.iter_mut().for_each(|v| v.push_str(" # \\"));
        obj.middle.push("#\\".into());
    }),
    ("names-do-not-continue", |obj| {
        obj.head.push("mtllib C:\\models\\".into());
        obj.middle.extend(["o part\\".into(), "g a b\\".into()]);
        obj.faces.insert(1, "usemtl steel\\".into());
    }),
    ("unknown-words-do-not-continue", |obj| {
        obj.head.push("material C:\\models\\".into());
        obj.middle.push("layer 1 \\".into());
    }),
    ("names-continue", |obj| obj.middle.push("g a \\\nb \\\nc".into())),
    ("texture-continues", |obj| obj.middle.push("vt 0 \\\n0".into())),
];

/// What stands beside what is needed.
const BESIDE: &[(&str, Change)] = &[
    ("latin-1-comment", |obj| obj.head.push("# caf?".into())),
    ("latin-1-names", |obj| {
        obj.head.push("mtllib caf?.mtl".into());
        obj.middle.extend(["o t?te".into(), "g ??".into(), "usemtl ?".into(), "s off".into()]);
    }),
    ("short-faces", |obj| {
        obj.faces.insert(0, "f 1 2".into());
        obj.faces.extend(["f 3".into(), "f".into()]);
    }),
    ("lines-and-points", |obj| obj.faces.extend(["l 1 2 3".into(), "p 1".into(), "l 2 3".into()])),
    ("unknown-words", |obj| obj.middle.extend(["ve 9 9 9".into(), "ve".into(), "? 1".into()])),
    ("unused-vertices", |obj| obj.tail.extend(["v nan 0 0".into(), "v 1e300 inf 0".into()])),
    ("degenerate-faces", |obj| {
        obj.faces.extend(["f 1 1 1".into(), "f 1 2 1".into(), "f 2 2 3 3".into()])
    }),
];

/// Normals that cannot be used, so that those that the faces make are.
const NORMALS: &[(&str, Change)] = &[
    ("unused-normals", |obj| {
        obj.middle.extend([
            "vn nan nan nan".into(),
            "vn -nan(ind) 0 0".into(),
            "vn 0 1".into(),
            "vn".into(),
        ])
    }),
    ("normals-of-zero", |obj| {
        obj.middle.push("vn 0 0 0".into());
        obj.corners(|k| format!("{k}//1"));
    }),
    ("normals-not-numbers", |obj| {
        obj.middle.extend(["vn nan nan nan".into(), "vn inf 0 0".into(), "vn -1.#IND 0 0".into()]);
        obj.corners(|k| format!("{k}//{}", k % 3 + 1));
    }),
    ("normals-not-there", |obj| {
        let far = ["1", "7", "0", "-1", "-4000000000", "99999999999"];
        obj.corners(|k| format!("{k}//{}", far[k % far.len()]));
    }),
];

/// A mark before each line: files that were put together have several.
fn marked(plain: &[u8]) -> Vec<u8> {
    plain
        .split_inclusive(|&byte| byte == b'\n')
        .flat_map(|line| [b"\xef\xbb\xbf", line].concat())
        .collect()
}

/// The plain file in encodings that a mark tells.
fn encoded(plain: &[u8]) -> Vec<(&'static str, Vec<u8>)> {
    let wide = |unit: fn(u16) -> [u8; 2]| {
        plain.iter().flat_map(|&byte| unit(u16::from(byte))).collect::<Vec<u8>>()
    };
    vec![
        ("mark", [b"\xef\xbb\xbf", plain].concat()),
        ("utf-16-le", [b"\xff\xfe".to_vec(), wide(u16::to_le_bytes)].concat()),
        ("utf-16-be", [b"\xfe\xff".to_vec(), wide(u16::to_be_bytes)].concat()),
        ("no-last-end", plain.trim_ascii_end().to_vec()),
        ("marks", marked(plain)),
    ]
}
