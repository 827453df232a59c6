//! The container of a `.glb` file: a header, a chunk of JSON, and possibly a chunk of bytes [glTF
//! 2.0, 4].
use crate::mesh::error::MeshProblem;
use crate::mesh::warning::Notices;

/// Bytes of the header.
const HEADER: usize = 12;

/// Bytes before a chunk's data: its length and its type.
const CHUNK_HEADER: usize = 8;

/// The two chunks that are read.
#[derive(Debug, PartialEq)]
pub struct Container<'a> {
    /// The JSON text, as bytes.
    pub json: &'a [u8],
    /// The binary chunk.
    pub binary: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    /// Splits a file into its chunks. Chunks of other types are skipped.
    ///
    /// # Errors
    /// A file that is no `.glb` of version 2, or ends early.
    pub fn read(bytes: &'a [u8], notices: &mut Notices) -> Result<Container<'a>, MeshProblem> {
        let mut chunks = chunks(bytes)?;
        let json = match next_chunk(&mut chunks)? {
            Some((b"JSON", json)) => json,
            Some(_) => return Err(syntax("its first chunk is not JSON".into())),
            None => return Err(MeshProblem::Truncated("it has no JSON chunk".into())),
        };
        let mut binary = None;
        while let Some((kind, data)) = next_chunk(&mut chunks)? {
            if kind == b"BIN\0" && binary.is_none() {
                binary = Some(data);
            } else {
                notices.add("chunk", None, || {
                    "a chunk beside JSON and the first of bytes is passed over".into()
                });
            }
        }
        Ok(Container { json, binary })
    }
}

/// The bytes after the header, up to the length that it states.
fn chunks(bytes: &[u8]) -> Result<&[u8], MeshProblem> {
    if !bytes.starts_with(b"glTF") {
        return Err(syntax("it does not start with `glTF`".into()));
    }
    let header = MeshProblem::Truncated(format!("a .glb has a header of {HEADER} bytes"));
    let (Some(version), Some(stated)) = (number(bytes, 4), number(bytes, 8)) else {
        return Err(header);
    };
    if version != 2 {
        return Err(syntax(format!("it is version {version} of binary glTF; version 2 is read")));
    }
    match stated as usize {
        stated if stated > bytes.len() => {
            let text = format!("its header states {stated} bytes; the file has {}", bytes.len());
            Err(MeshProblem::Truncated(text))
        }
        stated if stated < HEADER => Err(syntax(format!("its header states {stated} bytes"))),
        stated => Ok(&bytes[HEADER..stated]),
    }
}

type Chunk<'a> = (&'a [u8], &'a [u8]);

/// Cuts the first chunk off: its type and its data.
fn next_chunk<'a>(rest: &mut &'a [u8]) -> Result<Option<Chunk<'a>>, MeshProblem> {
    // Fewer bytes than a chunk's header are padding.
    let Some((header, behind)) = rest.split_at_checked(CHUNK_HEADER) else { return Ok(None) };
    let stated = number(header, 0).unwrap_or_default() as usize;
    let (data, behind) = behind.split_at_checked(stated).ok_or_else(|| {
        MeshProblem::Truncated(format!("a chunk states {stated} bytes; {} follow", behind.len()))
    })?;
    *rest = behind;
    Ok(Some((&header[4..], data)))
}

/// The 32-bit number at an offset, the least significant byte first.
fn number(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..)?.first_chunk()?;
    Some(u32::from_le_bytes(*bytes))
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}
