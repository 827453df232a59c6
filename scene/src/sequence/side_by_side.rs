//! Work on frames side by side, on few of them at once.
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ScopedJoinHandle};

/// What `of` gives for every item, in their order, where `workers` threads take the next item
/// whenever they are done with one. So no more than `workers` items are under way, which rayon does
/// not promise: a thread of its own that waits for one item's loops takes another item meanwhile.
///
/// Within one of rayon's threads, items are done one after the other: the others' loops need rayon's
/// threads, all of which could be waiting here for them.
pub(super) fn side_by_side<I: Copy + Sync, T: Send>(
    items: &[I],
    workers: usize,
    of: impl Fn(I) -> T + Sync,
) -> Vec<T> {
    if rayon::current_thread_index().is_some() {
        return items.iter().map(|&item| of(item)).collect();
    }
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
    use std::sync::mpsc;
    use std::time::Duration;

    use rayon::prelude::*;

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

    /// Loops in loops come to an end when every thread of rayon's is in the outer one.
    #[test]
    fn items_of_items_do_not_wait_for_each_other() {
        let (done, end) = mpsc::channel();
        thread::spawn(move || {
            let inner = |item: u64| (0..1000).into_par_iter().map(|x| x * item).sum::<u64>();
            let outer = |item: u64| side_by_side(&[item, 1], 2, inner)[0];
            let sums: u64 = (0..64).into_par_iter().map(outer).sum();
            done.send(sums)
        });
        let sum = end.recv_timeout(Duration::from_secs(60));
        assert_eq!(sum, Ok((64 * 63 / 2) * (1000 * 999 / 2)));
    }
}
