//! Two clocks against each other: the one that can be set, and the one that runs since the machine's start and cannot. Within
//! one start both move alike, unless somebody or something sets the first.

use std::collections::HashMap;

use super::event_identity;
use crate::audit::report::Finding;
use crate::audit::statement::Time;
use crate::audit::time::{self, Source};

/// A time service may step a clock by so much without a word, milliseconds; a leap second is one.
pub const STEP_MS: u64 = 60_000;
/// And for each so many milliseconds that lie between: what the oscillator of a machine that is now and then set right is off
/// by at most, 100 ppm.
const DRIFT: u64 = 10_000;

/// The clocks of each start of a machine that a ledger has records of.
#[derive(Debug, Default)]
pub(super) struct Boots(HashMap<u128, Boot>);

#[derive(Debug)]
struct Boot {
    /// Both clocks at the first record of this start, or at the first after the last step.
    wall_ms: i64,
    monotonic_ms: u64,
    /// The latest of the second clock.
    latest_ms: u64,
}

impl Boots {
    /// What a record's two clocks say against those of the records before it. Runs that were at work at once may stand in
    /// another order than they were dated, by `grace_ms` at most.
    pub fn step(&mut self, time: &Time, grace_ms: u64) -> Vec<Finding> {
        let (Some(boot_id), Some(monotonic_ms)) = (&time.boot_id, time.monotonic_ms) else { return Vec::new() };
        let Some(wall_ms) = wall_clock_ms(time) else { return Vec::new() };
        let now = Boot { wall_ms, monotonic_ms, latest_ms: monotonic_ms };
        let boot = match self.0.entry(event_identity(boot_id)) {
            std::collections::hash_map::Entry::Vacant(new) => {
                new.insert(now);
                return Vec::new();
            }
            std::collections::hash_map::Entry::Occupied(known) => known.into_mut(),
        };
        let mut found = Vec::new();
        if monotonic_ms.saturating_add(grace_ms) < boot.latest_ms {
            found.push(
                Finding::new("TIME_ROLLBACK", "time.monotonic_ms")
                    .expected(format!("not before {} ms since the start", boot.latest_ms))
                    .actual(format!("{monotonic_ms} ms")),
            );
        }
        boot.latest_ms = boot.latest_ms.max(monotonic_ms);
        let expected_ms = boot.wall_ms + (monotonic_ms as i64 - boot.monotonic_ms as i64);
        let moved_ms = wall_ms - expected_ms;
        if moved_ms.unsigned_abs() > STEP_MS + monotonic_ms.abs_diff(boot.monotonic_ms) / DRIFT {
            let code = if moved_ms < 0 { "TIME_ROLLBACK" } else { "TIME_STEPPED" };
            found.push(
                Finding::new(code, "time.utc")
                    .expected(format!(
                        "{} by the clock that runs since the start",
                        time::format_utc(u64::try_from(expected_ms).unwrap_or_default())
                    ))
                    .actual(format!("{}, {} s off", time::format_utc(wall_ms.unsigned_abs()), moved_ms / 1000)),
            );
            (boot.wall_ms, boot.monotonic_ms) = (wall_ms, monotonic_ms);
        }
        found
    }
}

