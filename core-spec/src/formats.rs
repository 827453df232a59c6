//! The formats of a method, by the names of its narrowing points.

/// Defines a struct of formats, one for each narrowing point, that can be found by their names.
macro_rules! formats {
    ($(#[$about:meta])* pub struct $name:ident { $($(#[$field_about:meta])* pub $field:ident: Format,)* }) => {
        $(#[$about])*
        pub struct $name {
            $($(#[$field_about])* pub $field: Format,)*
        }

        impl $name {
            /// The format of the narrowing point called `name`.
            pub(crate) fn named_mut(&mut self, name: &str) -> Option<&mut Format> {
                match name {
                    $(stringify!($field) => Some(&mut self.$field),)*
                    _ => None,
                }
            }
        }
    };
}

pub(crate) use formats;
