//! Lists of properties, and what is skipped of them.
use super::body::Body;
use super::header::{Kind, Property};
use crate::mesh::error::Located;
use crate::mesh::warning::quoted;

/// Passes a property over.
pub fn skip(property: &Property<'_>, body: &mut impl Body) -> Result<(), Located> {
    match property.kind {
        Kind::Number(scalar) => body.skip(property, scalar, 1),
        Kind::List { length, item } => {
            let length = list_length(body.whole(property, length)?, property, body)?;
            body.skip(property, item, length)
        }
    }
}

/// A list's length, which was read as an integer.
pub fn list_length(
    length: i64,
    property: &Property<'_>,
    body: &impl Body,
) -> Result<usize, Located> {
    usize::try_from(length).map_err(|_| {
        body.wrong(format!("the list {} has the length {length}", quoted(property.name)))
    })
}
