//! A test for each method: they run side by side, and each has output of its own.

/// Makes a module called as the function `$check` is, with a test for each method that calls the
/// function with it.
macro_rules! each_method {
    ($check:ident) => {
        each_method! {
            $check:
            consistent = Consistent, direct = Direct, duff = Duff, gouraud = Gouraud, hybrid = Hybrid, lyon = Lyon,
            phong = Phong, reflection = Reflection, slerp = Slerp,
        }
    };
    ($check:ident: $($name:ident = $method:ident,)*) => {
        mod $check {
            use specula_spec::Method;

            // Nothing is forgotten.
            const _: [Method; Method::ALL.len()] = [$(Method::$method),*];

            $(#[test]
            fn $name() {
                super::$check(Method::$method);
            })*
        }
    };
}
