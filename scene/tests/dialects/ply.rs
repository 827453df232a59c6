//! The polygon file format.
use crate::ply_files::{self, Order, Text, binary};
use crate::shape::wedge;
use crate::{check_dialects, read, refused};

#[test]
fn every_dialect_gives_the_mesh_and_the_picture_of_the_plain_file() {
    check_dialects(&ply_files::dialects(&wedge()));
}

/// What is passed over is told once, with its line, and nothing else is.
#[test]
fn what_is_left_out_is_told_once() {
    let said: Vec<String> = ply_files::dialects(&wedge())
        .iter()
        .map(|(name, bytes)| read(name, bytes).1)
        .filter(|warnings| !warnings.is_empty())
        .map(|warnings| warnings.join("\n"))
        .collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// The plain wedge with one line replaced, counted from 1.
fn replaced(line: usize, by: &str) -> Vec<u8> {
    let text = String::from_utf8(Text::plain(&wedge()).file("\n")).expect("it is text");
    let mut lines: Vec<&str> = text.lines().collect();
    lines[line - 1] = by;
    lines.join("\n").into_bytes()
}

/// The line and the word are named.
#[test]
fn wrong_lines_are_named_with_the_wrong_word() {
    let said: Vec<String> = [
        (1, "plyx"),
        (2, "format text 1.0"),
        (3, "element vertex five"),
        (4, "property real x"),
        (4, "property float a"),
        (7, "element vertex 6"),
        (7, "element polygon 6"),
        (8, "property list float int vertex_indices"),
        (8, "property list uchar float vertex_indices"),
        (8, "property int vertex_indices"),
        (10, "0 1.2.3 0"),
        (11, "2 0"),
        (12, "nan 1.5 0"),
        (12, "1e31 1.5 0"),
        (12, "1.#INF 1.5 0"),
        (15, "3 0 2 five"),
        (15, "3 0 2 1.5"),
        (15, "3 0 2 nan"),
        (15, "3 0 2"),
        (15, "3 0 2 5"),
        (15, "3 0 2 -1"),
        (15, "3 0 2 4294967296"),
        (15, "3 0 2 99999999999999999999"),
        (15, "-1 0 2 1"),
        (15, "4000000000 0 2 1"),
        (15, "2.5 0 2 1"),
        (15, ""),
    ]
    .iter()
    .map(|&(line, by)| format!("{by}\n    {}", refused("a.ply", &replaced(line, by))))
    .collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// In binary files, the element.
#[test]
fn wrong_elements_of_binary_files_are_named() {
    let whole = binary(&wedge(), Order::Little, "\n");
    let face = 8 + 2 + 12;
    let mut index = whole.clone();
    let at = whole.len() - face - 4;
    index[at..at + 4].copy_from_slice(&5_u32.to_le_bytes());
    let mut length = whole.clone();
    length[at - 2 - 8..at - 8].copy_from_slice(&65535_u16.to_le_bytes());
    let mut place = whole.clone();
    let at = whole.len() - 6 * face - 12;
    place[at..at + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    let said: Vec<String> = [&whole[..whole.len() - 1], &whole[..at - 2], &index, &length, &place]
        .iter()
        .map(|file| refused("a.ply", file))
        .collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// As the papers' meshes have them: strips with restarts, each turned as its first triangle is.
#[test]
fn strips_turn_every_other_triangle() {
    let strip = |list: &str| {
        let header = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
                      element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
        let places = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
        let (mesh, warnings) = read("a.ply", format!("{header}{places}{list}\n").as_bytes());
        assert!(warnings.is_empty(), "{warnings:?}");
        mesh.triangles
    };
    assert_eq!(strip("6 0 1 2 3 4 5"), [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]]);
    assert_eq!(strip("9 0 1 2 3 -1 3 4 5 -1"), [[0, 1, 2], [2, 1, 3], [3, 4, 5]]);
    assert_eq!(strip("10 -1 -1 0 1 -1 3 5 4 -1 0"), [[3, 5, 4]]);
}

/// Counted while they are read: the file has a byte for each triangle.
#[test]
fn strips_of_too_many_triangles_are_refused() {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n\
                  element tristrips 1\nproperty list uint uchar vertex_indices\nend_header\n";
    let corners: Vec<u8> = (0..30_000_000_u32).map(|k| (k % 3) as u8).collect();
    let file =
        [header.as_bytes(), &[0, 0, 0, 1, 0, 0, 0, 1, 0], &30_000_000_u32.to_le_bytes(), &corners]
            .concat();
    assert_eq!(
        refused("a.ply", &file),
        "mesh `a.ply`: it has 29999998 triangles; at most 10000000 are taken"
    );
}
