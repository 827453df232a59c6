//! Bundles of signals that cross the border of a unit.
use super::{Sig, Vector};

/// Signals that go together.
pub trait Bundle: Sized {
    /// Applies `f` to every signal; `suffix` tells them apart in names.
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Self;
}

impl Bundle for Sig {
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Sig {
        f(self, "")
    }
}

impl Bundle for Vector {
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Vector {
        // The components stay the same at heart, so what has been stated of the length stays true.
        self.at([(&self.x, "_x"), (&self.y, "_y"), (&self.z, "_z")].map(|(sig, axis)| f(sig, axis)))
    }
}

impl<B: Bundle> Bundle for Vec<B> {
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Vec<B> {
        let one = |(i, b): (usize, &B)| b.map(&mut |sig, suffix| f(sig, &format!("_{i}{suffix}")));
        self.iter().enumerate().map(one).collect()
    }
}

impl<A: Bundle, B: Bundle> Bundle for (A, B) {
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> (A, B) {
        (self.0.map(f), self.1.map(f))
    }
}

impl<A: Bundle, B: Bundle, C: Bundle> Bundle for (A, B, C) {
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> (A, B, C) {
        (self.0.map(f), self.1.map(f), self.2.map(f))
    }
}

/// The named inputs of a unit.
pub trait Inputs {
    /// What the unit's body gets.
    type Values;
    /// Applies `f` to every signal and its port's name.
    fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Self::Values;
}

macro_rules! inputs {
    ($($bundle:ident $index:tt),+) => {
        impl<$($bundle: Bundle),+> Inputs for ($((&str, &$bundle),)+) {
            type Values = ($($bundle,)+);
            fn map(&self, f: &mut dyn FnMut(&Sig, &str) -> Sig) -> Self::Values {
                ($({ let (name, bundle) = self.$index; bundle.map(&mut |sig, suffix| f(sig, &format!("{name}{suffix}"))) },)+)
            }
        }
    };
}

inputs!(A 0);
inputs!(A 0, B 1);
inputs!(A 0, B 1, C 2);
inputs!(A 0, B 1, C 2, D 3);
inputs!(A 0, B 1, C 2, D 3, E 4);
inputs!(A 0, B 1, C 2, D 3, E 4, F 5);
