//! The UTC time of a run, and how much it can be trusted. Read once; everything else takes it as a value.

use std::time::{SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Serialize};

use crate::{Error, Result};

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimeReading {
    /// Milliseconds since 1970-01-01T00:00:00Z, leap seconds not counted.
    pub unix_ms: u64,
    pub source: Source,
    pub sync_status: SyncStatus,
    /// The kernel's estimate of its offset from the reference, microseconds.
    pub offset_us: Option<i64>,
    /// The kernel's bound on its error, microseconds.
    pub max_error_us: Option<i64>,
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
                "{} (an NTP server was asked: clock off by {offset} ms, error at most {error} ms)",
                self.utc()
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
    let (source, sync_status, offset_us, max_error_us) = kernel_quality();
    Ok(TimeReading { unix_ms, source, sync_status, offset_us, max_error_us })
}

/// Asks an NTP server (SNTP, RFC 4330) and corrects the reading by its answer. The only network access that Orb has; made
/// only when a user names a server.
///
/// # Errors
/// [`crate::Kind::Environment`] when it does not answer, or says itself that it does not know the time.
pub fn ask_server(server: &str, local: TimeReading) -> Result<TimeReading> {
    let failed = |found: String| {
        Error::environment(format!("--ntp-server {server}"))
            .expected("an answer of a time server that is synchronised")
            .found(found)
            .advice("Without --ntp-server the record states what the kernel says of its own clock.")
    };
    let client = rsntp::SntpClient::with_config(rsntp::Config::default().timeout(NTP_TIMEOUT));
    let answer = client.synchronize(server).map_err(|e| failed(e.to_string()))?;
    if answer.leap_indicator() == rsntp::LeapIndicator::AlarmCondition {
        return Err(failed("a server whose own clock is not synchronised".into()));
    }
    let micros = |seconds: f64| (seconds * 1e6).round() as i64;
    let offset_us = micros(answer.clock_offset().as_secs_f64());
    let unix_ms = local.unix_ms.checked_add_signed(offset_us.div_euclid(1000)).filter(|ms| *ms <= LAST_MS);
    Ok(TimeReading {
        unix_ms: unix_ms.ok_or_else(|| failed("a time outside 1970 to 9999".into()))?,
        source: Source::NtpQuery,
        sync_status: SyncStatus::Synchronised,
        offset_us: Some(offset_us),
        // RFC 5905 §11.1: half of the way there and back bounds what the way can hide.
        max_error_us: Some(micros(answer.round_trip_delay().as_secs_f64().abs() / 2.0)),
    })
}

const NTP_TIMEOUT: std::time::Duration = std::time::Duration::from_secs(5);

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
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Seconds from `date -u -d … +%s`.
    #[test]
    fn known_dates() {
        for (unix_s, text) in [
            (0, "1970-01-01T00:00:00.000Z"),
            (951_782_400, "2000-02-29T00:00:00.000Z"),
            (1_709_164_799, "2024-02-28T23:59:59.000Z"),
            (1_709_251_200, "2024-03-01T00:00:00.000Z"),
            (4_107_542_400, "2100-03-01T00:00:00.000Z"),
            (253_402_300_799, "9999-12-31T23:59:59.000Z"),
        ] {
            assert_eq!(format_utc(unix_s * 1000), text);
            assert_eq!(parse_utc(text), Some(unix_s * 1000));
        }
        assert_eq!(format_utc(1_795_224_582_120), "2026-11-21T01:29:42.120Z");
    }

    #[test]
    fn not_a_time() {
        for text in [
            "",
            "2026-11-21T01:29:42Z",
            "2026-11-21T01:29:42.120+00:00",
            "2026-11-21 01:29:42.120Z",
            "2026-02-29T00:00:00.000Z",
            "2026-13-01T00:00:00.000Z",
            "2026-00-01T00:00:00.000Z",
            "2026-01-00T00:00:00.000Z",
            "2026-01-01T24:00:00.000Z",
            "2026-01-01T00:60:00.000Z",
            "2026-01-01T00:00:60.000Z",
            "+026-01-01T00:00:00.000Z",
            "1969-12-31T23:59:59.999Z",
            "2026-11-21T01:29:42.12éZ",
        ] {
            assert_eq!(parse_utc(text), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn formatting_and_reading_are_inverse(ms in 0..=LAST_MS) {
            let text = format_utc(ms);
            prop_assert_eq!(text.len(), 24);
            prop_assert_eq!(parse_utc(&text), Some(ms));
        }

        #[test]
        fn later_is_greater_as_text(a in 0..=LAST_MS, b in 0..=LAST_MS) {
            prop_assert_eq!(a.cmp(&b), format_utc(a).cmp(&format_utc(b)));
        }
    }

    /// A server on this machine that answers one request (RFC 5905 §7.3), ten seconds ahead; with `leap` 3 it is itself
    /// not synchronised.
    fn server(leap: u8) -> std::net::SocketAddr {
        let socket = std::net::UdpSocket::bind(("127.0.0.1", 0)).unwrap();
        let at = socket.local_addr().unwrap();
        std::thread::spawn(move || {
            let mut request = [0; 48];
            let (_, client) = socket.recv_from(&mut request).unwrap();
            let since_1900 = |ahead: f64| {
                let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap().as_secs_f64() + 2_208_988_800.0 + ahead;
                ((now.trunc() as u64) << 32 | (now.fract() * 4_294_967_296.0) as u64).to_be_bytes()
            };
            let mut answer = [0; 48];
            answer[0] = leap << 6 | 4 << 3 | 4;
            answer[1] = 2;
            answer[12..16].copy_from_slice(&[127, 0, 0, 1]);
            answer[16..24].copy_from_slice(&since_1900(0.0));
            answer[24..32].copy_from_slice(&request[40..48]);
            answer[32..40].copy_from_slice(&since_1900(10.0));
            answer[40..48].copy_from_slice(&since_1900(10.0));
            socket.send_to(&answer, client).unwrap();
        });
        at
    }

    #[test]
    fn a_server_that_was_named() {
        let local = now().unwrap();
        let asked = ask_server(&server(0).to_string(), local).unwrap();
        assert_eq!((asked.source, asked.sync_status), (Source::NtpQuery, SyncStatus::Synchronised));
        assert!((asked.unix_ms - local.unix_ms).abs_diff(10_000) < 1000, "{asked:?}");
        assert!(asked.describe().contains("an NTP server was asked"), "{}", asked.describe());
        let error = ask_server(&server(3).to_string(), local).unwrap_err();
        assert_eq!(error.kind, crate::Kind::Environment);
    }

    #[test]
    fn the_clock_of_this_machine() {
        let reading = now().unwrap();
        assert!(reading.unix_ms > parse_utc("2024-01-01T00:00:00.000Z").unwrap());
        // A local reading never claims more than the kernel says.
        assert!(matches!(reading.source, Source::Kernel | Source::None));
        if reading.source == Source::None {
            assert_eq!(reading.sync_status, SyncStatus::Unknown);
        }
        assert!(!reading.describe().contains("NTP"));
    }
}
