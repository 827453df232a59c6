//! The Pareto front.

/// The indices of the points on the front, from left to right. Less is better on both axes: a point
/// is on the front if no other one is at most as large on both axes.
pub fn pareto_front(places: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..places.len()).filter(|&k| places[k].0.is_finite() && places[k].1.is_finite()).collect();
    order.sort_by(|&a, &b| {
        places[a]
            .0
            .total_cmp(&places[b].0)
            .then(places[a].1.total_cmp(&places[b].1))
            .then(a.cmp(&b))
    });
    let mut front: Vec<usize> = vec![];
    for k in order {
        if front.last().is_none_or(|&last| places[k].1 < places[last].1) {
            front.push(k);
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::pareto_front;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let places = [
            (3.0, 1.0),
            (1.0, 4.0),
            (2.0, 4.0),
            (2.0, 2.0),
            (4.0, 1.0),
            (f64::NAN, 0.0),
            (5.0, 0.5),
        ];
        assert_eq!(pareto_front(&places), [1, 3, 0, 6]);
        assert_eq!(pareto_front(&[]), Vec::<usize>::new());
    }
}
