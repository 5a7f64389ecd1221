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

#[test]
fn the_time_since_the_start_of_this_machine() {
    let (first, second) = (now().unwrap(), now().unwrap());
    assert_eq!(first.since_boot.is_some(), cfg!(target_os = "linux"));
    let (Some(a), Some(b)) = (first.since_boot, second.since_boot) else { return };
    assert!(a.boot_id == b.boot_id && a.milliseconds <= b.milliseconds);
}

#[test]
fn names_of_a_start() {
    assert!(is_boot_id("bfbaf76d-3eb4-472a-b7e1-82de74e141d9"));
    for wrong in [
        "",
        "bfbaf76d3eb4472ab7e182de74e141d9",
        "BFBAF76D-3eb4-472a-b7e1-82de74e141d9",
        "bfbaf76d-3eb4-472a-b7e1-82de74e141dg",
    ] {
        assert!(!is_boot_id(wrong), "{wrong}");
    }
}
