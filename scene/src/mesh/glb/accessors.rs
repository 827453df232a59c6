//! Elements of accessors: numbers in buffers, with any type, spacing and replacement [glTF 2.0,
//! 3.6.2].
use super::buffers::Buffers;
use super::json::{self, Document, Sparse, SparsePart, Whole};
use crate::mesh::error::MeshProblem;
use crate::mesh::warning::quoted;

/// Largest number of elements that exist without bytes in the file, because all of them are 0 or
/// replaced: without a limit, a few bytes could take all memory.
const MAX_WITHOUT_BYTES: usize = 1_000_000;

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Type 5120.
    I8,
    /// Type 5121.
    U8,
    /// Type 5122.
    I16,
    /// Type 5123.
    U16,
    /// Type 5125.
    U32,
    /// Type 5126.
    F32,
}

impl Component {
    fn of(code: Option<Whole>, whose: &str) -> Result<Component, MeshProblem> {
        Ok(match code.map(|code| code.0) {
            Some(5120) => Component::I8,
            Some(5121) => Component::U8,
            Some(5122) => Component::I16,
            Some(5123) => Component::U16,
            Some(5125) => Component::U32,
            Some(5126) => Component::F32,
            Some(code) => {
                return Err(syntax(format!(
                    "the component type of {whose} is {code}, which is none"
                )));
            }
            None => return Err(syntax(format!("{whose} has no component type"))),
        })
    }

    fn size(self) -> usize {
        match self {
            Component::I8 | Component::U8 => 1,
            Component::I16 | Component::U16 => 2,
            Component::U32 | Component::F32 => 4,
        }
    }

    /// The integer that represents 1 where integers represent fractions.
    fn full_scale(self) -> Option<f64> {
        match self {
            Component::I8 => Some(127.0),
            Component::U8 => Some(255.0),
            Component::I16 => Some(32767.0),
            Component::U16 => Some(65535.0),
            Component::U32 | Component::F32 => None,
        }
    }

    /// The number that the bytes encode; there are as many as the type has.
    fn value(self, bytes: &[u8]) -> f64 {
        let mut all = [0; 4];
        all[..bytes.len()].copy_from_slice(bytes);
        let bits = u32::from_le_bytes(all);
        match self {
            Component::I8 => f64::from(bits as i8),
            Component::U8 => f64::from(bits as u8),
            Component::I16 => f64::from(bits as i16),
            Component::U16 => f64::from(bits as u16),
            Component::U32 => f64::from(bits),
            Component::F32 => f64::from(f32::from_bits(bits)),
        }
    }
}

/// The elements of an accessor, all of which exist.
#[derive(Debug)]
pub struct Elements<'a> {
    /// The accessor's number.
    pub number: usize,
    /// Number of elements.
    pub count: usize,
    /// The type of each number.
    pub component: Component,
    /// The kind of element: `SCALAR`, `VEC3`, …
    pub kind: &'a str,
    normalized: bool,
    /// Bytes of an element.
    size: usize,
    /// All elements before replacement; `None` if all are 0.
    base: Option<Spaced<'a>>,
    replaced: Option<Replaced<'a>>,
}

/// Elements at equal distances.
#[derive(Debug)]
struct Spaced<'a> {
    bytes: &'a [u8],
    stride: usize,
}

impl<'a> Spaced<'a> {
    fn get(&self, index: usize, size: usize) -> Option<&'a [u8]> {
        self.bytes.get(index.checked_mul(self.stride)?..)?.get(..size)
    }
}

/// Elements that replace others.
#[derive(Debug)]
struct Replaced<'a> {
    /// Indices of the replaced elements, in rising order.
    indices: Vec<u32>,
    values: Spaced<'a>,
}

