//! What an input is, for those who feed a core.
use std::borrow::Cow;

use crate::core_input::InputRole;

/// What an input is, its unit, and how a host computes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputMeaning {
    /// What it tells of a scene.
    pub role: InputRole,
    /// What it is, such as `N0, the normal at the first pixel, x`.
    pub what: Cow<'static, str>,
    /// The unit of its value; `1` of a number without one.
    pub unit: &'static str,
    /// How the host computes it, before it is rounded to the port's format.
    pub computed: Cow<'static, str>,
}

impl InputMeaning {
    /// What grows along a span and how it is computed: a number without a unit.
    pub(crate) fn surface(
        what: impl Into<Cow<'static, str>>,
        computed: impl Into<Cow<'static, str>>,
    ) -> InputMeaning {
        InputMeaning::of(InputRole::Surface, what, computed)
    }

    /// What tells of lights and how it is computed: a number without a unit.
    pub(crate) fn light(
        what: impl Into<Cow<'static, str>>,
        computed: impl Into<Cow<'static, str>>,
    ) -> InputMeaning {
        InputMeaning::of(InputRole::Light, what, computed)
    }

    /// What an input of a role is and how it is computed: a number without a unit.
    pub(crate) fn of(
        role: InputRole,
        what: impl Into<Cow<'static, str>>,
        computed: impl Into<Cow<'static, str>>,
    ) -> InputMeaning {
        InputMeaning { role, what: what.into(), unit: "1", computed: computed.into() }
    }

    /// The same in a unit.
    pub(crate) fn in_unit(self, unit: &'static str) -> InputMeaning {
        InputMeaning { unit, ..self }
    }

    /// The same of one component of a vector or of a colour.
    pub(crate) fn component(&self, component: &str) -> InputMeaning {
        InputMeaning { what: format!("{}, {component}", self.what).into(), ..self.clone() }
    }

    /// The increment of the weight along a span, which most methods have.
    pub(crate) fn weight_step() -> InputMeaning {
        InputMeaning::surface(
            "what the weight t grows by with each pixel",
            "1/(pixels - 1), 0 for one pixel",
        )
        .in_unit("1/pixel")
    }

    /// L of a light at infinity.
    pub(crate) fn direction() -> InputMeaning {
        InputMeaning::light("L, towards the light", "the unit vector from the scene to the light")
    }

    /// L·V.
    pub(crate) fn light_dot_view() -> InputMeaning {
        InputMeaning::light("L.V", "the z of the unit vector towards the light, as V = (0, 0, 1)")
    }

    /// What a `value`, a formula such as `N.L`, is at a span's first pixel.
    pub(crate) fn at_first_pixel(value: &str) -> InputMeaning {
        InputMeaning::surface(format!("{value} at the first pixel"), "the same at pixel 0")
    }

    /// What a `value` that is linear in the pixel number grows by.
    pub(crate) fn step(value: &str) -> InputMeaning {
        InputMeaning::surface(
            format!("what {value} grows by with each pixel"),
            "(last pixel's - first pixel's)/(pixels - 1), 0 for one pixel",
        )
        .in_unit("1/pixel")
    }

    /// What a `value` that is quadratic in the pixel number first grows by.
    pub(crate) fn first_difference(value: &str) -> InputMeaning {
        InputMeaning::surface(
            format!("first difference of {value}"),
            "value at pixel 1 less that at pixel 0, 0 for one pixel",
        )
        .in_unit("1/pixel")
    }

    /// What that growth itself grows by.
    pub(crate) fn second_difference(value: &str) -> InputMeaning {
        InputMeaning::surface(
            format!("second difference of {value}"),
            "value at pixel 2 - twice that at pixel 1 + that at pixel 0, 0 for up to two pixels",
        )
        .in_unit("1/pixel^2")
    }

    /// The vector at the first pixel of a span and what it changes by up to the last.
    pub(crate) fn along_span(vector: &str, computed: &'static str) -> [InputMeaning; 2] {
        [
            InputMeaning::surface(format!("{vector} at the first pixel"), computed),
            InputMeaning::surface(
                format!("{vector} at the last pixel less that at the first"),
                "both as they are rounded, so that the end is met",
            ),
        ]
    }

    /// The vertex normals, interpolated linearly along a span.
    pub(crate) fn normal_along_span() -> [InputMeaning; 2] {
        InputMeaning::along_span(
            "the normal N",
            "vertex normals interpolated at the pixel's centre; those of both ends scaled by one \
             factor so that the longer has length 1",
        )
    }

    /// L·V that is set up for each span.
    pub(crate) fn light_dot_view_of_spans() -> InputMeaning {
        let computed = "the z of the unit vector towards the light; 1 in a span without a normal";
        InputMeaning { computed: computed.into(), ..InputMeaning::light_dot_view() }
    }

    /// H.
    pub(crate) fn unit_halfway() -> InputMeaning {
        InputMeaning::light(
            "H, half-way between light and eye",
            "(L + V)/|L + V| with V = (0, 0, 1); 0 where L = -V",
        )
    }
}
