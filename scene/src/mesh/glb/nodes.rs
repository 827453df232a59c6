//! The node trees, which place meshes, lights and cameras [glTF 2.0, 3.5].
use glam::{DMat4, DQuat, DVec3};

use super::json::{Document, Instancing, Node, Number, Whole};
use super::lights::OfNode;
use crate::mesh::error::MeshProblem;
use crate::sequence::Pose;

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
    /// The place in the tree of the node in whose coordinates it is; `None` for the scene's own.
    pub moving: Option<usize>,
}

/// A light or a camera at a place.
#[derive(Clone, Copy, Debug)]
pub struct Attached {
    /// Its number.
    pub number: usize,
    /// The transformation from its node's coordinates to the scene's.
    pub place: DMat4,
    /// Its node's place in the tree.
    pub node: usize,
}

/// A node that was visited.
#[derive(Clone, Copy, Debug)]
pub struct Visited {
    /// Its number.
    pub number: usize,
    /// Its parent's place in the tree.
    pub parent: Option<usize>,
    /// The place in the tree of the nearest node from it upwards that moves.
    pub moving: Option<usize>,
}

/// What nodes place.
#[derive(Default)]
pub struct AllPlaced<'a> {
    /// Meshes.
    pub meshes: Vec<Placed<'a>>,
    /// Lights.
    pub lights: Vec<Attached>,
    /// Cameras.
    pub cameras: Vec<Attached>,
    /// The tree: all nodes, parents before their children.
    pub tree: Vec<Visited>,
}

/// All that nodes place in the default scene; without one, in all scenes; if no scene has a root, in
/// all node trees; and if there are none, all meshes without transformation.
///
/// Meshes at nodes that move, by their numbers, and below are in such a node's coordinates.
///
/// Scenes, nodes and meshes that do not exist, and nodes that do not form trees.
pub fn placed<'a>(
    document: &'a Document,
    moves: &dyn Fn(usize) -> bool,
) -> Result<AllPlaced<'a>, MeshProblem> {
    let names_none = document.scenes.iter().all(|scene| scene.nodes.is_empty());
    if document.scene.is_none() && names_none && document.nodes.is_empty() {
        let meshes = 0..document.meshes.len();
        let as_it_is = |mesh| Placed {
            mesh,
            place: DMat4::IDENTITY,
            instancing: None,
            has_skin: false,
            moving: None,
        };
        return Ok(AllPlaced { meshes: meshes.map(as_it_is).collect(), ..AllPlaced::default() });
    }
    let mut forest =
        Forest { document, met: vec![false; document.nodes.len()], placed: AllPlaced::default() };
    for root in roots(document)? {
        forest.tree(root, moves)?;
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
    placed: AllPlaced<'a>,
}

impl Forest<'_> {
    /// Places what is in a tree.
    fn tree(&mut self, root: usize, moves: &dyn Fn(usize) -> bool) -> Result<(), MeshProblem> {
        let mut waiting = vec![(root, Above::NOTHING)];
        while let Some((number, above)) = waiting.pop() {
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
            let index = self.placed.tree.len();
            let here = above.below(node, moves(number), index);
            let Above { place, in_moving, moving, .. } = here;
            self.placed.tree.push(Visited { number, parent: above.node, moving });
            if let Some(Whole(mesh)) = node.mesh {
                let instancing = extensions.and_then(|all| all.instancing.as_ref());
                let has_skin = node.skin.is_some();
                let mesh = Placed { mesh, place: in_moving, instancing, has_skin, moving };
                self.placed.meshes.push(mesh);
            }
            let attached = |number| Attached { number, place, node: index };
            let light = extensions.and_then(|all| all.light.read::<OfNode>().ok()??.light.0);
            self.placed.lights.extend(light.map(attached));
            self.placed.cameras.extend(node.camera.0.map(attached));
            waiting.extend(node.children.iter().rev().map(|child| (child.0, here)));
        }
        Ok(())
    }
}

/// What is above a node.
#[derive(Clone, Copy)]
struct Above {
    /// The parent's place in the tree.
    node: Option<usize>,
    /// The transformation from the parent's coordinates to the scene's.
    place: DMat4,
    /// The nearest node upwards that moves, by its place in the tree.
    moving: Option<usize>,
    /// The transformation from the parent's coordinates to that node's, or to the scene's.
    in_moving: DMat4,
}

impl Above {
    const NOTHING: Above =
        Above { node: None, place: DMat4::IDENTITY, moving: None, in_moving: DMat4::IDENTITY };

    /// What is above the children of a node, which has this place in the tree.
    fn below(self, node: &Node, moves: bool, index: usize) -> Above {
        let own = transform(node);
        let place = self.place * own;
        let (moving, in_moving) = match moves.then_some(index) {
            Some(index) => (Some(index), DMat4::IDENTITY),
            None => (self.moving, self.in_moving * own),
        };
        Above { node: Some(index), place, moving, in_moving }
    }
}

/// The transformation from a node's coordinates to its parent's.
pub fn transform(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(&matrix.map(|Number(x)| x));
    }
    let Pose { translation, rotation, scale } = pose(node);
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}

/// The parts of a node's transformation, which has no matrix.
pub fn pose(node: &Node) -> Pose {
    let vector = |given: Option<[Number; 3]>, otherwise| {
        given.map_or(otherwise, |v| DVec3::from_array(v.map(|Number(x)| x)))
    };
    Pose {
        translation: vector(node.translation, DVec3::ZERO),
        rotation: node.rotation.map_or(DQuat::IDENTITY, |q| rotation(q.map(|Number(x)| x))),
        scale: vector(node.scale, DVec3::ONE),
    }
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
