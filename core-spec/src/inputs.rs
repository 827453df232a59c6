//! A core's inputs by name, for whatever belongs to each of them: its port, its signal, its raw
//! value.
use std::marker::PhantomData;

use smallvec::SmallVec;

use crate::core_input::{CoreInput, InputRole};
use crate::input_meaning::InputMeaning;
use crate::parameters::CoreParameters;
use crate::quadratic::Quadratic;

/// One for each light of a core. Memory is allocated for more than two: room for all of
/// [`specula_scene::limits::MOST_LIGHTS`] in each would be copied with every span.
pub type Many<T> = SmallVec<[T; 2]>;

/// Inputs that go together: a struct that `inputs!` defines.
pub trait InputGroup {
    /// What belongs to each of them.
    type Value;
    /// The same inputs with something else for each.
    type Mapped<U>: InputGroup<Value = U>;

    /// Applies `f` to every input, in port order.
    fn map_each<U>(&self, f: &mut impl FnMut(&Self::Value) -> U) -> Self::Mapped<U>;

    /// Appends every input, in port order.
    fn append_to(&self, all: &mut Vec<Self::Value>)
    where
        Self::Value: Clone;
}

/// The inputs of a core, in port order: those that a method has for each span, ambient light, and
/// those of each light.
pub struct CoreInputs<S, L, T> {
    /// What the lights of a span have in common.
    pub span: S,
    /// Ambient light sent back, in LSBs.
    pub ambient: [T; 3],
    /// What belongs to each light, those at infinity first.
    pub lights: Many<LightInputs<L, T>>,
}

/// Inputs that belong to one light, in port order.
pub struct LightInputs<L, T> {
    /// What a method has for each light.
    pub light: L,
    /// What distance leaves of it, where it becomes weaker.
    pub attenuation: Option<Quadratic<T>>,
    /// Diffuse coefficients, in LSBs.
    pub diffuse: [T; 3],
    /// Specular coefficients, in LSBs.
    pub specular: [T; 3],
}

/// The inputs that a method asks for.
pub trait MethodInputs {
    /// Inputs that the lights of a span have in common.
    type SpanGroup: InputGroup<Value = CoreInput>;
    /// Inputs of each light, coefficients apart.
    type LightGroup: InputGroup<Value = CoreInput>;

    /// The inputs that the lights of a span have in common.
    fn span_inputs(&self, core: &CoreParameters) -> Self::SpanGroup;

    /// The inputs of light number `index`, those at places counted last.
    fn light_inputs(&self, core: &CoreParameters, index: usize) -> Self::LightGroup;

    /// All inputs of a core.
    fn core_inputs(
        &self,
        core: &CoreParameters,
    ) -> CoreInputs<Self::SpanGroup, Self::LightGroup, CoreInput> {
        let colour = |role: InputRole, name: &str| {
            CoreInput::colour(&coefficient_meaning(role), name, core.coefficient)
        };
        let light = |index: usize| LightInputs {
            light: self.light_inputs(core, index),
            attenuation: core.attenuation_inputs(index),
            diffuse: colour(InputRole::Diffuse, &format!("light{index}_diffuse")),
            specular: colour(InputRole::Specular, &format!("light{index}_specular")),
        };
        CoreInputs {
            span: self.span_inputs(core),
            ambient: colour(InputRole::Ambient, "ambient"),
            lights: (0..core.lights).map(light).collect(),
        }
    }
}

/// What a coefficient of ambient, diffuse or specular light is.
fn coefficient_meaning(role: InputRole) -> InputMeaning {
    let (what, computed) = match role {
        InputRole::Ambient => (
            "ambient light sent back",
            "255 times the material's ambient reflectance times the ambient light",
        ),
        InputRole::Diffuse => (
            "diffuse light sent back where N.L is 1",
            "255 times the material's diffuse reflectance times the light's colour",
        ),
        _ => (
            "specular light sent back at the middle of the highlight",
            "255 times the material's specular reflectance times the light's colour; 0 where the \
             light has no highlight",
        ),
    };
    InputMeaning::of(role, what, computed).in_unit("LSB")
}

impl<S: InputGroup<Value = T>, L: InputGroup<Value = T>, T> CoreInputs<S, L, T> {
    /// Applies `f` to every input, in port order.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> CoreInputs<S::Mapped<U>, L::Mapped<U>, U> {
        let f = &mut f;
        CoreInputs {
            span: self.span.map_each(f),
            ambient: self.ambient.each_ref().map(&mut *f),
            lights: self.lights.iter().map(|light| light.map_each(f)).collect(),
        }
    }

    /// Appends every input, in port order.
    pub fn append_to(&self, all: &mut Vec<T>)
    where
        T: Clone,
    {
        self.span.append_to(all);
        all.extend_from_slice(&self.ambient);
        self.lights.iter().for_each(|light| light.append_to(all));
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
}

