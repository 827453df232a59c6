//! A core's inputs by name, for whatever belongs to each of them: its port, its signal, its raw
//! value.
use smallvec::SmallVec;
use specula_scene::limits::MOST_LIGHTS;

/// Inputs of each light of a core, which has [`MOST_LIGHTS`] at most: no memory is allocated for
/// them.
pub type Many<T> = SmallVec<[T; MOST_LIGHTS]>;

/// Inputs that go together: a struct that `inputs!` defines.
pub trait EachInput {
    /// What belongs to each of them.
    type Value;

    /// Applies `f` to every input, in port order.
    fn each(&self, f: impl FnMut(&Self::Value) -> Self::Value) -> Self;
}

/// Defines a struct of a core's inputs, in port order, with `map` over all of them.
///
/// A field is `one` input, a `vector` of three, a `group(Type)` of inputs that is such a struct
/// itself, any of these `_if_any`, or `many(Type)` of them.
macro_rules! inputs {
    ($(#[$about:meta])* $name:ident { $($(#[$field_about:meta])* $field:ident: $kind:ident $(($inner:ident))?,)* }) => {
        $(#[$about])*
        pub struct $name<T> {
            $($(#[$field_about])* pub $field: inputs!(@type $kind $(($inner))?),)*
        }

        impl<T> $name<T> {
            /// Applies `f` to every input, in port order.
            pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> $name<U> {
                self.map_with(&mut f)
            }

            /// As `map`, for those that go on with `f` afterwards.
            pub(crate) fn map_with<U>(&self, f: &mut impl FnMut(&T) -> U) -> $name<U> {
                $name { $($field: inputs!(@map f, &self.$field, $kind),)* }
            }

            /// Every input, in port order.
            pub fn to_vec(&self) -> Vec<T>
            where
                T: Clone,
            {
                let mut all = Vec::new();
                self.append_to(&mut all);
                all
            }

            /// Appends every input, in port order.
            pub(crate) fn append_to(&self, all: &mut Vec<T>)
            where
                T: Clone,
            {
                $(inputs!(@append all, &self.$field, $kind);)*
            }
        }

        impl<T> $crate::EachInput for $name<T> {
            type Value = T;

            fn each(&self, f: impl FnMut(&T) -> T) -> Self {
                self.map(f)
            }
        }
    };
    (@type one) => { T };
    (@type one_if_any) => { Option<T> };
    (@type vector) => { [T; 3] };
    (@type vector_if_any) => { Option<[T; 3]> };
    (@type group($inner:ident)) => { $inner<T> };
    (@type group_if_any($inner:ident)) => { Option<$inner<T>> };
    (@type many($inner:ident)) => { $crate::inputs::Many<$inner<T>> };
    (@map $f:ident, $value:expr, one) => { $f($value) };
    (@map $f:ident, $value:expr, one_if_any) => { $value.as_ref().map(&mut *$f) };
    (@map $f:ident, $value:expr, vector) => { $value.each_ref().map(&mut *$f) };
    (@map $f:ident, $value:expr, vector_if_any) => { $value.as_ref().map(|v| v.each_ref().map(&mut *$f)) };
    (@map $f:ident, $value:expr, group) => { $value.map_with($f) };
    (@map $f:ident, $value:expr, group_if_any) => { $value.as_ref().map(|group| group.map_with($f)) };
    (@map $f:ident, $value:expr, many) => { $value.iter().map(|each| each.map_with($f)).collect() };
    (@append $all:ident, $value:expr, one) => { $all.push($value.clone()) };
    (@append $all:ident, $value:expr, one_if_any) => { $all.extend($value.as_ref().cloned()) };
    (@append $all:ident, $value:expr, vector) => { $all.extend_from_slice($value) };
    (@append $all:ident, $value:expr, vector_if_any) => { $value.iter().for_each(|v| $all.extend_from_slice(v)) };
    (@append $all:ident, $value:expr, group) => { $value.append_to($all) };
    (@append $all:ident, $value:expr, group_if_any) => { $value.iter().for_each(|group| group.append_to($all)) };
    (@append $all:ident, $value:expr, many) => { $value.iter().for_each(|each| each.append_to($all)) };
}

pub(super) use inputs;
