//! Polygons of mesh files in triangles: what they cover is what an even-odd fill of the polygon
//! covers, once, whichever corner is first and whichever way round the corners are given.
mod fill;
mod shapes;

use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use glam::{DMat3, DVec3};
use specula_fixtures::Draw;
use specula_scene::mesh::{Mesh, Warning};

use fill::{area, area_around, covers, is_inside, probes};
use shapes::{Place, bridged, comb, edges, roughened, spiral, star, tangled, with_holes};

/// Points that each polygon is probed at.
const PROBES: usize = 120;

/// A plane in space: its axes and its origin.
struct Plane {
    axes: DMat3,
    origin: DVec3,
}

impl Plane {
    fn flat() -> Plane {
        Plane { axes: DMat3::IDENTITY, origin: DVec3::ZERO }
    }

    fn any(draw: &mut Draw) -> Plane {
        let mut vector = || DVec3::new(draw.unit() - 0.5, draw.unit() - 0.5, draw.unit() - 0.5);
        let normal = vector().normalize_or(DVec3::Y);
        let (across, up) = normal.any_orthonormal_pair();
        Plane { axes: DMat3::from_cols(across, up, normal), origin: vector() * 100.0 }
    }

    fn point(&self, [x, y]: Place) -> DVec3 {
        self.origin + self.axes * DVec3::new(x, y, 0.0)
    }

    fn place(&self, point: DVec3) -> Place {
        let local = self.axes.transpose() * (point - self.origin);
        [local.x, local.y]
    }
}

/// An `.obj` file of one face; corners at the same place are one vertex if `shared`, else each has
/// its own.
fn obj(polygon: &[Place], plane: &Plane, shared: bool) -> String {
    let (mut vertices, mut text, mut face) = (Vec::<Place>::new(), String::new(), "f".to_owned());
    for &corner in polygon {
        let known = if shared { vertices.iter().position(|&v| v == corner) } else { None };
        let index = known.unwrap_or_else(|| {
            let DVec3 { x, y, z } = plane.point(corner);
            writeln!(text, "v {x} {y} {z}").expect("writing to a string does not fail");
            vertices.push(corner);
            vertices.len() - 1
        });
        write!(face, " {}", index + 1).expect("writing to a string does not fail");
    }
    format!("{text}{face}\n")
}

/// The triangles of a file, in the plane, and what was warned of.
fn read(text: &str, plane: &Plane) -> (Vec<[Place; 3]>, Vec<Warning>) {
    match Mesh::from_bytes(Path::new("a.obj"), text.as_bytes()) {
        Ok((mesh, warnings)) => {
            let corners = |t: &[u32; 3]| t.map(|k| plane.place(mesh.positions[k as usize]));
            (mesh.triangles.iter().map(corners).collect(), warnings)
        }
        Err(error) => {
            assert!(error.to_string().contains("no triangles with an area"), "{error}");
            (vec![], vec![])
        }
    }
}

/// Compares what a polygon's triangles cover with the even-odd fill, from every first corner and
/// both ways round.
fn check(name: &str, polygon: &[Place], plane: &Plane, draw: &mut Draw) {
    let probes: Vec<(Place, bool)> =
        probes(draw, polygon, PROBES).into_iter().map(|p| (p, is_inside(polygon, p))).collect();
    let mut turned = polygon.to_vec();
    let mut areas = Vec::new();
    for round in 0..2 * polygon.len() {
        turned.rotate_left(1);
        if round == polygon.len() {
            turned.reverse();
        }
        let (triangles, _) = read(&obj(&turned, plane, round % 2 == 0), plane);
        for &(probe, inside) in &probes {
            let covered = covers(&triangles, probe);
            assert_eq!(covered, usize::from(inside), "{name}: {probe:?} of {turned:?}");
        }
        areas.push(area(&triangles));
    }
    let (least, most) =
        areas.iter().fold((f64::MAX, 0.0_f64), |(least, most), &a| (least.min(a), most.max(a)));
    assert!(most - least <= 1e-9 * most, "{name}: areas from {least} to {most} of {polygon:?}");
}

