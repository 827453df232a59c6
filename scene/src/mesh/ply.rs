//! `.ply`, text and binary of either byte order, through the `ply-rs-bw` crate.
use std::io::Cursor;

use glam::DVec3;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Encoding, Header, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType};

use super::Mesh;
use super::error::{Item, Located, MeshProblem};
use super::polygons::{Corner, Polygons};
use super::warning::Notices;

/// Reads a `.ply` file: element `vertex` with `x`, `y`, `z` and perhaps `nx`, `ny`, `nz`; element `face` with the list
/// `vertex_indices` (or `vertex_index`). Other elements and properties are skipped.
///
/// # Errors
/// A wrong header, counts that the file is too short for, wrong types, and all that [`Polygons::into_mesh`] finds.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = Parser::<Skipped>::new().read_header(&mut reader).map_err(located)?;
    check_header(&header, bytes.len())?;
    let mut content = Content::default();
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                content.vertices_start = reader.line();
                content.vertices = read(&mut reader, element, &header)?;
            }
            "face" => {
                content.faces_start = reader.line();
                content.faces = read(&mut reader, element, &header)?;
            }
            _ => drop(read::<Skipped>(&mut reader, element, &header)?),
        }
    }
    let has_normals = header.elements.get("vertex").is_some_and(has_normals);
    content.into_mesh(&header, has_normals, notices)
}

/// What the file holds, and the lines its vertices and faces start at.
#[derive(Default)]
struct Content {
    vertices: Vec<Vertex>,
    vertices_start: usize,
    faces: Vec<Face>,
    faces_start: usize,
}

impl Content {
    fn into_mesh(self, header: &Header, has_normals: bool, notices: &mut Notices) -> Result<Mesh, Located> {
        let mut polygons = Polygons::default();
        polygons.positions.extend(self.vertices.iter().map(|v| v.position));
        if has_normals {
            polygons.normals.extend(self.vertices.iter().map(|v| v.normal));
        }
        // Where the faces with three corners or more stand among all, to say the line.
        let mut drawn = Vec::with_capacity(self.faces.len());
        for (number, face) in self.faces.iter().enumerate() {
            let corner = |&vertex: &u32| Corner { vertex, normal: has_normals.then_some(vertex) };
            polygons.push(face.corners.iter().map(corner));
            if face.corners.len() >= 3 {
                drawn.push(number);
            }
        }
        let line = |item| match item {
            Item::Vertex(index) | Item::Normal(index) => Some(self.vertices_start + index),
            Item::Face(index) => drawn.get(index).map(|number| self.faces_start + number),
        };
        polygons.into_mesh(notices, &|item| line(item).filter(|_| header.encoding == Encoding::Ascii))
    }
}

/// Reads all of an element.
fn read<E: PropertyAccess>(reader: &mut Reader<Cursor<&[u8]>>, element: &ElementDef, header: &Header) -> Result<Vec<E>, Located> {
    let read = Parser::<E>::new().read_payload_for_element(reader, element, header);
    // Lines mean nothing in a binary file.
    read.map_err(located).map_err(|mut at| {
        at.line = at.line.filter(|_| header.encoding == Encoding::Ascii);
        at
    })
}

fn located(error: ParseError) -> Located {
    let line = error.line();
    let text = said_once(&error.to_string());
    let text = match line.and_then(|line| text.strip_prefix(&format!("Line {line}: "))) {
        Some(rest) => rest.to_owned(),
        None => text,
    };
    let problem = match error.kind() {
        std::io::ErrorKind::UnexpectedEof => MeshProblem::Truncated(text),
        _ => MeshProblem::Syntax(text),
    };
    Located { line, problem }
}

/// The outermost and innermost of the crate's nested messages, on one line, without the grammar's own words.
fn said_once(nested: &str) -> String {
    let words = nested.split_whitespace().collect::<Vec<_>>().join(" ");
    let parts: Vec<&str> = words.split(" Error: ").collect();
    let is_grammar = |part: &str| part.starts_with("error at") || part.starts_with("ParseError");
    match parts.as_slice() {
        [first, .., last] if !is_grammar(last) => format!("{first} {last}"),
        [first, ..] => (*first).to_owned(),
        [] => words,
    }
}

