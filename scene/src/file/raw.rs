//! A scene file as it is written, before its values are checked.
use serde::Deserialize;
use toml::Spanned;

use super::values::{Integer, Number, OneOrMore, Triple, Vector};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub size: Option<Spanned<[Integer; 2]>>,
    pub background: Option<Spanned<Triple>>,
    pub ambient: Option<Spanned<Triple>>,
    pub camera: Option<Spanned<Camera>>,
    #[serde(default)]
    pub light: Vec<Spanned<Light>>,
    #[serde(default)]
    pub object: Vec<Spanned<Object>>,
    #[serde(default)]
    pub span: Vec<Spanned<Span>>,
    pub sequence: Option<Spanned<Sequence>>,
    pub core: Option<Spanned<toml::Table>>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sequence {
    pub frames: Spanned<Integer>,
    #[serde(default)]
    pub motion: Vec<Spanned<Motion>>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Motion {
    pub of: Spanned<String>,
    pub turn: Option<Spanned<OneOrMore<Number>>>,
    pub orbit: Option<Spanned<OneOrMore<Number>>>,
    pub translate: Option<Spanned<OneOrMore<Vector>>>,
    pub axis: Option<Spanned<Vector>>,
    pub centre: Option<Spanned<Vector>>,
    pub at: Option<Spanned<Vec<Integer>>>,
    pub steps: Option<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Camera {
    pub kind: Option<Spanned<String>>,
    pub direction: Option<Spanned<Vector>>,
    pub eye: Option<Spanned<Vector>>,
    pub viewer: Option<Spanned<String>>,
    pub target: Option<Spanned<Vector>>,
    pub up: Option<Spanned<Vector>>,
    pub height: Option<Spanned<Number>>,
    pub field_of_view: Option<Spanned<Number>>,
    pub near: Option<Spanned<Number>>,
    pub interpolation: Option<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Light {
    pub kind: Option<Spanned<String>>,
    pub direction: Option<Spanned<Vector>>,
    pub position: Option<Spanned<Vector>>,
    pub target: Option<Spanned<Vector>>,
    pub exponent: Option<Spanned<Integer>>,
    pub attenuation: Option<Spanned<Attenuation>>,
    pub space: Option<Spanned<String>>,
    pub colour: Option<Spanned<Triple>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Attenuation {
    pub constant: Option<Spanned<Number>>,
    pub linear: Option<Spanned<Number>>,
    pub quadratic: Option<Spanned<Number>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Object {
    pub mesh: Option<Spanned<String>>,
    pub primitive: Option<Spanned<String>>,
    pub level: Option<Spanned<Integer>>,
    pub tube: Option<Spanned<Number>>,
    pub translate: Option<Spanned<Vector>>,
    pub rotate: Option<Spanned<Vector>>,
    pub scale: Option<Spanned<Triple>>,
    #[serde(default)]
    pub material: Material,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Span {
    pub length: Spanned<Integer>,
    pub normals: Spanned<Vec<Vector>>,
    pub face: Option<Spanned<Vector>>,
    pub positions: Option<Spanned<Vec<Vector>>>,
    pub cone_cosines: Option<Spanned<Vector>>,
    pub start: Option<Spanned<Vector>>,
    pub end: Option<Spanned<Vector>>,
    #[serde(default)]
    pub material: Material,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub ambient: Option<Spanned<Triple>>,
    pub diffuse: Option<Spanned<Triple>>,
    pub specular: Option<Spanned<Triple>>,
    pub shininess: Option<Spanned<Integer>>,
}
