//! One question to a time server (SNTP, RFC 4330): the only server that Orb ever asks, and only when a
//! user names it.
//! Nothing authenticates the answer but that it repeats what was asked.

use std::io;
use std::net::{Ipv4Addr, Ipv6Addr, SocketAddr, ToSocketAddrs as _};
use std::time::Duration;

use rsntp::{Config, SntpClient, SynchronizationError};

use super::{LAST_MS, Source, SyncStatus, TimeReading};
use crate::audit::record::printable;
use crate::{Error, Result};

const TIMEOUT: Duration = Duration::from_secs(5);
/// RFC 5905 §7.2.
const PORT: u16 = 123;
/// 2036-02-07T06:28:16Z, where NTP's 32 bits of seconds begin again (RFC 5905 §6).
const ZERO_MS: u64 = 2_085_978_496_000;

/// Asks an NTP server, HOST or HOST:PORT, and corrects the reading by its answer.
///
/// # Errors
/// [`crate::Kind::Environment`] when it does not answer, refuses (a kiss of death, RFC 5905 §7.4), answers another question, or
/// says itself that it does not know the time.
pub fn ask_server(server: &str, local: TimeReading) -> Result<TimeReading> {
    ask_within(server, local, TIMEOUT)
}

fn ask_within(server: &str, local: TimeReading, timeout: Duration) -> Result<TimeReading> {
    let failed = |found: String| {
        Error::environment(format!("--ntp-server {server}"))
            .expected("an answer of a time server that is synchronised")
            .found(found)
            .advice(
                "Nothing was published. Without --ntp-server the record states what the kernel says of its own clock.",
            )
    };
    let at = address(server).map_err(|e| failed(format!("no address: {e}")))?;
    let own = if at.is_ipv4() { (Ipv4Addr::UNSPECIFIED, 0).into() } else { (Ipv6Addr::UNSPECIFIED, 0).into() };
    let client = SntpClient::with_config(Config::default().bind_address(own).timeout(timeout));
    let answer = client.synchronize(at).map_err(|e| {
        failed(match e {
            // What a read that ran out of time is called differs between systems.
            SynchronizationError::IOError(e)
                if matches!(e.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) =>
            {
                format!("no answer within {} ms", timeout.as_millis())
            }
            e => e.to_string(),
        })
    })?;
    let micros = |seconds: f64| (seconds * 1e6).round() as i64;
    let way = answer.round_trip_delay().as_secs_f64();
    // Longer than was waited for, or shorter than nothing but for the clocks' grain: its two times are not of this answer.
    if !(-0.01..timeout.as_secs_f64() + 0.01).contains(&way) {
        return Err(failed(format!("times that contradict each other: {way:.3} s for the way there and back")));
    }
    let offset_us = micros(answer.clock_offset().as_secs_f64());
    let unix_ms = local.unix_ms.checked_add_signed(offset_us.div_euclid(1000)).filter(|ms| *ms <= LAST_MS);
    let unix_ms = unix_ms.ok_or_else(|| failed("a time outside 1970 to 9999".into()))?;
    // RFC 4330 §5: zero means that the server has no time. The client reads it as the second era's first moment.
    if unix_ms.abs_diff(ZERO_MS) <= timeout.as_millis() as u64 {
        return Err(failed("no time".into()));
    }
    Ok(TimeReading {
        unix_ms,
        source: Source::NtpQuery,
        sync_status: SyncStatus::Synchronised,
        offset_us: Some(offset_us),
        // RFC 5905 §11.1: half of the way there and back bounds what the way can hide. What the server itself is off by comes
        // on top; it is not asked for that.
        max_error_us: Some(micros(way.abs() / 2.0)),
        stratum: Some(answer.stratum()),
        reference: Some(printable(&format!("{server} ({})", answer.reference_identifier()))),
        since_boot: local.since_boot,
    })
}

fn address(server: &str) -> io::Result<SocketAddr> {
    let mut found = match server.to_socket_addrs() {
        Ok(with_port) => with_port,
        Err(_) => (server.trim_matches(['[', ']']), PORT).to_socket_addrs()?,
    };
    found.next().ok_or_else(|| io::ErrorKind::NotFound.into())
}

#[cfg(test)]
mod tests {
    use std::net::UdpSocket;
    use std::time::{SystemTime, UNIX_EPOCH};

    use super::*;
    use crate::audit::time::now;