/// What the machine's own clock said: a server's answer moves the record's time, not the clock. Integers of a record are at most
/// 2^53, so sums of a few fit.
fn wall_clock_ms(time: &Time) -> Option<i64> {
    let utc = i64::try_from(time::parse_utc(&time.utc)?).ok()?;
    Some(match (time.source, time.offset_us) {
        (Source::NtpQuery, Some(offset)) => utc - offset.div_euclid(1000),
        _ => utc,
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::TIME_GRACE_MS;
    use super::*;
    use crate::audit::time::SyncStatus;

    const UTC_MS: u64 = 1_763_688_582_120;

    fn at(boot: char, utc_ms: u64, monotonic_ms: u64) -> Time {
        Time {
            utc: time::format_utc(utc_ms),
            source: Source::Kernel,
            sync_status: SyncStatus::Unsynchronised,
            offset_us: Some(0),
            max_error_us: None,
            stratum: None,
            reference: None,
            boot_id: Some("01234567-89ab-cdef-0123-456789abcdef".replace('0', &boot.to_string())),
            monotonic_ms: Some(monotonic_ms),
        }
    }

    fn codes(times: &[Time]) -> Vec<(usize, &'static str)> {
        let mut boots = Boots::default();
        let step = |(i, t)| boots.step(t, TIME_GRACE_MS).into_iter().map(move |f| (i, f.code)).collect::<Vec<_>>();
        times.iter().enumerate().flat_map(step).collect()
    }

    /// An hour later by one clock, and by the other so many milliseconds more or less.
    fn after_an_hour(moved_ms: i64) -> Vec<(usize, &'static str)> {
        let later = (UTC_MS + 3_600_000).checked_add_signed(moved_ms).unwrap();
        codes(&[at('a', UTC_MS, 5000), at('a', later, 3_605_000)])
    }

    #[test]
    fn how_far_the_clock_may_be_set() {
        // A minute, and 100 ppm of an hour.
        for moved in [0, 60_360, -60_360] {
            assert_eq!(after_an_hour(moved), [], "{moved}");
        }
        assert_eq!(after_an_hour(60_361), [(1, "TIME_STEPPED")]);
        assert_eq!(after_an_hour(-60_361), [(1, "TIME_ROLLBACK")]);
        // Two hours back and three on: no record is dated before the one before it.
        assert_eq!(codes(&[at('a', UTC_MS, 0), at('a', UTC_MS + 3_600_000, 3 * 3_600_000)]), [(1, "TIME_ROLLBACK")]);
    }

    #[test]
    fn how_far_records_may_stand_out_of_order() {
        let back = |ms: u64| codes(&[at('a', UTC_MS, 1_000_000), at('a', UTC_MS - ms, 1_000_000 - ms)]);
        assert_eq!(back(TIME_GRACE_MS), []);
        assert_eq!(back(TIME_GRACE_MS + 1), [(1, "TIME_ROLLBACK")]);
    }

    #[test]
    fn each_step_is_told_once() {
        let times = [(0, 0), (200_000, 100_000), (300_000, 200_000), (200_000, 300_000), (300_000, 400_000)];
        let times = times.map(|(utc, monotonic)| at('a', UTC_MS + utc, monotonic));
        assert_eq!(codes(&times), [(1, "TIME_STEPPED"), (3, "TIME_ROLLBACK")]);
    }

    #[test]
    fn small_steps_add_up() {
        let times: Vec<Time> = (0..5).map(|i| at('a', UTC_MS + i * 100_000 - i * 20_000, i * 100_000)).collect();
        assert_eq!(codes(&times), [(4, "TIME_ROLLBACK")]);
    }

    #[test]
    fn other_starts_have_other_clocks() {
        let between = [at('a', UTC_MS, 9_000_000), at('b', UTC_MS + 1000, 4000), at('a', UTC_MS + 2000, 9_002_000)];
        assert_eq!(codes(&between), []);
        let without = Time { boot_id: None, monotonic_ms: None, ..at('a', 0, 0) };
        assert_eq!(codes(&[between[0].clone(), without]), []);
    }

    /// A server's answer dates the record, the machine's clock stays as wrong as it was.
    #[test]
    fn a_server_that_knows_better() {
        let asked = Time {
            source: Source::NtpQuery,
            offset_us: Some(-7_200_000_000),
            ..at('a', UTC_MS + 1000 - 7_200_000, 1000)
        };
        assert_eq!(codes(&[at('a', UTC_MS, 0), asked, at('a', UTC_MS + 2000, 2000)]), []);
    }

    proptest! {
        /// No values of a record, however absurd, are too much.
        #[test]
        fn any_values(all in prop::collection::vec((0..253_402_300_800_000_u64, 0..1_u64 << 53, -(1_i64 << 53)..1 << 53), 1..6)) {
            let times: Vec<Time> = all
                .into_iter()
                .map(|(utc, monotonic, offset)| Time {
                    source: Source::NtpQuery,
                    offset_us: Some(offset),
                    ..at('a', utc, monotonic)
                })
                .collect();
            codes(&times);
        }

        /// Clocks that run alike, and records in the order of their time, are never suspected.
        #[test]
        fn honest_clocks(steps in prop::collection::vec((0..10_000_000_u64, -20_000_i64..20_000), 1..50)) {
            let (mut utc, mut monotonic) = (UTC_MS, 0);
            let times: Vec<Time> = steps
                .into_iter()
                .map(|(later, off)| {
                    (utc, monotonic) = (utc + later, monotonic + later);
                    at('a', utc.checked_add_signed(off).unwrap(), monotonic)
                })
                .collect();
            prop_assert_eq!(codes(&times), []);
        }
    }
}
