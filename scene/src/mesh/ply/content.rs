//! Vertices, faces and strips of a `.ply` file.
use glam::DVec3;

use super::body::Body;
use super::header::{Element, Header, Kind, Property, Scalar};
use super::list::{list_length, skip};
use crate::mesh::error::{Item, Located, MeshProblem};
use crate::mesh::indexed::Mesh;
use crate::mesh::limits::{FARTHEST, MAX_TRIANGLES};
use crate::mesh::polygons::{Corner, Polygons};
use crate::mesh::warning::Notices;

const PLACE: [&str; 3] = ["x", "y", "z"];

const NORMAL: [&str; 3] = ["nx", "ny", "nz"];

/// Names of the list of a face's or a strip's vertices.
const INDICES: [&str; 2] = ["vertex_indices", "vertex_index"];

/// An element that is drawn, and the role of its properties.
pub enum Part {
    /// For each property the coordinate that it is of position and normal together; `None` if it is
    /// ignored.
    Vertex(Vec<Option<usize>>),
    /// The property that is the list of vertices.
    Face(usize),
    /// The property that is the list of vertices.
    Strips(usize),
}

impl Part {
    /// The role of an element; `None` if it is to be skipped.
    pub fn of(element: &Element<'_>) -> Option<Part> {
        match element.name {
            b"vertex" => Some(Part::Vertex(coordinates(element))),
            b"face" => indices(element).map(Part::Face),
            b"tristrips" => indices(element).map(Part::Strips),
            _ => None,
        }
    }
}

fn coordinates(vertex: &Element<'_>) -> Vec<Option<usize>> {
    let used = if has_normals(vertex) { [PLACE, NORMAL].concat() } else { PLACE.to_vec() };
    let coordinate =
        |property: &Property<'_>| used.iter().position(|name| name.as_bytes() == property.name);
    vertex.properties.iter().map(coordinate).collect()
}

fn has_normals(vertex: &Element<'_>) -> bool {
    let is_number = |name: &str| {
        vertex.property(name).is_some_and(|property| matches!(property.kind, Kind::Number(_)))
    };
    NORMAL.into_iter().all(is_number)
}

/// The position of the list of vertices among the properties.
fn indices(element: &Element<'_>) -> Option<usize> {
    let is_named = |name: &str| {
        element.properties.iter().position(|property| property.name == name.as_bytes())
    };
    INDICES.into_iter().find_map(is_named)
}

/// The contents of a file as read so far.
pub struct Content {
    /// Number of vertices that the header states.
    vertices: usize,
    has_normals: bool,
    positions: Vec<DVec3>,
    /// Either as many normals as positions or none; 0 for an invalid normal.
    normals: Vec<DVec3>,
    /// Vertices with a coordinate that is not finite or too large, which is an error if a face
    /// names them.
    misplaced: Vec<Misplaced>,
    faces: Faces,
}

struct Misplaced {
    vertex: usize,
    line: Option<usize>,
    value: f64,
}

