//! `.ply`, text and binary of either byte order (decision 0014).
mod body;
mod content;
mod header;
mod list;

use body::{Binary, Body, Text};
use content::Content;
use header::{Element, Encoding, Header};
use list::skip;

use super::error::{Located, MeshProblem};
use super::indexed::Mesh;
use super::text::unmarked;
use super::warning::{Notices, quoted};

/// Reads a `.ply` file: the element `vertex` with `x`, `y`, `z` and possibly `nx`, `ny`, `nz`; the
/// element `face` with the list `vertex_indices` (or `vertex_index`); and the element `tristrips`
/// with such a list, in which -1 starts a new strip. Other elements and properties are skipped.
///
/// # Errors
/// A wrong header, counts for which the file is too short, wrong types and words, and all errors of
/// `Polygons::into_mesh`.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let bytes = &unmarked(bytes)[..];
    let header = Header::read(bytes)?;
    check_counts(&header, bytes.len())?;
    let content = Content::new(&header)?;
    match header.encoding {
        Encoding::Text => read(&header, Text::new(header.lines.clone()), content, notices),
        encoding => read(&header, Binary::new(header.data, encoding), content, notices),
    }
}

/// Checks that the file can be as long as its header says: each element takes at least a byte.
fn check_counts(header: &Header<'_>, length: usize) -> Result<(), Located> {
    for element in header.elements.iter().filter(|element| !element.properties.is_empty()) {
        if element.count > length {
            let (count, name) = (element.count, quoted(element.name));
            let text = format!("its header states {count} of {name}; the file has {length} bytes");
            return Err(MeshProblem::Truncated(text).at_line(element.line));
        }
    }
    Ok(())
}

fn read(
    header: &Header<'_>,
    mut body: impl Body,
    mut content: Content,
    notices: &mut Notices,
) -> Result<Mesh, Located> {
    for element in &header.elements {
        if element.properties.is_empty() {
            continue;
        }
        let part = content::Part::of(element);
        if part.is_none() && element.count > 0 {
            let text = || format!("the element {} is passed over", quoted(element.name));
            notices.add("element", Some(element.line), text);
        }
        for index in 0..element.count {
            body.start(element, index)?;
            match &part {
                Some(part) => content.add(part, element, index, &mut body, notices)?,
                None => skip_all(element, &mut body)?,
            }
            body.finish(notices);
        }
    }
    body.finish_all(notices);
    content.into_mesh(notices)
}

fn skip_all(element: &Element<'_>, body: &mut impl Body) -> Result<(), Located> {
    element.properties.iter().try_for_each(|property| skip(property, body))
}