/// As `check`, of a polygon that does not cover itself: its area is known, and nothing is warned
/// of.
fn check_simple(name: &str, polygon: &[Place], plane: &Plane, draw: &mut Draw) {
    check(name, polygon, plane, draw);
    let (triangles, warnings) = read(&obj(polygon, plane, true), plane);
    let (found, expected) = (area(&triangles), area_around(polygon));
    assert!(
        (found - expected).abs() <= 1e-9 * expected,
        "{name}: area {found}, not {expected}, of {polygon:?}"
    );
    assert_eq!(warnings, [], "{name}: {polygon:?}");
}

#[test]
fn stars_are_covered_once() {
    for seed in 0..60 {
        let mut draw = Draw::new(seed);
        let corners = 3 + draw.below(30);
        let polygon = star(&mut draw, corners, [0.0; 2], 8.0);
        check_simple(&format!("star {seed}"), &polygon, &Plane::flat(), &mut draw);
        let (rough, plane) = (roughened(&mut draw, &polygon), Plane::any(&mut draw));
        check(&format!("rough star {seed}"), &rough, &Plane::flat(), &mut draw);
        check(&format!("tilted star {seed}"), &polygon, &plane, &mut draw);
    }
}

#[test]
fn spirals_and_combs_are_covered_once() {
    let mut draw = Draw::new(1);
    for (name, polygon) in [("spiral", spiral(60, 3.0, 10.0)), ("comb", comb(12))] {
        for plane in [Plane::flat(), Plane::any(&mut draw)] {
            check_simple(name, &polygon, &plane, &mut draw);
        }
        check(name, &roughened(&mut draw, &polygon), &Plane::flat(), &mut draw);
    }
}

#[test]
fn holes_at_bridges_stay_open() {
    for seed in 0..40 {
        let mut draw = Draw::new(seed);
        let holes = 1 + draw.below(4);
        let polygon = with_holes(&mut draw, holes);
        check(&format!("holes {seed}"), &polygon, &Plane::flat(), &mut draw);
        let (rough, plane) = (roughened(&mut draw, &polygon), Plane::any(&mut draw));
        check(&format!("rough holes {seed}"), &rough, &Plane::flat(), &mut draw);
        check(&format!("tilted holes {seed}"), &polygon, &plane, &mut draw);
    }
}

/// A hole that goes around the other way than its rim makes a polygon that does not cover itself.
#[test]
fn stars_in_stars_leave_rings() {
    for seed in 0..40 {
        let mut draw = Draw::new(seed);
        let (outer, inner) = (5 + draw.below(12), 3 + draw.below(6));
        let rim = star(&mut draw, outer, [0.0; 2], 30.0);
        let mut hole = star(&mut draw, inner, [0.0; 2], 3.0);
        hole.reverse();
        let polygon = bridged(&mut draw, &rim, &hole);
        check_simple(&format!("ring {seed}"), &polygon, &Plane::flat(), &mut draw);
        let plane = Plane::any(&mut draw);
        check_simple(&format!("tilted ring {seed}"), &polygon, &plane, &mut draw);
    }
}

/// Polygons that cross themselves are filled by the even-odd rule too, and told of.
#[test]
fn polygons_that_cross_themselves_are_filled_by_the_even_odd_rule() {
    for seed in 0..300 {
        let mut draw = Draw::new(seed);
        let corners = 4 + draw.below(9);
        let polygon = tangled(&mut draw, corners);
        check(&format!("tangled {seed}"), &polygon, &Plane::flat(), &mut draw);
    }
    let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    let (triangles, warnings) = read(&obj(&bow_tie, &Plane::flat(), true), &Plane::flat());
    assert_eq!(area(&triangles), 2.0);
    let told: Vec<String> = warnings.iter().map(Warning::to_string).collect();
    let right = "a.obj, line 5: a polygon of 4 corners crosses or covers itself; what an odd number of its edges surrounds is drawn";
    assert_eq!(told, [right]);
}

/// The file of the fault that brought this about: a square with a square hole at the end of a
/// bridge.
#[test]
fn a_square_with_a_bridge_to_a_hole_keeps_three_quarters() {
    let text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -.5 -.5 0\nv -.5 .5 0\nv .5 .5 0\nv .5 -.5 0\nf 1 2 3 4 1 5 6 7 8 5\n";
    let (triangles, warnings) = read(text, &Plane::flat());
    assert_eq!((area(&triangles), warnings), (3.0, vec![]));
}

