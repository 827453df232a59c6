//! Joining vertices at the same place.
use std::collections::HashMap;

use glam::DVec3;

/// Gives vertices at exactly the same place one index: the distinct positions, in the order of
/// their first use, and for each old index the new one. -0 and 0 are the same place.
pub fn weld(positions: &[DVec3]) -> (Vec<DVec3>, Vec<u32>) {
    let mut known = HashMap::with_capacity(positions.len());
    let mut distinct = Vec::new();
    let indices = positions
        .iter()
        .map(|&position| {
            // Adding 0 turns -0 into 0 and changes nothing else.
            let place = (position + DVec3::ZERO).to_array().map(f64::to_bits);
            *known.entry(place).or_insert_with(|| {
                distinct.push(position);
                (distinct.len() - 1) as u32
            })
        })
        .collect();
    (distinct, indices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn same_places_share_an_index() {
        let (distinct, indices) = weld(&[DVec3::X, DVec3::ZERO, DVec3::X, -DVec3::ZERO]);
        assert_eq!((distinct, indices), (vec![DVec3::X, DVec3::ZERO], vec![0, 1, 0, 1]));
    }
}