impl<L: InputGroup<Value = T>, T> InputGroup for LightInputs<L, T> {
    type Value = T;
    type Mapped<U> = LightInputs<L::Mapped<U>, U>;

    fn map_each<U>(&self, f: &mut impl FnMut(&T) -> U) -> Self::Mapped<U> {
        LightInputs {
            light: self.light.map_each(f),
            attenuation: self.attenuation.as_ref().map(|attenuation| attenuation.map_each(f)),
            diffuse: self.diffuse.each_ref().map(&mut *f),
            specular: self.specular.each_ref().map(&mut *f),
        }
    }

    fn append_to(&self, all: &mut Vec<T>)
    where
        T: Clone,
    {
        self.light.append_to(all);
        self.attenuation.iter().for_each(|attenuation| attenuation.append_to(all));
        all.extend_from_slice(&self.diffuse);
        all.extend_from_slice(&self.specular);
    }
}

/// The inputs of spans whose lights have none in common.
pub struct NoInputs<T>(PhantomData<fn() -> T>);

impl<T> Default for NoInputs<T> {
    fn default() -> NoInputs<T> {
        NoInputs(PhantomData)
    }
}

impl<T> InputGroup for NoInputs<T> {
    type Value = T;
    type Mapped<U> = NoInputs<U>;

    fn map_each<U>(&self, _f: &mut impl FnMut(&T) -> U) -> NoInputs<U> {
        NoInputs::default()
    }

    fn append_to(&self, _all: &mut Vec<T>)
    where
        T: Clone,
    {
    }
}

/// Defines a struct of inputs that go together, in port order.
///
/// A field is `one` input, a `vector` of three, a `group(Type)` of inputs that is such a struct
/// itself, or any of these `_if_any`.
macro_rules! inputs {
    ($(#[$about:meta])* $name:ident { $($(#[$field_about:meta])* $field:ident: $kind:ident $(($inner:ident))?,)* }) => {
        $(#[$about])*
        pub struct $name<T> {
            $($(#[$field_about])* pub $field: inputs!(@type $kind $(($inner))?),)*
        }

        impl<T> $crate::inputs::InputGroup for $name<T> {
            type Value = T;
            type Mapped<U> = $name<U>;

            fn map_each<U>(&self, f: &mut impl FnMut(&T) -> U) -> $name<U> {
                $name { $($field: inputs!(@map f, &self.$field, $kind),)* }
            }

            fn append_to(&self, all: &mut Vec<T>)
            where
                T: Clone,
            {
                $(inputs!(@append all, &self.$field, $kind);)*
            }
        }
    };
    (@type one) => { T };
    (@type one_if_any) => { Option<T> };
    (@type vector) => { [T; 3] };
    (@type vector_if_any) => { Option<[T; 3]> };
    (@type group($inner:ident)) => { $inner<T> };
    (@type group_if_any($inner:ident)) => { Option<$inner<T>> };
    (@map $f:ident, $value:expr, one) => { $f($value) };
    (@map $f:ident, $value:expr, one_if_any) => { $value.as_ref().map(&mut *$f) };
    (@map $f:ident, $value:expr, vector) => { $value.each_ref().map(&mut *$f) };
    (@map $f:ident, $value:expr, vector_if_any) => { $value.as_ref().map(|v| v.each_ref().map(&mut *$f)) };
    (@map $f:ident, $value:expr, group) => { $crate::inputs::InputGroup::map_each($value, $f) };
    (@map $f:ident, $value:expr, group_if_any) => {
        $value.as_ref().map(|group| $crate::inputs::InputGroup::map_each(group, $f))
    };
    (@append $all:ident, $value:expr, one) => { $all.push($value.clone()) };
    (@append $all:ident, $value:expr, one_if_any) => { $all.extend($value.as_ref().cloned()) };
    (@append $all:ident, $value:expr, vector) => { $all.extend_from_slice($value) };
    (@append $all:ident, $value:expr, vector_if_any) => { $value.iter().for_each(|v| $all.extend_from_slice(v)) };
    (@append $all:ident, $value:expr, group) => { $crate::inputs::InputGroup::append_to($value, $all) };
    (@append $all:ident, $value:expr, group_if_any) => {
        $value.iter().for_each(|group| $crate::inputs::InputGroup::append_to(group, $all))
    };
}

pub(crate) use inputs;
