//! `.stl` files as different programs write them, each of the same shape.
use super::shape::Shape;

/// A text file of a shape: a solid for each range of triangles.
fn solids(shape: &Shape, parts: &[&[[u32; 3]]]) -> String {
    parts
        .iter()
        .map(|triangles| format!("solid part\n{}endsolid part\n", facets(shape, triangles)))
        .collect()
}

fn facets(shape: &Shape, triangles: &[[u32; 3]]) -> String {
    let vertex = |k: u32| shape.positions[k as usize].map(|x| x.to_string()).join(" ");
    let facet = |&[a, b, c]: &[u32; 3]| {
        let vertices = [a, b, c].map(|k| format!("      vertex {}\n", vertex(k))).concat();
        format!("  facet normal 0 0 0\n    outer loop\n{vertices}    endloop\n  endfacet\n")
    };
    triangles.iter().map(facet).collect()
}

/// A binary file of a shape, its comment starting with `comment`, with two bytes of an attribute
/// for each triangle.
pub fn binary(shape: &Shape, comment: &[u8], attribute: [u8; 2]) -> Vec<u8> {
    let mut file = comment.to_vec();
    file.resize(80, b' ');
    file.extend((shape.triangles.len() as u32).to_le_bytes());
    for triangle in &shape.triangles {
        file.extend([f32::NAN; 3].iter().flat_map(|x| x.to_le_bytes()));
        file.extend(
            triangle.iter().flat_map(|&k| shape.positions[k as usize]).flat_map(f32::to_le_bytes),
        );
        file.extend(attribute);
    }
    file
}

