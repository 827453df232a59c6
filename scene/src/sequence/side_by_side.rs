//! Work on frames side by side, on few of them at once.
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ScopedJoinHandle};

/// What `of` gives for every item, in their order, where `workers` threads take the next item
/// whenever they are done with one. So no more than `workers` items are under way, which rayon does
/// not promise: a thread of its own that waits for one item's loops takes another item meanwhile.
pub(super) fn side_by_side<I: Copy + Sync, T: Send>(
    items: &[I],
    workers: usize,
    of: impl Fn(I) -> T + Sync,
) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(&item) = items.get(index) else { return done };
            done.push((index, of(item)));
        }
    };
    let mut all: Vec<(usize, T)> = thread::scope(|scope| {
        let started: Vec<_> = (0..workers.min(items.len())).map(|_| scope.spawn(work)).collect();
        let joined = started.into_iter().map(ScopedJoinHandle::join);
        // A panic goes on in the thread that waits.
        joined.flat_map(|done| done.unwrap_or_else(|panic| resume_unwind(panic))).collect()
    });
    all.sort_unstable_by_key(|&(index, _)| index);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order_and_few_are_under_way() {
        let (items, under_way): (Vec<u32>, _) = ((0..100).collect(), AtomicUsize::new(0));
        let squares = side_by_side(&items, 3, |item| {
            assert!(under_way.fetch_add(1, Ordering::SeqCst) < 3);
            thread::yield_now();
            under_way.fetch_sub(1, Ordering::SeqCst);
            item * item
        });
        assert!(squares.iter().zip(&items).all(|(square, item)| *square == item * item));
        assert!(squares.len() == 100 && side_by_side(&items[..0], 3, |item| item).is_empty());
    }
}