impl<'a> Elements<'a> {
    /// Looks an accessor up, and checks that all its elements exist.
    ///
    /// # Errors
    /// An accessor, view or buffer that does not exist or is too short, or a type that glTF does
    /// not have.
    pub fn new(
        document: &'a Document,
        buffers: &'a Buffers<'a>,
        Whole(number): Whole,
    ) -> Result<Elements<'a>, MeshProblem> {
        let missing = || {
            syntax(format!(
                "accessor {number} is named, but there are only {}",
                document.accessors.len()
            ))
        };
        let accessor = document.accessors.get(number).ok_or_else(missing)?;
        let whose = format!("accessor {number}");
        let component = Component::of(accessor.component_type, &whose)?;
        let kind = accessor.kind.as_deref().unwrap_or_default();
        let parts = parts(kind)
            .ok_or_else(|| syntax(format!("the type of {whose} is {}", quoted(kind.as_bytes()))))?;
        let size = parts * component.size();
        let Whole(count) = accessor.count.ok_or_else(|| syntax(format!("{whose} has no count")))?;
        let base = base(accessor, buffers, count, size, &whose)?;
        let sparse = accessor.sparse.as_deref().filter(|sparse| sparse.count.0 > 0);
        let replaced =
            sparse.map(|sparse| Replaced::new(sparse, buffers, count, size, &whose)).transpose()?;
        Ok(Elements {
            number,
            count,
            component,
            kind,
            normalized: accessor.normalized,
            size,
            base,
            replaced,
        })
    }

    /// Number of replaced elements.
    pub fn replaced_count(&self) -> usize {
        self.replaced.as_ref().map_or(0, |replaced| replaced.indices.len())
    }

    /// Whether the file has no bytes for it, so that all elements are 0.
    pub fn has_no_bytes(&self) -> bool {
        self.base.is_none() && self.replaced.is_none()
    }

    /// The first `N` numbers of an element; 0 beyond its own, and beyond the last element.
    pub fn numbers<const N: usize>(&self, index: usize) -> [f64; N] {
        let bytes = self.bytes(index);
        std::array::from_fn(|k| self.scaled(self.raw(bytes, k)))
    }

    /// An element that is a single integer.
    pub fn integer(&self, index: usize) -> u32 {
        self.raw(self.bytes(index), 0) as u32
    }

    fn bytes(&self, index: usize) -> &'a [u8] {
        let replaced = self.replaced.as_ref().and_then(|replaced| replaced.get(index, self.size));
        replaced.or_else(|| self.base.as_ref()?.get(index, self.size)).unwrap_or_default()
    }

    /// The `k`-th number of an element as it is stored.
    fn raw(&self, element: &[u8], k: usize) -> f64 {
        let size = self.component.size();
        element.get(k * size..(k + 1) * size).map_or(0.0, |bytes| self.component.value(bytes))
    }

    /// An integer converted to the fraction that it represents [glTF 2.0, 3.6.2.1: max(c / 127,
    /// -1)].
    fn scaled(&self, value: f64) -> f64 {
        match self.component.full_scale().filter(|_| self.normalized) {
            Some(full_scale) => (value / full_scale).max(-1.0),
            None => value,
        }
    }
}

/// All elements before replacement.
fn base<'a>(
    accessor: &json::Accessor,
    buffers: &'a Buffers<'a>,
    count: usize,
    size: usize,
    whose: &str,
) -> Result<Option<Spaced<'a>>, MeshProblem> {
    match accessor.buffer_view {
        Some(view) => spaced(buffers, view, accessor.byte_offset, count, size, whose).map(Some),
        None if count > MAX_WITHOUT_BYTES => Err(syntax(format!(
            "{whose} has {count} elements without bytes; at most {MAX_WITHOUT_BYTES} are read"
        ))),
        None => Ok(None),
    }
}

/// `count` elements in a view, which is checked to contain them.
fn spaced<'a>(
    buffers: &'a Buffers<'a>,
    view: Whole,
    Whole(offset): Whole,
    count: usize,
    size: usize,
    whose: &str,
) -> Result<Spaced<'a>, MeshProblem> {
    let (bytes, stride) = buffers.view(view)?;
    let stride = stride.unwrap_or(size);
    if stride < size {
        return Err(syntax(format!("{whose} has elements of {size} bytes, {stride} apart")));
    }
    let beyond = || MeshProblem::Truncated(format!("{whose} reaches beyond its data"));
    let bytes = bytes.get(offset..).ok_or_else(beyond)?;
    let needed = match count.checked_sub(1) {
        Some(gaps) => gaps.checked_mul(stride).and_then(|gaps| gaps.checked_add(size)),
        None => Some(0),
    };
    match needed {
        Some(needed) if needed <= bytes.len() => Ok(Spaced { bytes, stride }),
        _ => Err(beyond()),
    }
}

impl<'a> Replaced<'a> {
    fn new(
        sparse: &Sparse,
        buffers: &'a Buffers<'a>,
        elements: usize,
        size: usize,
        whose: &str,
    ) -> Result<Replaced<'a>, MeshProblem> {
        let Whole(count) = sparse.count;
        let component = Component::of(sparse.indices.component_type, whose)?;
        if !is_index(component) {
            return Err(syntax(format!("the sparse indices of {whose} are not unsigned integers")));
        }
        let part = |part: &SparsePart, size| {
            let view = part
                .buffer_view
                .ok_or_else(|| syntax(format!("{whose} is sparse, but names no view for it")))?;
            spaced(buffers, view, part.byte_offset, count, size, whose)
        };
        let places = part(&sparse.indices, component.size())?;
        let mut indices: Vec<u32> = Vec::new();
        for k in 0..count {
            let index = component.value(places.get(k, component.size()).unwrap_or_default()) as u32;
            if indices.last().is_some_and(|&last| last >= index) || index as usize >= elements {
                return Err(syntax(format!(
                    "the sparse indices of {whose} do not rise, or reach beyond its {elements} elements"
                )));
            }
            indices.push(index);
        }
        Ok(Replaced { indices, values: part(&sparse.values, size)? })
    }

    fn get(&self, index: usize, size: usize) -> Option<&'a [u8]> {
        let index = u32::try_from(index).ok()?;
        self.values.get(self.indices.binary_search(&index).ok()?, size)
    }
}

/// Whether numbers of this type can be indices.
pub fn is_index(component: Component) -> bool {
    matches!(component, Component::U8 | Component::U16 | Component::U32)
}

/// Number of numbers in an element. Matrices are not read, since nothing that is drawn has them.
fn parts(kind: &str) -> Option<usize> {
    match kind {
        "SCALAR" => Some(1),
        "VEC2" => Some(2),
        "VEC3" => Some(3),
        "VEC4" => Some(4),
        _ => None,
    }
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}