impl Content {
    /// Empty contents for a file with this header.
    ///
    /// # Errors
    /// The header has no vertices with positions, or no faces or strips with vertices.
    pub fn new(header: &Header<'_>) -> Result<Content, Located> {
        let [vertex, face, strips] = ["vertex", "face", "tristrips"].map(|name| only(header, name));
        let vertex = vertex?.ok_or_else(|| syntax("the header has no element `vertex`".into()))?;
        let at = |element: &Element<'_>| {
            let line = element.line;
            move |problem: MeshProblem| problem.at_line(line)
        };
        PLACE
            .into_iter()
            .try_for_each(|name| check_coordinate(vertex, name))
            .map_err(at(vertex))?;
        let faces = [face?, strips?];
        if faces == [None, None] {
            return Err(syntax("the header has no element `face`".into()).into());
        }
        let mut drawn = faces.into_iter().flatten().filter(|element| element.count > 0);
        drawn.try_for_each(|element| check_indices(element).map_err(at(element)))?;
        Ok(Content {
            vertices: vertex.count,
            has_normals: has_normals(vertex),
            positions: Vec::new(),
            normals: Vec::new(),
            misplaced: Vec::new(),
            faces: Faces::default(),
        })
    }

    /// Reads an element, the `index`-th of its kind, counted from 0.
    pub fn add(
        &mut self,
        part: &Part,
        element: &Element<'_>,
        index: usize,
        body: &mut impl Body,
        notices: &mut Notices,
    ) -> Result<(), Located> {
        match part {
            Part::Vertex(coordinates) => self.vertex(coordinates, element, body, notices),
            Part::Face(list) => {
                for (k, property) in element.properties.iter().enumerate() {
                    if k == *list {
                        self.face(index, property, body, notices)?
                    } else {
                        skip(property, body)?
                    }
                }
                Ok(())
            }
            Part::Strips(list) => {
                for (k, property) in element.properties.iter().enumerate() {
                    if k == *list { self.strips(property, body)? } else { skip(property, body)? }
                }
                Ok(())
            }
        }
    }

    fn vertex(
        &mut self,
        coordinates: &[Option<usize>],
        element: &Element<'_>,
        body: &mut impl Body,
        notices: &mut Notices,
    ) -> Result<(), Located> {
        let mut values = [0.0; 6];
        for (property, coordinate) in element.properties.iter().zip(coordinates) {
            match (coordinate, property.kind) {
                (Some(coordinate), Kind::Number(scalar)) => {
                    values[*coordinate] = body.number(property, scalar)?
                }
                _ => skip(property, body)?,
            }
        }
        let [x, y, z, normal @ ..] = values;
        self.place(DVec3::new(x, y, z), body.line());
        if self.has_normals {
            let direction = direction(DVec3::from_array(normal));
            if direction == DVec3::ZERO {
                notices.add("normal without direction", body.line(), || {
                    "a normal has no direction; it is made from the faces around its vertex instead".into()
                });
            }
            self.normals.push(direction);
        }
        Ok(())
    }

    fn place(&mut self, place: DVec3, line: Option<usize>) {
        match place.to_array().into_iter().find(|x| x.is_nan() || x.abs() > FARTHEST) {
            Some(value) => {
                self.misplaced.push(Misplaced { vertex: self.positions.len(), line, value });
                self.positions.push(DVec3::ZERO);
            }
            None => self.positions.push(place),
        }
    }

    fn face(
        &mut self,
        face: usize,
        property: &Property<'_>,
        body: &mut impl Body,
        notices: &mut Notices,
    ) -> Result<(), Located> {
        let (length, item) = list(property, body)?;
        let mut corners = Vec::new();
        for _ in 0..length {
            let number = body.whole(property, item)?;
            let index = index(number, self.vertices)
                .ok_or_else(|| self.no_such_vertex(face, number, body))?;
            corners.push(index);
        }
        if corners.len() < 3 {
            let text = || format!("a face has fewer than three corners: {length}; it is left out");
            notices.add("short face", body.line(), text);
        } else {
            self.faces.push(&corners, body.line());
        }
        Ok(())
    }

    fn no_such_vertex(&self, face: usize, number: i64, body: &impl Body) -> Located {
        let below = (number < 0).then_some(u32::MAX);
        match below.or(u32::try_from(number).ok().filter(|index| *index < u32::MAX)) {
            Some(index) => {
                let problem =
                    MeshProblem::Index { face, what: "vertex", index, count: self.vertices };
                Located { line: body.line(), problem }
            }
            None => body.wrong(format!(
                "face {face} names vertex {number} (both counted from 0), which is not there"
            )),
        }
    }

    /// Reads triangles of three consecutive vertices each, every other one reversed; -1 starts a
    /// new strip.
    fn strips(&mut self, property: &Property<'_>, body: &mut impl Body) -> Result<(), Located> {
        let (length, item) = list(property, body)?;
        let mut strip = Strip::default();
        for _ in 0..length {
            let number = body.whole(property, item)?;
            let index = index(number, self.vertices);
            if number == -1 || (index.is_none() && item.largest_unsigned() == Some(number)) {
                strip = Strip::default();
                continue;
            }
            let text = || {
                format!(
                    "a strip names vertex {number}, but there are only {} (counted from 0)",
                    self.vertices
                )
            };
            if let Some(triangle) = strip.next(index.ok_or_else(|| body.wrong(text()))?) {
                self.faces.push(&triangle, body.line());
            }
        }
        Ok(())
    }

    /// The mesh; vertices with wrong positions that no face uses are put at 0.
    pub fn into_mesh(self, notices: &mut Notices) -> Result<Mesh, Located> {
        self.check_places()?;
        if self.faces.triangles > MAX_TRIANGLES {
            return Err(MeshProblem::TooManyTriangles(self.faces.triangles).into());
        }
        let Content { positions, normals, faces, .. } = self;
        let mut polygons = Polygons::default();
        (polygons.positions, polygons.normals) = (positions, normals);
        let has_normal: Vec<bool> =
            polygons.normals.iter().map(|normal| *normal != DVec3::ZERO).collect();
        let given = |vertex: u32| has_normal.get(vertex as usize).is_some_and(|has| *has);
        for face in faces.all() {
            polygons.push(
                face.iter()
                    .map(|&vertex| Corner { vertex, normal: given(vertex).then_some(vertex) }),
            );
        }
        let line = |item| match item {
            Item::Face(index) => faces.lines.get(index).copied(),
            // Vertices and normals have been checked.
            Item::Vertex(_) | Item::Normal(_) => None,
        };
        polygons.into_mesh(notices, &line)
    }

    fn check_places(&self) -> Result<(), Located> {
        if self.misplaced.is_empty() {
            return Ok(());
        }
        let mut used = vec![false; self.positions.len()];
        self.faces.corners.iter().for_each(|&vertex| used[vertex as usize] = true);
        match self.misplaced.iter().find(|misplaced| used[misplaced.vertex]) {
            Some(&Misplaced { vertex: index, line, value }) => Err(Located {
                line,
                problem: MeshProblem::Coordinate { what: "vertex", index, value },
            }),
            None => Ok(()),
        }
    }
}