/// Files that show the shape, each in a dialect of its own, with its name. Vertices are stated with
/// each triangle.
pub fn dialects(shape: &Shape) -> Vec<(String, Vec<u8>)> {
    let plain = solids(shape, &[&shape.triangles]);
    let changed = |&(name, change): &(&'static str, Change)| (name, latin1(&change(&plain)));
    let all = [WORDS, NAMES, LINES, NORMALS, BESIDE].concat();
    let files = all
        .iter()
        .map(changed)
        .chain(parts(shape))
        .chain(encoded(plain.as_bytes()))
        .chain(binaries(shape));
    files.map(|(name, file)| (format!("{name}.stl"), file)).collect()
}

/// A change to the plain text.
type Change = fn(&str) -> String;

/// The text's bytes; a `?` stands for a byte that is not UTF-8.
fn latin1(text: &str) -> Vec<u8> {
    text.bytes().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect()
}

/// Small letters and capitals.
const WORDS: &[(&str, Change)] = &[
    ("plain", str::to_owned),
    ("capitals", str::to_uppercase),
    ("mixed", |text| {
        text.replace("solid", "SOLID").replace("endloop", "ENDLOOP").replace("vertex", "Vertex")
    }),
];

/// Names of solids.
const NAMES: &[(&str, Change)] = &[
    ("no-name", |text| text.replace(" part", "")),
    ("latin-1-name", |text| text.replace("part", "pi?ce")),
    ("name-of-keywords", |text| text.replace("part", "solid facet vertex 1 2 3 endsolid")),
    ("long-name", |text| text.replace("part", &"a b ".repeat(99))),
    ("iso-2022-name", |text| text.replace("part", "\u{1b}$B%F%9\u{1b}(B")),
];

/// Lines and blanks.
const LINES: &[(&str, Change)] = &[
    ("cr-lf", |text| text.replace('\n', "\r\n")),
    ("cr", |text| text.replace('\n', "\r")),
    ("blanks-before", |text| format!("  \t{text}")),
    ("line-end-before", |text| format!("\r\n\n{text}")),
    ("one-line", |text| text.replace('\n', " ")),
    ("a-word-a-line", |text| text.replace(' ', "\n").replace("solid\npart", "solid part")),
    ("tabs", |text| text.replace(' ', "\t")),
    ("no-last-end", |text| text.trim_end().to_owned()),
    ("control-z", |text| format!("{text}\u{1a}")),
    ("zeros-behind", |text| format!("{text}{}", "\0".repeat(80))),
    ("thousands-of-lines-before", |text| format!("{}{text}", "\n".repeat(3000))),
    ("thousands-of-blanks-before", |text| format!("{}{text}", " ".repeat(5000))),
];

/// Normals that are none.
const NORMALS: &[(&str, Change)] = &[
    ("normals-not-numbers", |text| {
        text.replace("0 0 0\n    outer", "nan -nan(ind) 1.#QNAN\n    outer")
    }),
    ("normals-left-out", |text| text.replace("facet normal 0 0 0", "facet")),
    ("normals-cut-off", |text| text.replace("facet normal 0 0 0", "facet normal")),
];

/// What stands beside what is needed.
const BESIDE: &[(&str, Change)] = &[
    ("colours", |text| text.replace("  endfacet\n", "  endfacet\n  color 0.5 0.5 1\n")),
    ("comment-before", |text| format!("# caf?\n{text}")),
    ("comments-in-facets", |text| {
        text.replace("    outer", "; caf?\n    outer")
            .replace("    endloop", "attribute 7\n    endloop")
            .replace("  endfacet", "colour 1 0 0\n  endfacet")
    }),
    ("comment-of-5000-characters-before", |text| format!("; {}\n{text}", "?".repeat(5000))),
    ("four-numbers-of-normals", |text| text.replace("normal 0 0 0", "normal 0 0 0 0")),
    ("fourth-numbers", |text| text.replace("\n    endloop", " 1 0.5\n    endloop")),
    ("short-facets", |text| {
        let short =
            "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n";
        text.replace("endsolid", &format!("{short}endsolid"))
    }),
];

/// Solids cut in other ways.
fn parts(shape: &Shape) -> Vec<(&'static str, Vec<u8>)> {
    let (some, others) = shape.triangles.split_at(shape.triangles.len() / 2);
    let each: Vec<&[[u32; 3]]> = shape.triangles.chunks(1).collect();
    let files = [
        ("two-solids", solids(shape, &[some, others])),
        ("empty-first-solid", solids(shape, &[&[], &shape.triangles])),
        ("empty-last-solid", solids(shape, &[&shape.triangles, &[]])),
        ("many-solids", solids(shape, &each)),
        (
            "blanks-between-solids",
            solids(shape, &each).replace("endsolid part\n", "ENDSOLID part \n\n \t\r\n"),
        ),
        ("solids-not-ended", solids(shape, &[some, others]).replacen("endsolid part\n", "", 1)),
        ("facets-alone", facets(shape, &shape.triangles)),
        ("last-solid-not-ended", format!("solid part\n{}", facets(shape, &shape.triangles))),
    ];
    files.into_iter().map(|(name, text)| (name, text.into_bytes())).collect()
}

/// The plain text in encodings that a mark tells.
fn encoded(plain: &[u8]) -> Vec<(&'static str, Vec<u8>)> {
    let wide = |unit: fn(u16) -> [u8; 2]| {
        plain.iter().flat_map(|&byte| unit(u16::from(byte))).collect::<Vec<u8>>()
    };
    vec![
        ("mark", [b"\xef\xbb\xbf", plain].concat()),
        ("mark-and-line-end", [b"\xef\xbb\xbf\r\n ", plain].concat()),
        ("utf-16-le", [b"\xff\xfe".to_vec(), wide(u16::to_le_bytes)].concat()),
        ("utf-16-be", [b"\xfe\xff".to_vec(), wide(u16::to_be_bytes)].concat()),
    ]
}

/// Binary files.
fn binaries(shape: &Shape) -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("binary", binary(shape, b"made by a test", [0; 2])),
        ("binary-solid", binary(shape, b"solid made by a test", [0; 2])),
        ("binary-colours", binary(shape, b"COLOR=????", [0xff, 0x7f])),
        ("binary-of-zeros", binary(shape, &[0; 80], [0; 2])),
        (
            "binary-like-text",
            binary(shape, b"solid a\nfacet normal 0 0 0\nouter loop\n", [b' '; 2]),
        ),
        ("binary-and-more", [&binary(shape, b"solid", [0; 2])[..], b"more"].concat()),
    ]
}