/// Checks the header against itself and the file's length in bytes, so that no count of it is believed blindly.
fn check_header(header: &Header, length: usize) -> Result<(), MeshProblem> {
    for (name, element) in &header.elements {
        if element.properties.is_empty() && element.count > 0 {
            return Err(MeshProblem::Syntax(format!("element `{name}` has no properties")));
        }
        // Each property of each element takes a byte at least, in any encoding.
        if element.count > length {
            let text = format!("its header states {} of `{name}`; the file has {length} bytes", element.count);
            return Err(MeshProblem::Truncated(text));
        }
    }
    let vertex = needed(header, "vertex")?;
    for name in ["x", "y", "z"] {
        check_coordinate(vertex, name)?;
    }
    if has_normals(vertex) {
        for name in NORMAL {
            check_coordinate(vertex, name)?;
        }
    }
    check_indices(needed(header, "face")?)
}

const NORMAL: [&str; 3] = ["nx", "ny", "nz"];

fn has_normals(vertex: &ElementDef) -> bool {
    NORMAL.iter().all(|name| vertex.properties.get(*name).is_some())
}

fn needed<'a>(header: &'a Header, name: &str) -> Result<&'a ElementDef, MeshProblem> {
    let missing = || MeshProblem::Syntax(format!("the header has no element `{name}`"));
    header.elements.get(name).ok_or_else(missing)
}

fn check_coordinate(vertex: &ElementDef, name: &str) -> Result<(), MeshProblem> {
    match vertex.properties.get(name).map(|property| &property.data_type) {
        Some(PropertyType::Scalar(_)) => Ok(()),
        Some(PropertyType::List(..)) => {
            Err(MeshProblem::Syntax(format!("property `{name}` of `vertex` is a list; it has to be a number")))
        }
        None => Err(MeshProblem::Syntax(format!("element `vertex` has no property `{name}`"))),
    }
}

fn check_indices(face: &ElementDef) -> Result<(), MeshProblem> {
    let property = INDICES.iter().find_map(|name| face.properties.get(*name));
    match property.map(|property| &property.data_type) {
        Some(PropertyType::List(_, ScalarType::Float | ScalarType::Double)) => {
            Err(MeshProblem::Syntax("the vertex indices of `face` are fractions; they have to be integers".into()))
        }
        Some(PropertyType::List(..)) => Ok(()),
        Some(PropertyType::Scalar(_)) => {
            Err(MeshProblem::Syntax("the vertex indices of `face` are a single number; they have to be a list".into()))
        }
        None => Err(MeshProblem::Syntax("element `face` has no list `vertex_indices`".into())),
    }
}

const INDICES: [&str; 2] = ["vertex_indices", "vertex_index"];

/// A vertex; what the file does not give stays 0.
#[derive(Default)]
struct Vertex {
    position: DVec3,
    normal: DVec3,
}

impl Vertex {
    fn set(&mut self, name: &str, value: f64) -> PropertyAccessResult {
        match name {
            "x" => self.position.x = value,
            "y" => self.position.y = value,
            "z" => self.position.z = value,
            "nx" => self.normal.x = value,
            "ny" => self.normal.y = value,
            "nz" => self.normal.z = value,
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

/// A face's vertices.
#[derive(Default)]
struct Face {
    corners: Vec<u32>,
}

impl Face {
    fn set<T: Copy + TryInto<u32>>(&mut self, name: &str, values: &[T]) -> PropertyAccessResult {
        if !INDICES.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        // What does not fit, a negative index, is reported as out of range.
        self.corners = values.iter().map(|&value| value.try_into().unwrap_or(u32::MAX)).collect();
        PropertyAccessResult::Set
    }
}

/// An element of no interest.
#[derive(Debug)]
struct Skipped;

/// Setters that hand a number of any type to `Vertex::set`.
macro_rules! number_setters {
    ($($setter:ident: $number:ty),+) => {
        $(fn $setter(&mut self, name: &str, value: $number) -> PropertyAccessResult {
            self.set(name, f64::from(value))
        })+
    };
}

/// Setters that hand a list of any type of integer to `Face::set`.
macro_rules! list_setters {
    ($($setter:ident: $number:ty),+) => {
        $(fn $setter(&mut self, name: &str, values: Vec<$number>) -> PropertyAccessResult {
            self.set(name, &values)
        })+
    };
}

impl PropertyAccess for Vertex {
    fn new() -> Vertex {
        Vertex::default()
    }

    number_setters!(
        set_char: i8, set_uchar: u8, set_short: i16, set_ushort: u16,
        set_int: i32, set_uint: u32, set_float: f32, set_double: f64
    );
}

impl PropertyAccess for Face {
    fn new() -> Face {
        Face::default()
    }

    list_setters!(
        set_list_char: i8, set_list_uchar: u8, set_list_short: i16,
        set_list_ushort: u16, set_list_int: i32, set_list_uint: u32
    );
}

impl PropertyAccess for Skipped {
    fn new() -> Skipped {
        Skipped
    }
}