/// Faces as indices of vertices, up to the largest number of triangles; further ones are only
/// counted.
#[derive(Default)]
struct Faces {
    corners: Vec<u32>,
    /// For each face its end in `corners`.
    ends: Vec<usize>,
    /// The line of each face, in a text file.
    lines: Vec<usize>,
    triangles: usize,
}

impl Faces {
    /// Adds a face of three corners or more.
    fn push(&mut self, corners: &[u32], line: Option<usize>) {
        self.triangles += corners.len() - 2;
        if self.triangles <= MAX_TRIANGLES {
            self.corners.extend(corners);
            self.ends.push(self.corners.len());
            self.lines.extend(line);
        }
    }

    fn all(&self) -> impl Iterator<Item = &[u32]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start..end])
    }
}

/// The last two vertices of a strip, and whether the next triangle is reversed.
#[derive(Default)]
struct Strip {
    last: [Option<u32>; 2],
    is_odd: bool,
}

impl Strip {
    /// The triangle that a vertex completes; `None` for a triangle that names a vertex twice, which
    /// only leads the strip elsewhere.
    fn next(&mut self, vertex: u32) -> Option<[u32; 3]> {
        let [first, second] = self.last;
        self.last = [second, Some(vertex)];
        let (first, second) = (first?, second?);
        let is_odd = self.is_odd;
        self.is_odd = !is_odd;
        let has_area = first != second && second != vertex && vertex != first;
        has_area.then_some(if is_odd { [second, first, vertex] } else { [first, second, vertex] })
    }
}

/// The length of a list and the type of its items.
fn list(property: &Property<'_>, body: &mut impl Body) -> Result<(usize, Scalar), Located> {
    match property.kind {
        Kind::List { length, item } => {
            Ok((list_length(body.whole(property, length)?, property, body)?, item))
        }
        // If there are any, the header was checked for it.
        Kind::Number(scalar) => Ok((0, scalar)),
    }
}

fn index(number: i64, count: usize) -> Option<u32> {
    let index = u32::try_from(number).ok()?;
    ((index as usize) < count).then_some(index)
}

/// A vector along a normal with 1 as its largest component, or 0 if it has no direction.
fn direction(normal: DVec3) -> DVec3 {
    let largest = normal.abs().max_element();
    if normal.is_finite() && largest > 0.0 { normal / largest } else { DVec3::ZERO }
}

/// The element with this name, if there is one; there must not be two.
fn only<'a, 'h>(header: &'h Header<'a>, name: &str) -> Result<Option<&'h Element<'a>>, Located> {
    let mut all = header.elements.iter().filter(|element| element.name == name.as_bytes());
    let first = all.next();
    match all.next() {
        Some(second) => {
            Err(syntax(format!("the header has the element `{name}` twice")).at_line(second.line))
        }
        None => Ok(first),
    }
}

fn check_coordinate(vertex: &Element<'_>, name: &str) -> Result<(), MeshProblem> {
    match vertex.property(name).map(|property| property.kind) {
        Some(Kind::Number(_)) => Ok(()),
        Some(Kind::List { .. }) => {
            Err(syntax(format!("property `{name}` of `vertex` is a list; it has to be a number")))
        }
        None => Err(syntax(format!("element `vertex` has no property `{name}`"))),
    }
}

fn check_indices(element: &Element<'_>) -> Result<(), MeshProblem> {
    let name = String::from_utf8_lossy(element.name);
    match indices(element).map(|k| element.properties[k].kind) {
        Some(Kind::List { item, .. }) if item.is_whole() => Ok(()),
        Some(Kind::List { .. }) => Err(syntax(format!(
            "the vertex indices of `{name}` are fractions; they have to be integers"
        ))),
        Some(Kind::Number(_)) => Err(syntax(format!(
            "the vertex indices of `{name}` are a single number; they have to be a list"
        ))),
        None => Err(syntax(format!("element `{name}` has no list `vertex_indices`"))),
    }
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}
