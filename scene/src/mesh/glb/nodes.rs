//! The node trees, which place meshes [glTF 2.0, 3.5].
use glam::{DMat4, DQuat, DVec3};

use super::json::{Document, Instancing, Node, Number, Whole};
use crate::mesh::error::MeshProblem;

/// A mesh at a place.
pub struct Placed<'a> {
    /// The mesh's number.
    pub mesh: usize,
    /// The transformation from its coordinates to the scene's.
    pub place: DMat4,
    /// Its instances, if it is drawn many times.
    pub instancing: Option<&'a Instancing>,
    /// Whether it has a skin that would move its vertices.
    pub has_skin: bool,
}

/// The meshes of the default scene; without one, of all scenes; if no scene has a root, of all node
/// trees; and if there are none, all meshes without transformation.
///
/// Scenes, nodes and meshes that do not exist, and nodes that do not form trees.
pub fn placed(document: &Document) -> Result<Vec<Placed<'_>>, MeshProblem> {
    let names_none = document.scenes.iter().all(|scene| scene.nodes.is_empty());
    if document.scene.is_none() && names_none && document.nodes.is_empty() {
        let meshes = 0..document.meshes.len();
        let as_it_is =
            |mesh| Placed { mesh, place: DMat4::IDENTITY, instancing: None, has_skin: false };
        return Ok(meshes.map(as_it_is).collect());
    }
    let mut forest =
        Forest { document, met: vec![false; document.nodes.len()], placed: Vec::new() };
    for root in roots(document)? {
        forest.tree(root)?;
    }
    Ok(forest.placed)
}

/// The roots that are drawn, each once, although scenes may share them.
fn roots(document: &Document) -> Result<Vec<usize>, MeshProblem> {
    let scenes = match document.scene {
        Some(Whole(scene)) => {
            let missing = || {
                syntax(format!(
                    "scene {scene} is to be shown, but there are only {}",
                    document.scenes.len()
                ))
            };
            std::slice::from_ref(document.scenes.get(scene).ok_or_else(missing)?)
        }
        None if document.scenes.is_empty() => return orphans(document),
        None => &document.scenes,
    };
    let mut known = vec![false; document.nodes.len()];
    let mut roots = Vec::new();
    for &Whole(root) in scenes.iter().flat_map(|scene| &scene.nodes) {
        let known = known.get_mut(root).ok_or_else(|| no_such_node(document, root))?;
        if !std::mem::replace(known, true) {
            roots.push(root);
        }
    }
    if roots.is_empty() && document.scene.is_none() {
        return orphans(document);
    }
    Ok(roots)
}

/// The nodes without a parent.
fn orphans(document: &Document) -> Result<Vec<usize>, MeshProblem> {
    let mut is_below = vec![false; document.nodes.len()];
    for &Whole(child) in document.nodes.iter().flat_map(|node| &node.children) {
        *is_below.get_mut(child).ok_or_else(|| no_such_node(document, child))? = true;
    }
    let orphans: Vec<usize> = (0..is_below.len()).filter(|node| !is_below[*node]).collect();
    if orphans.is_empty() {
        Err(syntax("every node is below another: they go round in circles".into()))
    } else {
        Ok(orphans)
    }
}

struct Forest<'a> {
    document: &'a Document,
    /// For each node whether it has been visited.
    met: Vec<bool>,
    placed: Vec<Placed<'a>>,
}

impl Forest<'_> {
    /// Places the meshes of a tree.
    fn tree(&mut self, root: usize) -> Result<(), MeshProblem> {
        let mut waiting = vec![(root, DMat4::IDENTITY)];
        while let Some((number, parent)) = waiting.pop() {
            let node = self
                .document
                .nodes
                .get(number)
                .ok_or_else(|| no_such_node(self.document, number))?;
            // The format requires trees; a node visited twice could be its own ancestor.
            if std::mem::replace(&mut self.met[number], true) {
                return Err(syntax(format!("node {number} is in the scene twice")));
            }
            let extensions = node.extensions.as_deref();
            if extensions.and_then(|all| all.visibility.as_ref()?.visible) == Some(false) {
                continue;
            }
            let place = parent * transform(node);
            if let Some(Whole(mesh)) = node.mesh {
                let instancing = extensions.and_then(|all| all.instancing.as_ref());
                self.placed.push(Placed { mesh, place, instancing, has_skin: node.skin.is_some() });
            }
            waiting.extend(node.children.iter().rev().map(|child| (child.0, place)));
        }
        Ok(())
    }
}

/// The transformation from a node's coordinates to its parent's.
fn transform(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(&matrix.map(|Number(x)| x));
    }
    let vector = |given: Option<[Number; 3]>, otherwise| {
        given.map_or(otherwise, |v| DVec3::from_array(v.map(|Number(x)| x)))
    };
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |q| rotation(q.map(|Number(x)| x)));
    DMat4::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        rotation,
        vector(node.translation, DVec3::ZERO),
    )
}

/// The rotation by a quaternion x, y, z, w, which is normalised; the identity for 0.
pub fn rotation(quaternion: [f64; 4]) -> DQuat {
    let length = DQuat::from_array(quaternion).length();
    if length > 0.0 && length.is_finite() {
        DQuat::from_array(quaternion.map(|x| x / length))
    } else {
        DQuat::IDENTITY
    }
}

fn no_such_node(document: &Document, node: usize) -> MeshProblem {
    syntax(format!("node {node} is named, but there are only {}", document.nodes.len()))
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}
