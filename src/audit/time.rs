//! The UTC time of a run, and how much it can be trusted. Read once; everything else takes it as a value.

mod ntp;

use std::time::{SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Serialize};

use crate::{Error, Result};
pub use ntp::ask_server;

/// Where a time comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// The kernel's clock, with the kernel's own statement about its quality.
    Kernel,
    NtpQuery,
    Rfc3161,
    Operator,
    /// The system clock; nobody says how good it is.
    None,
}

/// What the source says about its agreement with UTC.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SyncStatus {
    /// The kernel says that a time daemon keeps its clock. It does not say which one, nor that it is right.
    Synchronised,
    Unsynchronised,
    Unknown,
}

/// One reading of the clock.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TimeReading {
    /// Milliseconds since 1970-01-01T00:00:00Z, leap seconds not counted.
    pub unix_ms: u64,
    pub source: Source,
    pub sync_status: SyncStatus,
    /// Offset from the reference, microseconds: by the kernel's estimate, or by the answer of the server that was asked.
    pub offset_us: Option<i64>,
    /// The kernel's bound on its error, or what the way to the server and back can hide, microseconds.
    pub max_error_us: Option<i64>,
    /// How many servers lie between the one that was asked and a reference clock, itself counted (RFC 5905 §7.3).
    pub stratum: Option<u8>,
    /// The server that was asked, and in brackets what it says that it follows itself.
    pub reference: Option<String>,
    /// Read at the same moment; nobody can set it.
    pub since_boot: Option<SinceBoot>,
}

/// The time since this machine started, its sleep counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SinceBoot {
    /// The kernel's random name of this start: 32 hexadecimal digits in the groups of a UUID.
    pub boot_id: String,
    pub milliseconds: u64,
}

impl TimeReading {
    /// `YYYY-MM-DDTHH:MM:SS.mmmZ`.
    pub fn utc(&self) -> String {
        format_utc(self.unix_ms)
    }

    /// One honest line for a person.
    pub fn describe(&self) -> String {
        if let (Source::NtpQuery, Some(offset), Some(error)) = (self.source, self.offset_us, self.max_error_us) {
            let (offset, error) = (offset.div_euclid(1000), error.div_euclid(1000));
            return format!(
                "{} (NTP server {} was asked: the local clock was off by {offset} ms, the way hides at most {error} ms)",
                self.utc(),
                self.reference.as_deref().unwrap_or("of no name")
            );
        }
        let quality = match (self.sync_status, self.max_error_us) {
            (SyncStatus::Synchronised, Some(e)) => {
                format!("the kernel calls its clock synchronised, error at most {} ms", e.div_euclid(1000))
            }
            (SyncStatus::Synchronised, None) => "the kernel calls its clock synchronised".to_owned(),
            (SyncStatus::Unsynchronised, Some(e)) => {
                format!("the kernel calls its clock unsynchronised, error up to {} ms", e.div_euclid(1000))
            }
            (SyncStatus::Unsynchronised, None) => "the kernel calls its clock unsynchronised".to_owned(),
            (SyncStatus::Unknown, _) => "local clock, quality unknown".to_owned(),
        };
        format!("{} ({quality})", self.utc())
    }
}

/// Reads the system clock, and on Linux the kernel's state of it (`adjtimex`, read-only). No network.
///
/// # Errors
/// [`crate::Kind::Environment`] when the clock stands before 1970 or after 9999.
pub fn now() -> Result<TimeReading> {
    let wrong = || {
        Error::environment("system clock")
            .expected("a time between 1970 and 9999")
            .advice("Set the clock of this machine; the record states when it was made.")
    };
    let since_epoch = SystemTime::now().duration_since(UNIX_EPOCH).map_err(|_| wrong())?;
    let unix_ms = u64::try_from(since_epoch.as_millis()).map_err(|_| wrong())?;
    if unix_ms > LAST_MS {
        return Err(wrong());
    }
    let since_boot = since_boot();
    let (source, sync_status, offset_us, max_error_us) = kernel_quality();
    let (stratum, reference) = (None, None);
    Ok(TimeReading { unix_ms, source, sync_status, offset_us, max_error_us, stratum, reference, since_boot })
}

/// As Linux spells the name of its start; anything else is passed over.
pub fn is_boot_id(text: &str) -> bool {
    let groups: Vec<&str> = text.split('-').collect();
    let digits = |g: &&str| g.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
    groups.iter().map(|g| g.len()).eq([8, 4, 4, 4, 12]) && groups.iter().all(digits)
}

