//! The same work on many items, on all cores.

use std::sync::atomic::{AtomicUsize, Ordering};

/// Items a core takes at a time: neighbours share its caches.
const BLOCK: usize = 16;

/// `work` done on every item, in the order of the items. `progress` hears how many have been done since it heard last,
/// from any thread.
///
/// # Panics
/// Where `work` does.
pub fn map<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(&T) -> R + Sync,
    progress: impl Fn(usize) + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let blocks = items.len().div_ceil(BLOCK);
    let run = || {
        let mut done = Vec::new();
        loop {
            let block = next.fetch_add(1, Ordering::Relaxed);
            if block >= blocks {
                return done;
            }
            let here = &items[block * BLOCK..items.len().min((block + 1) * BLOCK)];
            done.push((block, here.iter().map(&work).collect::<Vec<R>>()));
            progress(here.len());
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(blocks.max(1));
    let mut done: Vec<(usize, Vec<R>)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..workers).map(|_| scope.spawn(run)).collect();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    done.sort_by_key(|(block, _)| *block);
    done.into_iter().flat_map(|(_, results)| results).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        for count in [0, 1, BLOCK, 10 * BLOCK + 3] {
            let items: Vec<usize> = (0..count).collect();
            let told = AtomicUsize::new(0);
            let doubled = map(
                &items,
                |i| 2 * i,
                |n| {
                    told.fetch_add(n, Ordering::Relaxed);
                },
            );
            assert!(doubled.iter().enumerate().all(|(i, d)| *d == 2 * i));
            assert_eq!((doubled.len(), told.into_inner()), (count, count));
        }
    }
}
