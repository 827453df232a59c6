//! Figure 1: meshes as mirrors.
use specula_experiments::reproduce::reshetov::tracing::{
    Mirrored, Normals, Surroundings, mirrored,
};
use specula_scene::mesh::Mesh;
use specula_scene::primitive::Primitive;

use crate::cmd_reproduce::pictured_mesh::{PicturedMesh, SIZE};
use crate::cmd_reproduce::section::Section;
use crate::picture::{Panel, side_by_side};

/// Adds the pictures and what became of their rays.
pub fn add(section: &mut Section, mesh: &PicturedMesh) {
    section.heading(3, "Figure 1: environment lighting and traced reflections");
    section.paragraph(
        "The paper's models (Emotiguy, Dinokonda, Toon Dragon) cannot be had; these are others. Perfect mirrors in f64, in a small procedural \
         environment: of the reflected direction alone (figure 1c and d; what is reflected into the surface is green), or with the mesh itself, traced through four reflections (a, b and e; black). In the middle Snyder and Barr's fix: the \
         face's normal where Phong's would reflect into the face. It leaves no ray inside and tears the reflection along the border of what it \
         mends, which shows as facets at silhouettes.",
    );
    let torus = Primitive::Torus { level: 3, tube: 0.4 }.mesh();
    let icosahedron = Primitive::Icosahedron { level: 0 }.mesh();
    let pictures: [(&str, &Mesh, Surroundings); 4] = [
        (&mesh.name, &mesh.mesh, Surroundings::Environment),
        ("icosahedron", &icosahedron, Surroundings::Environment),
        (&mesh.name, &mesh.mesh, Surroundings::Itself),
        ("torus", &torus, Surroundings::Itself),
    ];
    let rows: Vec<[String; 7]> = pictures
        .into_iter()
        .filter_map(|(name, mesh, surroundings)| picture(section, name, mesh, surroundings))
        .collect();
    section.table(
        [
            "mirror",
            "shows",
            "first reflections",
            "Phong: into the face",
            "later ones, into the face",
            "Snyder and Barr: into the face",
            "consistent: into the face",
        ],
        &rows,
    );
}

fn picture(
    section: &mut Section,
    name: &str,
    mesh: &Mesh,
    surroundings: Surroundings,
) -> Option<[String; 7]> {
    let [phong, repaired, consistent] =
        Normals::ALL.map(|normals| mirrored(mesh, SIZE, normals, surroundings));
    let drawn = [phong?, repaired?, consistent?];
    let panels: Vec<Panel> = Normals::ALL
        .iter()
        .zip(&drawn)
        .map(|(normals, drawn)| Panel::new(normals.name(), &drawn.image))
        .collect();
    let [of, file] = match surroundings {
        Surroundings::Environment => ["its environment", "environment"],
        Surroundings::Itself => ["itself", "traced"],
    };
    section.picture(
        &format!("The {name} mirrors {of}"),
        &format!("reshetov_{file}_{name}"),
        side_by_side(&panels),
    );
    let [phong, repaired, consistent] = &drawn;
    Some([
        name.to_owned(),
        of.to_owned(),
        phong.rays.reflected[0].to_string(),
        share(phong, 0),
        share(phong, 1),
        inward(repaired),
        inward(consistent),
    ])
}

fn share(drawn: &Mirrored, kind: usize) -> String {
    match drawn.rays.reflected[kind] {
        0 => "–".to_owned(),
        _ => format!("{} ({:.2} %)", drawn.rays.inward[kind], 100.0 * drawn.rays.share(kind)),
    }
}

fn inward(drawn: &Mirrored) -> String {
    drawn.rays.inward.iter().sum::<u64>().to_string()
}