/// The picture of that file's kind: a side of 4 is 108 pixels of the 120 that the camera's frame
/// has, and a hole of half of it leaves three quarters, or one pixel's row more or less.
#[test]
fn a_picture_shows_the_hole() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let rim = ["0 0", "4 0", "4 4", "0 4"];
    let hole = ["1 1", "1 3", "3 3", "3 1"];
    for first in 0..10 {
        for backwards in [false, true] {
            let mut corners = [&rim[..], &rim[..1], &hole, &hole[..1]].concat();
            corners.rotate_left(first);
            if backwards {
                corners.reverse();
            }
            let vertices: String = corners.iter().map(|c| format!("v {c} 0\n")).collect();
            let mesh = format!("{vertices}f 1 2 3 4 5 6 7 8 9 10\n");
            std::fs::write(folder.path().join("hole.obj"), mesh).expect("it can be written");
            let path = folder.path().join("hole.toml");
            let scene = "size = [120, 120]\n[camera]\ndirection = [0, 0, 1]\n[[object]]\nmesh = \"hole.obj\"\n";
            std::fs::write(&path, scene).expect("it can be written");
            let loaded = specula_scene::load(path.to_str().expect("it is a plain name"), None)
                .unwrap_or_else(|error| panic!("{error}"));
            let pixels = loaded.frame.shaded_pixels();
            // 108² without the hole of 54² pixels: 8748, and a row of 108 at most is rounding.
            assert!(pixels.abs_diff(8748) <= 108, "{first}: {pixels}");
        }
    }
}

/// Corners on straight edges, and corners in the middle of a slit, are corners of triangles: their
/// normals count, and neighbours share them.
#[test]
fn every_corner_of_a_polygon_is_one_of_its_triangles() {
    for seed in 0..40 {
        let mut draw = Draw::new(seed);
        let corners = 4 + draw.below(12);
        let star = star(&mut draw, corners, [0.0; 2], 8.0);
        let middles = edges(&star).flat_map(|[a, b]| {
            [
                a,
                [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0],
                [(a[0] + 3.0 * b[0]) / 4.0, (a[1] + 3.0 * b[1]) / 4.0],
            ]
        });
        let polygon: Vec<Place> = middles.collect();
        let (triangles, warnings) = read(&obj(&polygon, &Plane::flat(), false), &Plane::flat());
        assert_eq!((triangles.len(), warnings), (polygon.len() - 2, vec![]), "{polygon:?}");
        for corner in polygon {
            assert!(triangles.iter().flatten().any(|&place| place == corner), "{corner:?}");
        }
    }
}

/// A hundred kilobytes of polygons that each cross themselves hundreds of thousands of times would
/// make tens of millions of triangles.
#[test]
fn files_of_tangles_are_refused_in_little_time() {
    let begun = Instant::now();
    let mut draw = Draw::new(7);
    let corners = 900;
    let vertices: String =
        (0..corners).map(|_| format!("v {:.6} {:.6} 0\n", draw.unit(), draw.unit())).collect();
    let face: String = (1..=corners).map(|k| format!(" {k}")).collect();
    let file = format!("{vertices}{}", format!("f{face}\n").repeat(40));
    let error = Mesh::from_bytes(Path::new("a.obj"), file.as_bytes()).expect_err("it is tangled");
    let said = error.to_string();
    assert!(
        said.contains("a polygon of 900 corners, crosses or covers itself too often"),
        "{said}"
    );
    // Each crosses itself 90 000 times: the third is one too many.
    assert!(said.starts_with("mesh `a.obj`, line 903: face 2 "), "{said}");
    assert!(begun.elapsed() < Duration::from_secs(20), "{:?}", begun.elapsed());
}

/// A file of one long polygon, and one of many, take a time that grows little faster than their
/// corners.
#[test]
fn long_polygons_take_little_time() {
    let begun = Instant::now();
    for (corners, turns) in [(1000, 20.0), (200_000, 60.0)] {
        let polygon = spiral(corners, turns, 1000.0);
        let (triangles, _) = read(&obj(&polygon, &Plane::flat(), false), &Plane::flat());
        assert_eq!(triangles.len(), polygon.len() - 2);
    }
    assert!(begun.elapsed() < Duration::from_secs(20), "{:?}", begun.elapsed());
}
