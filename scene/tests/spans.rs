//! Scenes that give spans as they are.
use glam::DVec3;
use specula_scene::{Needs, VertexCone, parse};

const SCENE: &str = r#"
ambient = 0.5
[camera]
viewer = "local"
eye = [1, 2, 3]
target = [0, 0, 0]
[[light]]
direction = [0, 0, 4]
[[light]]
kind = "point"
position = [0.5, 0, 2]
[[span]]
length = 5
normals = [[0, 0, 1], [0.6, 0, 0.8]]
[[span]]
length = 1
normals = [[0, 0, 1], [1, 0, 0], [0, 0, 0]]
face = [0, 0.6, -0.8]
positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
cone_cosines = [1, 0.5, -1]
start = [0.25, 0.25, 0.5]
end = [0, 0, 1]
[span.material]
shininess = 7
"#;

#[test]
fn spans_are_taken_to_the_last_bit() {
    let frame = parse("spans.toml", SCENE.into()).expect("the scene is right").frame;
    assert_eq!((frame.width, frame.height, frame.spans.len()), (5, 2, 2));
    assert_eq!((frame.ambient, frame.eye), ([0.5; 3], Some(DVec3::new(1.0, 2.0, 3.0))));
    assert_eq!(
        (frame.lights[0].direction, frame.local_lights[0].position),
        (DVec3::Z, DVec3::new(0.5, 0.0, 2.0))
    );
    let [first, second] =
        [0, 1].map(|k| (&frame.spans[k], &frame.triangles[k], frame.material(&frame.spans[k])));
    let turned = DVec3::new(0.6, 0.0, 0.8);
    assert_eq!(first.1.normals, [DVec3::Z, turned, DVec3::Z]);
    assert_eq!(
        (first.0.start, first.0.end, first.1.cones[1]),
        ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], VertexCone::flat(turned))
    );
    assert_eq!((second.0.y, second.0.length, second.2.shininess), (1, 1, 7));
    assert_eq!(second.1.normals, [DVec3::Z, DVec3::X, DVec3::ZERO]);
    assert_eq!((second.0.start, second.0.end), ([0.25, 0.25, 0.5], [0.0, 0.0, 1.0]));
    let mean = (2.0 * DVec3::Z + turned).normalize();
    assert!((first.1.facet.normal - mean).length() < 1e-15, "{:?}", first.1.facet);
    assert_eq!(second.1.facet.normal, DVec3::new(0.0, 0.6, -0.8));
    assert_eq!(second.1.facet.middle, DVec3::new(1.0, 1.0, 0.0) / 3.0);
    assert_eq!(second.1.cones.map(|cone| cone.cosine), [1.0, 0.5, -1.0]);
    assert_eq!(Needs::of(&frame).longest_span, 5);
}