#[cfg(target_os = "linux")]
fn since_boot() -> Option<SinceBoot> {
    let mut at = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `at` is ours and lives through the call, which writes to nothing else.
    if unsafe { libc::clock_gettime(libc::CLOCK_BOOTTIME, &mut at) } != 0 {
        return None;
    }
    let boot_id = std::fs::read_to_string("/proc/sys/kernel/random/boot_id").ok()?.trim().to_owned();
    #[allow(clippy::useless_conversion)] // the fields' width differs between targets
    let (seconds, nanoseconds) = (u64::try_from(at.tv_sec).ok()?, u64::try_from(at.tv_nsec).ok()?);
    is_boot_id(&boot_id).then_some(SinceBoot { boot_id, milliseconds: seconds * 1000 + nanoseconds / 1_000_000 })
}

#[cfg(not(target_os = "linux"))]
fn since_boot() -> Option<SinceBoot> {
    None
}

type Quality = (Source, SyncStatus, Option<i64>, Option<i64>);

#[cfg(target_os = "linux")]
fn kernel_quality() -> Quality {
    // SAFETY: `timex` is a plain C struct of integers, for which all zeros is a value; `modes` = 0 makes the call
    // read-only, and it writes to nothing but the struct that we own.
    let (state, timex) = unsafe {
        let mut timex: libc::timex = std::mem::zeroed();
        let state = libc::adjtimex(&mut timex);
        (state, timex)
    };
    if state < 0 {
        return (Source::None, SyncStatus::Unknown, None, None);
    }
    let status = if state == libc::TIME_ERROR || timex.status & libc::STA_UNSYNC != 0 {
        SyncStatus::Unsynchronised
    } else {
        SyncStatus::Synchronised
    };
    #[allow(clippy::useless_conversion)] // the field's width differs between targets
    let (offset, max_error) = (i64::from(timex.offset), i64::from(timex.maxerror));
    let offset_us = if timex.status & libc::STA_NANO != 0 { offset / 1000 } else { offset };
    (Source::Kernel, status, Some(offset_us), Some(max_error))
}

#[cfg(not(target_os = "linux"))]
fn kernel_quality() -> Quality {
    (Source::None, SyncStatus::Unknown, None, None)
}

const DAY_MS: u64 = 86_400_000;
/// 9999-12-31T23:59:59.999Z.
const LAST_MS: u64 = 253_402_300_799_999;

/// `YYYY-MM-DDTHH:MM:SS.mmmZ` of milliseconds since 1970, proleptic Gregorian. Times after 9999 are clamped to its
/// last millisecond.
pub fn format_utc(unix_ms: u64) -> String {
    let unix_ms = unix_ms.min(LAST_MS);
    let (days, ms) = (unix_ms / DAY_MS, unix_ms % DAY_MS);
    let (year, month, day) = civil_from_days(days);
    let (h, m, s) = (ms / 3_600_000, ms / 60_000 % 60, ms / 1000 % 60);
    format!("{year:04}-{month:02}-{day:02}T{h:02}:{m:02}:{s:02}.{:03}Z", ms % 1000)
}

/// The inverse of [`format_utc`]; `None` for anything that it would not have written.
pub fn parse_utc(text: &str) -> Option<u64> {
    let b = text.as_bytes();
    if b.len() != 24 || !text.is_ascii() {
        return None;
    }
    let number = |from: usize, to: usize| text.get(from..to)?.parse::<u64>().ok();
    let (year, month, day) = (number(0, 4)?, number(5, 7)?, number(8, 10)?);
    let (h, m, s, ms) = (number(11, 13)?, number(14, 16)?, number(17, 19)?, number(20, 23)?);
    if year < 1970 || h > 23 || m > 59 || s > 59 {
        return None;
    }
    let days = days_from_civil(year, month, day)?;
    let unix_ms = days * DAY_MS + h * 3_600_000 + m * 60_000 + s * 1000 + ms;
    // Also refuses every wrong separator, sign and day of the month.
    (format_utc(unix_ms) == text).then_some(unix_ms)
}

/// Days since 1970-01-01 → (year, month, day). Counts in 400-year cycles that begin on 1 March, so that the leap
/// day is the last of its year.
fn civil_from_days(days: u64) -> (u64, u64, u64) {
    let z = days + 719_468; // days since 0000-03-01
    let era = z / 146_097;
    let day_of_era = z % 146_097;
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted_month = (5 * day_of_year + 2) / 153; // 0 = March
    let day = day_of_year - (153 * shifted_month + 2) / 5 + 1;
    let month = if shifted_month < 10 { shifted_month + 3 } else { shifted_month - 9 };
    (era * 400 + year_of_era + u64::from(month <= 2), month, day)
}

fn days_from_civil(year: u64, month: u64, day: u64) -> Option<u64> {
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    let year = year - u64::from(month <= 2);
    let era = year / 400;
    let year_of_era = year % 400;
    let shifted_month = (month + 9) % 12;
    let day_of_year = (153 * shifted_month + 2) / 5 + day - 1;
    let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
    (era * 146_097 + day_of_era).checked_sub(719_468)
}

#[cfg(test)]
mod tests;