    /// A server on this machine, ten seconds ahead, that answers one request (RFC 5905 §7.3) with `spoil` done to the answer.
    fn server(spoil: fn(&mut [u8; 48])) -> String {
        let socket = UdpSocket::bind(("127.0.0.1", 0)).unwrap();
        let at = socket.local_addr().unwrap();
        std::thread::spawn(move || {
            let mut request = [0; 48];
            let (size, client) = socket.recv_from(&mut request).unwrap();
            // A client of version 3 or 4, which puts its own time where the answer has to repeat it.
            assert!(size == 48 && request[0] & 7 == 3 && request[40..48] != [0; 8], "{request:?}");
            let since_1900 = |ahead: f64| {
                let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap().as_secs_f64() + 2_208_988_800.0 + ahead;
                ((now.trunc() as u64) << 32 | (now.fract() * 4_294_967_296.0) as u64).to_be_bytes()
            };
            let mut answer = [0; 48];
            answer[0] = 4 << 3 | 4;
            answer[1] = 2;
            answer[12..16].copy_from_slice(&[192, 0, 2, 1]);
            answer[16..24].copy_from_slice(&since_1900(0.0));
            answer[24..32].copy_from_slice(&request[40..48]);
            answer[32..40].copy_from_slice(&since_1900(10.0));
            answer[40..48].copy_from_slice(&since_1900(10.0));
            spoil(&mut answer);
            socket.send_to(&answer, client).unwrap();
        });
        at.to_string()
    }

    #[test]
    fn a_server_that_was_named() {
        let local = now().unwrap();
        let server = server(|_| {});
        let asked = ask_server(&server, local.clone()).unwrap();
        assert_eq!((asked.source, asked.sync_status), (Source::NtpQuery, SyncStatus::Synchronised));
        assert!((asked.unix_ms - local.unix_ms).abs_diff(10_000) < 1000, "{asked:?}");
        assert_eq!((asked.stratum, asked.reference.clone()), (Some(2), Some(format!("{server} (192.0.2.1)"))));
        assert_eq!(asked.since_boot, local.since_boot);
        assert!(
            asked.describe().contains(&format!("NTP server {server} (192.0.2.1) was asked")),
            "{}",
            asked.describe()
        );
    }

    /// Each by its own words; none of them gives a time.
    #[test]
    fn answers_that_are_none() {
        type Spoiled<'a> = (&'a str, fn(&mut [u8; 48]), &'a str);
        let spoiled: [Spoiled<'_>; 9] = [
            ("kiss of death", |a| (a[1], a[12], a[13], a[14], a[15]) = (0, b'R', b'A', b'T', b'E'), "ate"),
            ("another question's answer", |a| a[31] ^= 1, "originate"),
            ("leap indicator 3", |a| a[0] |= 3 << 6, "synchronized"),
            ("stratum 16", |a| a[1] = 16, "synchronized"),
            ("no time", |a| a[32..].fill(0), "no time"),
            ("no time of sending", |a| a[40..].fill(0), "contradict"),
            ("a client's packet", |a| a[0] = 4 << 3 | 3, "mode"),
            ("version 1", |a| a[0] = 1 << 3 | 4, "version"),
            ("a reference clock's name that is none", |a| (a[1], a[12]) = (1, 0xff), "reference"),
        ];
        for (what, spoil, word) in spoiled {
            let error = ask_server(&server(spoil), now().unwrap()).unwrap_err();
            assert_eq!(error.kind, crate::Kind::Environment, "{what}");
            assert!(error.found.to_lowercase().contains(word), "{what}: {error}");
        }
    }

    #[test]
    fn nobody_answers() {
        // Bound, so that nobody else answers there either.
        let silent = UdpSocket::bind(("127.0.0.1", 0)).unwrap();
        let at = silent.local_addr().unwrap().to_string();
        let error = ask_within(&at, now().unwrap(), Duration::from_millis(50)).unwrap_err();
        assert!(error.kind == crate::Kind::Environment && error.found == "no answer within 50 ms", "{error}");
        let error = ask_server("", now().unwrap()).unwrap_err();
        assert!(error.found.contains("no address"), "{error}");
    }

    #[test]
    fn addresses() {
        for (text, port) in [("127.0.0.1", 123), ("127.0.0.1:1123", 1123), ("::1", 123), ("[::1]", 123), ("[::1]:9", 9)]
        {
            assert_eq!(address(text).unwrap().port(), port, "{text}");
        }
    }
}
