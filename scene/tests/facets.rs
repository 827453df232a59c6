//! The polygon's own normal [lecture, eq. 1.1 and 2.1], from the file to the frame.
use glam::{DAffine3, DQuat, DVec3};
use specula_scene::mesh::normals::newell;
use specula_scene::{Facet, Frame, load};

/// Corners of a warped quadrilateral, all of whose vertex normals point along z.
const WARPED: [DVec3; 4] = [
    DVec3::new(0.0, 0.0, 0.0),
    DVec3::new(2.0, 0.0, 0.4),
    DVec3::new(2.0, 1.0, -0.2),
    DVec3::new(0.0, 1.5, 0.3),
];

/// The face of an `.obj` file with these corners, once as it is and once the other way round.
fn objects(corners: &[DVec3]) -> [String; 2] {
    let vertices: String = corners.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).collect();
    let words: Vec<String> = (1..=corners.len()).map(|k| format!("{k}//1")).collect();
    let backwards: Vec<String> = words.iter().rev().cloned().collect();
    [words, backwards].map(|words| format!("{vertices}vn 0 0 1\nf {}\n", words.join(" ")))
}

/// The frame of a mesh seen along z, put where `table` says.
fn frame(mesh: &str, extension: &str, table: &str) -> Frame {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let put = |name: &str, text: String| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a temporary file can be written");
        path
    };
    put(&format!("mesh.{extension}"), mesh.to_owned());
    let scene = format!(
        "size = [60, 40]\n[camera]\ndirection = [0, 0, 1]\n\
         [[object]]\nmesh = \"mesh.{extension}\"\n{table}\n"
    );
    let path = put("scene.toml", scene);
    load(path.to_str().expect("temporary paths are plain"), None).expect("it can be seen").frame
}

/// Every triangle that is seen has this facet.
#[track_caller]
fn all_have(frame: &Frame, normal: DVec3, middle: DVec3) {
    for triangle in &frame.triangles {
        let off =
            (triangle.facet.normal - normal).length() + (triangle.facet.middle - middle).length();
        assert!(off < 1e-12, "{:?} instead of {normal} and {middle}", triangle.facet);
    }
}

#[test]
fn triangles_of_a_quadrilateral_have_its_one_normal() {
    let Facet { normal, middle } = Facet::of_polygon(&WARPED).expect("it has an area");
    for mesh in objects(&WARPED) {
        let frame = frame(&mesh, "obj", "");
        assert_eq!(frame.triangles.len(), 2);
        all_have(&frame, normal, middle);
        // Triangles of it are turned otherwise, and so are its vertices' normals.
        for triangle in &frame.triangles {
            let own = newell(&triangle.positions).expect("it has an area");
            assert!(own.cross(normal).length() > 0.05, "{own} {normal}");
            assert_eq!(triangle.normals, [DVec3::Z; 3]);
        }
    }
}

/// Newell's sum goes with the surface as normals do, whatever is done to it; the side that is seen
/// is lit, also where that is the back.
#[test]
fn facets_are_turned_stretched_and_mirrored_with_the_surface() {
    for scale in [[1.0, 2.0, 3.0], [-1.0, 2.0, 0.5], [2.0, -1.0, -3.0], [-1.0; 3]] {
        for rotate in [[0.0; 3], [20.0, -30.0, 200.0], [0.0, 180.0, 0.0], [160.0, 10.0, 70.0]] {
            let table = format!("scale = {scale:?}\nrotate = {rotate:?}");
            let [x, y, z] = rotate.map(f64::to_radians);
            let turn =
                DQuat::from_rotation_z(z) * DQuat::from_rotation_y(y) * DQuat::from_rotation_x(x);
            let place = DAffine3::from_scale_rotation_translation(scale.into(), turn, DVec3::ZERO);
            let places = WARPED.map(|corner| place.transform_point3(corner));
            let Facet { normal, middle } = Facet::of_polygon(&places).expect("it has an area");
            for mesh in objects(&WARPED) {
                all_have(&frame(&mesh, "obj", &table), normal * normal.z.signum(), middle);
            }
        }
    }
}

/// A polygon of a `.ply` file has its own normal too.
#[test]
fn polygons_of_other_files_have_their_normal() {
    let corners: String = WARPED.iter().map(|p| format!("{} {} {}\n", p.x, p.y, p.z)).collect();
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         {corners}4 0 1 2 3\n"
    );
    let Facet { normal, middle } =
        Facet::of_polygon(&WARPED.map(|p| p.as_vec3().as_dvec3())).expect("it has an area");
    let frame = frame(&ply, "ply", "");
    assert_eq!(frame.triangles.len(), 2);
    for Facet { normal: n, middle: m } in frame.triangles.iter().map(|triangle| triangle.facet) {
        assert!((n - normal).length() + (m - middle).length() < 1e-6, "{n} {m}");
    }
}
