//! The parts of a scene that an animation moves.
use std::collections::BTreeMap;

use glam::{DAffine3, DMat3};

use super::animation::Animation;
use super::json::Document;
use super::nodes::{self, AllPlaced, Placed, Visited};
use super::primitives::Accessors;
use crate::mesh::error::{Located, MeshProblem};
use crate::mesh::indexed::Mesh;
use crate::mesh::model::Movement;
use crate::mesh::warning::Notices;
use crate::sequence::{NodeMotions, Transform, TreeNode};

/// A scene that does not move yet.
pub struct Still<'a> {
    pub document: &'a Document,
    /// The nodes of its lights, by their places in the tree.
    pub lights: Vec<usize>,
    /// The node of its camera, if it has one.
    pub camera: Option<usize>,
}

impl Still<'_> {
    /// How an animation moves it; `None` if it moves nothing that is shown, which is noted.
    ///
    /// Each part of the mesh that moves as a whole becomes a mesh of its own, in the coordinates of
    /// the node that moves it.
    ///
    /// # Errors
    /// Coordinates that are out of range in such a node's coordinates.
    pub fn moved(
        self,
        animation: Animation,
        accessors: &mut Accessors<'_>,
        notices: &mut Notices,
    ) -> Result<Option<Movement>, Located> {
        let moves = |node: usize| animation.nodes[node].is_some();
        let AllPlaced { meshes, tree, .. } = nodes::placed(self.document, &moves)?;
        let at_nodes = self.lights.iter().chain(&self.camera);
        let moved = at_nodes.map(|&node| tree[node].moving).chain(meshes.iter().map(|m| m.moving));
        if !moved.into_iter().any(|moving| moving.is_some()) {
            notices.add("nothing moves", None, || {
                "its animation moves nothing that is shown; it is left out".into()
            });
            return Ok(None);
        }
        let (objects, meshes) = self.parts(meshes, accessors)?.into_iter().unzip();
        let nodes = self.tree_nodes(&tree, animation.nodes);
        let motions = NodeMotions { nodes, objects, lights: self.lights, camera: self.camera };
        Ok(Some(Movement { meshes, frames: animation.frames, motions }))
    }

    /// The parts that move each as a whole, with the places of their nodes in the tree; first what
    /// stands still.
    fn parts(
        &self,
        placed: Vec<Placed<'_>>,
        accessors: &mut Accessors<'_>,
    ) -> Result<Vec<(Option<usize>, Mesh)>, Located> {
        let mut parts: BTreeMap<Option<usize>, Vec<Placed<'_>>> = BTreeMap::new();
        for one in placed {
            parts.entry(one.moving).or_default().push(one);
        }
        let mut meshes = Vec::with_capacity(parts.len());
        for (node, placed) in parts {
            // All notes have been made when the whole was drawn.
            let mesh = super::mesh(self.document, accessors, &placed, &mut Notices::default());
            match mesh {
                Ok(mesh) => meshes.push((node, mesh)),
                Err(Located { problem: MeshProblem::Empty, .. }) => {}
                Err(wrong) => return Err(wrong),
            }
        }
        Ok(meshes)
    }

    fn tree_nodes(
        &self,
        tree: &[Visited],
        mut tracks: Vec<Option<crate::sequence::Tracks>>,
    ) -> Vec<TreeNode> {
        let node = |visited: &Visited| {
            let own = &self.document.nodes[visited.number];
            let transform = match tracks[visited.number].take() {
                Some(tracks) => Transform::Moving { rest: nodes::pose(own), tracks },
                None => {
                    let whole = nodes::transform(own);
                    let (linear, shift) = (DMat3::from_mat4(whole), whole.w_axis.truncate());
                    Transform::Fixed(DAffine3::from_mat3_translation(linear, shift))
                }
            };
            TreeNode { parent: visited.parent, transform }
        };
        tree.iter().map(node).collect()
    }
}
