//! The zigzag of figure 8: a folded sheet whose vertex normals are all equal.
use glam::{DAffine3, DVec3};
use specula_scene::mesh::Mesh;
use specula_scene::picture::camera::Camera;
use specula_scene::picture::{Light, LightSource, LightSpace, Object, Scene};
use specula_scene::{Facet, Frame, Material, SceneError};

/// Folds, each up and down; the sheet begins and ends in a valley.
const FOLDS: u32 = 5;
/// Degrees by which the facets are inclined.
const SLOPE: f64 = 40.0;
/// The sheet's length along its folds, in widths of a facet.
const LENGTH: f64 = 5.0;
/// Degrees from the sheet's normal to the light, across the folds.
const LIGHT: f64 = 60.0;

/// The zigzag under one light of full strength, seen a little from below so that all of its facets
/// are visible.
///
/// # Errors
/// [`SceneError`] if the picture has no room for it.
pub fn zigzag(size: (u32, u32)) -> Result<Frame, SceneError> {
    let scene = Scene {
        size,
        background: [0; 3],
        camera: Camera { direction: DVec3::new(0.0, -0.5, 1.0), ..Camera::default() },
        ambient: [0.0; 3],
        lights: vec![Light {
            source: LightSource::Directional { direction: light() },
            space: LightSpace::World,
            colour: [1.0; 3],
        }],
        objects: vec![Object {
            mesh: mesh().into(),
            primitive: None,
            place: DAffine3::IDENTITY,
            material: Material {
                ambient: [0.0; 3],
                diffuse: [1.0; 3],
                specular: [0.0; 3],
                shininess: 1,
            }
            .into(),
        }],
    };
    scene.frame().map_err(|error| SceneError::picture("zigzag", error))
}

fn light() -> DVec3 {
    let (sine, cosine) = libm::sincos(LIGHT.to_radians());
    DVec3::new(sine, 0.0, cosine)
}

/// Ridges and valleys run along y; z is up.
fn mesh() -> Mesh {
    let height = libm::tan(SLOPE.to_radians());
    let lines = 2 * FOLDS + 1;
    let place = |line: u32, y: f64| DVec3::new(f64::from(line), y, f64::from(line % 2) * height);
    let positions: Vec<DVec3> =
        (0..lines).flat_map(|line| [place(line, 0.0), place(line, LENGTH)]).collect();
    let halves = |k: u32| {
        let [a, b, c, d] = [2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 3];
        [[a, c, d], [a, d, b]]
    };
    let triangles: Vec<[u32; 3]> = (0..lines - 1).flat_map(halves).collect();
    let normals = [DVec3::Z; 3];
    let facet = |corners: &[u32; 3]| {
        let corners = corners.map(|k| positions[k as usize]);
        Facet::of_polygon(&corners).unwrap_or(Facet::of_vertices(&normals, &corners))
    };
    Mesh {
        facets: triangles.iter().map(facet).collect(),
        normals: vec![normals; triangles.len()],
        triangles,
        positions,
        materials: Vec::new(),
        material_indices: Vec::new(),
    }
}
