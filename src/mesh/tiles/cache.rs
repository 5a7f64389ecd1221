//! What is dear to make and may be wanted again, as long as there is room.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::Result;

/// Things by number; those longest not asked for go first.
pub struct Cache<T> {
    most: usize,
    inner: Mutex<Inner<T>>,
}

struct Inner<T> {
    /// The thing, its bytes and when it was asked for.
    things: BTreeMap<usize, (Arc<T>, usize, u64)>,
    bytes: usize,
    now: u64,
}

impl<T> Cache<T> {
    /// `most`: bytes.
    pub fn new(most: usize) -> Self {
        Cache { most, inner: Mutex::new(Inner { things: BTreeMap::new(), bytes: 0, now: 0 }) }
    }

    /// The thing of a number, made where it is not there; `make` says its bytes, too.
    ///
    /// # Errors
    /// Those of `make`.
    pub fn get(&self, number: usize, make: impl FnOnce() -> Result<(T, usize)>) -> Result<Arc<T>> {
        let inner = || self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        {
            let mut inner = inner();
            inner.now += 1;
            let now = inner.now;
            if let Some((thing, _, asked)) = inner.things.get_mut(&number) {
                *asked = now;
                return Ok(thing.clone());
            }
        }
        let (thing, bytes) = make()?;
        let thing = Arc::new(thing);
        let mut inner = inner();
        let now = inner.now;
        if let Some((_, old, _)) = inner.things.insert(number, (thing.clone(), bytes, now)) {
            inner.bytes -= old;
        }
        inner.bytes += bytes;
        while inner.bytes > self.most && inner.things.len() > 1 {
            let Some(oldest) = inner.things.iter().filter(|t| *t.0 != number).min_by_key(|t| t.1.2).map(|t| *t.0)
            else {
                break;
            };
            if let Some((_, bytes, _)) = inner.things.remove(&oldest) {
                inner.bytes -= bytes;
            }
        }
        Ok(thing)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_longest_not_asked_for_goes_first() {
        let cache = Cache::new(25);
        let made = std::cell::Cell::new(0);
        let get = |n: usize| {
            let make = || {
                made.set(made.get() + 1);
                Ok((10 * n, 10))
            };
            assert_eq!(*cache.get(n, make).unwrap(), 10 * n);
            made.get()
        };
        assert_eq!([get(1), get(2), get(1), get(3), get(1), get(2)], [1, 2, 2, 3, 3, 4]);
    }
}
