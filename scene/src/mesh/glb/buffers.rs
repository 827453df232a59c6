//! The bytes of buffers, which accessors read.
use std::cell::OnceCell;

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};

use super::extensions::unread;
use super::json::{BufferView, Document, Whole};
use crate::mesh::error::MeshProblem;
use crate::mesh::warning::quoted;

/// The bytes of all buffers; those in data URIs are decoded when they are first used.
pub struct Buffers<'a> {
    document: &'a Document,
    binary: Option<&'a [u8]>,
    decoded: Vec<OnceCell<Result<Vec<u8>, MeshProblem>>>,
}

impl<'a> Buffers<'a> {
    /// The buffers of a document; `binary` is the chunk that follows the JSON.
    pub fn new(document: &'a Document, binary: Option<&'a [u8]>) -> Buffers<'a> {
        Buffers {
            document,
            binary,
            decoded: document.buffers.iter().map(|_| OnceCell::new()).collect(),
        }
    }

    /// The bytes of a view, and the distance from the start of one element to the next, if the view
    /// states it.
    ///
    /// # Errors
    /// A view that does not exist, exceeds its buffer, or refers to a buffer that is not in the
    /// file.
    pub fn view(&self, Whole(number): Whole) -> Result<(&[u8], Option<usize>), MeshProblem> {
        let missing = || {
            MeshProblem::Syntax(format!(
                "an accessor names buffer view {number}, which is not there"
            ))
        };
        let view = self.document.buffer_views.get(number).ok_or_else(missing)?;
        let bytes = self.bytes(view)?;
        let rest = bytes.get(view.byte_offset.0..).and_then(|rest| rest.get(..view.byte_length.0));
        let beyond =
            || MeshProblem::Truncated(format!("buffer view {number} reaches beyond its buffer"));
        Ok((
            rest.ok_or_else(beyond)?,
            view.byte_stride.map(|stride| stride.0).filter(|stride| *stride > 0),
        ))
    }

    fn bytes(&self, view: &BufferView) -> Result<&[u8], MeshProblem> {
        let Whole(number) = view.buffer;
        let missing = || {
            MeshProblem::Syntax(format!("a buffer view names buffer {number}, which is not there"))
        };
        let buffer = self.document.buffers.get(number).ok_or_else(missing)?;
        match (&buffer.uri, self.binary) {
            (Some(uri), _) => {
                let decoded = self.decoded[number].get_or_init(|| decode(uri, number));
                decoded.as_deref().map_err(MeshProblem::clone)
            }
            (None, Some(binary)) if number == 0 => Ok(binary),
            (None, _) if view.extensions.meshopt.is_some() => {
                Err(unread("EXT_meshopt_compression"))
            }
            (None, _) if view.extensions.meshopt_khr.is_some() => {
                Err(unread("KHR_meshopt_compression"))
            }
            (None, _) => Err(MeshProblem::Truncated(format!("buffer {number} has no bytes"))),
        }
    }
}

/// The bytes of a data URI, `data:TYPE;base64,BYTES` [RFC 2397].
fn decode(uri: &str, number: usize) -> Result<Vec<u8>, MeshProblem> {
    let of_data = |uri: &str| uri.get(..5).is_some_and(|start| start.eq_ignore_ascii_case("data:"));
    let Some((kind, text)) = uri.split_once(',').filter(|(kind, _)| of_data(kind)) else {
        return Err(MeshProblem::Unsupported(format!(
            "geometry in another file, {}",
            quoted(uri.as_bytes())
        )));
    };
    if !kind.to_ascii_lowercase().ends_with(";base64") {
        return Err(MeshProblem::Syntax(format!("the data of buffer {number} are not in base64")));
    }
    // Some programs omit the padding.
    let config =
        GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let bytes = GeneralPurpose::new(&STANDARD, config).decode(text);
    bytes.map_err(|error| {
        let error = error.to_string();
        MeshProblem::Syntax(format!(
            "the base64 of buffer {number} is wrong: {}",
            error.trim_end_matches('.')
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_are_decoded_with_and_without_padding() {
        for text in [
            "data:application/octet-stream;base64,AAEC/w==",
            "data:;base64,AAEC/w",
            "DATA:;charset=utf-8;BASE64,AAEC/w==",
        ] {
            assert_eq!(decode(text, 0), Ok(vec![0, 1, 2, 255]));
        }
    }

    #[test]
    fn other_places_are_refused() {
        for (uri, said) in [
            ("a b.bin", "it uses geometry in another file, `a b.bin`, which is not read"),
            ("data:x", "it uses geometry in another file, `data:x`, which is not read"),
            ("data:,x", "the data of buffer 3 are not in base64"),
            ("data:;base64,?", "the base64 of buffer 3 is wrong"),
        ] {
            let problem = decode(uri, 3).expect_err("it is wrong").to_string();
            assert!(problem.starts_with(said), "{problem}");
        }
    }
}
