//! A ledger as inline SVG 1.1: time from left to right, a lane for each kind of record, bars for how many there were.
//!
//! As the lineage: laid out from the records alone, in the page's own ink and paper, and no colour says anything.

use std::fmt::Write as _;

use super::html::escaped;
use super::picture::{LINE_STEP, WIDTH, broken, text};
use super::timeline::{Mark, Timeline, counted};
use crate::audit::time;

/// Where time begins and ends, from left to right.
const LEFT: f64 = 196.0;
const RIGHT: f64 = 936.0;
/// How many bars fit between them.
const BINS: usize = 148;
const TOP: f64 = 64.0;
/// From one lane to the next; the highest and the lowest bar; from the lane's line to the bottom of the signs below it.
const LANE: f64 = 36.0;
const HIGH: f64 = 20.0;
const LOW: f64 = 4.0;
const SIGN: f64 = 11.0;
/// Characters of a kind's name, and of the numbers at the right, that fit.
const KIND_CELLS: usize = 25;
const NUMBER_CELLS: usize = 16;
/// More checkpoints than this have no line through the lanes.
const MOST_LINES: usize = 60;
const MOST_TICKS: u64 = 7;

pub(super) const STYLE: &str = "\
.timeline .bar{fill:currentColor;stroke-width:.8}.timeline .tail{stroke-width:.8}.timeline .grid{stroke-width:.6;opacity:.45}\
.timeline .dots{stroke-dasharray:1 4;opacity:.8}.timeline .edge{stroke-width:2.6}.timeline .e{text-anchor:end}\
.timeline .sign{font-size:12px;font-weight:700;text-anchor:middle}";

pub(super) fn render(timeline: &Timeline) -> String {
    let span_ms = (timeline.to_ms - timeline.from_ms).max(1);
    let x_of = |ms: u64| tenth(LEFT + (RIGHT - LEFT) * (ms.saturating_sub(timeline.from_ms)) as f64 / span_ms as f64);
    let bottom = TOP + LANE * timeline.lanes.len() as f64 + SIGN;
    let height = bottom + 2.0 * LINE_STEP + 30.0;
    let middle = WIDTH / 2.0;
    let mut out = format!(
        "<figure class=\"lineage timeline\">\n<div><svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
         aria-labelledby=\"timeline-title timeline-words\">\n<title id=\"timeline-title\">The ledger's records by kind and time</title>\n\
         <desc id=\"timeline-words\">{}. {}.</desc>\n",
        escaped(&timeline.banner),
        escaped(&timeline.words().join(". "))
    );
    text(&mut out, middle, 18.0, "h m", &timeline.banner);
    text(&mut out, middle, height - 10.0, "h m", &timeline.banner);
    for (ms, label) in ticks(timeline.from_ms, timeline.to_ms) {
        line(&mut out, "grid", x_of(ms), [TOP, bottom]);
        text(&mut out, x_of(ms), bottom + LINE_STEP, "m", &label);
    }
    // Clear of a time that stands below the axis' beginning.
    text(&mut out, LEFT - 56.0, bottom + LINE_STEP, "e", "UTC");
    let checkpoints = &timeline.checkpoints;
    for ms in checkpoints {
        if checkpoints.len() <= MOST_LINES {
            line(&mut out, "dots", x_of(*ms), [TOP - 8.0, bottom]);
        }
        let _ = writeln!(out, "<path class=\"tip\" d=\"M{:.1} {:.1}l5 5l-5 5l-5 -5z\"/>", x_of(*ms), TOP - 18.0);
    }
    if !checkpoints.is_empty() {
        text(&mut out, LEFT - 10.0, TOP - 9.0, "e", "checkpoint signed");
    }
    let bins: Vec<Vec<Vec<Mark>>> = timeline.lanes.iter().map(|(_, marks)| binned(marks, timeline, span_ms)).collect();
    let most = bins.iter().flatten().map(Vec::len).max().unwrap_or(1);
    for (i, ((kind, marks), bins)) in timeline.lanes.iter().zip(&bins).enumerate() {
        let base = TOP + LANE * (i + 1) as f64 - SIGN;
        let name = broken(kind, KIND_CELLS, 1).concat();
        text(&mut out, LEFT - 10.0, base - 2.0, "e", &name);
        line_across(&mut out, base);
        let failed = marks.iter().filter(|m| m.failed).count();
        text(&mut out, RIGHT + 12.0, base - 2.0, "", &broken(&marks.len().to_string(), NUMBER_CELLS, 1).concat());
        if failed > 0 {
            text(
                &mut out,
                RIGHT + 12.0,
                base + SIGN - 1.0,
                "",
                &broken(&format!("{failed} failed"), NUMBER_CELLS, 1).concat(),
            );
        }
        for (at, marks) in bins.iter().enumerate().filter(|(_, marks)| !marks.is_empty()) {
            bar(&mut out, at, marks, base, most);
        }
    }
    match timeline.anchored {
        Some((seq, ms)) => {
            // Behind the bar of its last record.
            let x = tenth(LEFT + (bin(ms, timeline, span_ms) + 1) as f64 * (RIGHT - LEFT) / BINS as f64);
            line(&mut out, "edge", x, [TOP - 22.0, bottom]);
            let (class, at) = if x > middle { ("e", x - 6.0) } else { ("", x + 6.0) };
            text(&mut out, at, TOP - 26.0, class, &format!("anchored through record {seq}"));
        }
        None => text(&mut out, LEFT, TOP - 26.0, "", "no record is anchored"),
    }
    let each = span_ms.div_ceil(BINS as u64);
    let _ = write!(
        out,
        "</svg></div>\n<figcaption>A bar is the records of one kind within {}; the highest stands for {}. Filled: covered by a \
         checkpoint that was kept elsewhere. Hollow: after it, where a cut of the ledger's end would not show. × below a bar: a \
         failure or refusal among them; ! an error that the verification found. Diamonds: checkpoints that were signed; the heavy \
         line: how far one that was kept elsewhere reaches.</figcaption>\n</figure>\n",
        lasting(each),
        counted(most, "record")
    );
    out
}

fn bin(ms: u64, timeline: &Timeline, span_ms: u64) -> usize {
    let share = u128::from(ms.saturating_sub(timeline.from_ms)) * BINS as u128 / u128::from(span_ms);
    usize::try_from(share).unwrap_or(BINS).min(BINS - 1)
}

fn binned(marks: &[Mark], timeline: &Timeline, span_ms: u64) -> Vec<Vec<Mark>> {
    let mut bins = vec![Vec::new(); BINS];
    for mark in marks {
        bins[bin(mark.ms, timeline, span_ms)].push(*mark);
    }
    bins
}

/// The bar of some records: those that are anchored filled, the others hollow on top of them. Its title says which they are.
fn bar(out: &mut String, at: usize, marks: &[Mark], base: f64, most: usize) {
    let step = (RIGHT - LEFT) / BINS as f64;
    let (x, width) = (tenth(LEFT + step * at as f64 + 0.5), step - 1.0);
    let high = if most > 1 { LOW + (HIGH - LOW) * (marks.len() - 1) as f64 / (most - 1) as f64 } else { HIGH / 2.0 };
    let anchored = marks.iter().filter(|m| !m.tail).count();
    let filled = high * anchored as f64 / marks.len() as f64;
    let (first, last) = (marks.iter().map(|m| m.seq).min(), marks.iter().map(|m| m.seq).max());
    let (first, last) = (first.unwrap_or_default(), last.unwrap_or_default());
    let which = if first == last { format!("record {first}") } else { format!("records between {first} and {last}") };
    let when = marks.iter().map(|m| m.ms).min().unwrap_or_default();
    let _ = writeln!(out, "<g><title>{}: {which}, from {}</title>", marks.len(), time::format_utc(when));
    if anchored > 0 {
        column(out, "bar", [x, base - filled, width, filled]);
    }
    if anchored < marks.len() {
        column(out, "tail", [x, base - high, width, high - filled]);
    }
    let sign = if marks.iter().any(|m| m.flawed) { Some("!") } else { marks.iter().any(|m| m.failed).then_some("×") };
    if let Some(sign) = sign {
        text(out, x + width / 2.0, base + SIGN, "sign", sign);
    }
    out.push_str("</g>\n");
}

/// With sharp corners: it may be four units high.
fn column(out: &mut String, class: &str, [x, y, width, height]: [f64; 4]) {
    let _ = writeln!(out, "<rect class=\"{class}\" x=\"{x}\" y=\"{y:.1}\" width=\"{width}\" height=\"{height:.1}\"/>");
}

/// Enough for a picture.
fn tenth(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}

fn line(out: &mut String, class: &str, x: f64, [from, to]: [f64; 2]) {
    let _ = writeln!(out, "<path class=\"{class}\" d=\"M{x:.1} {from:.1}V{to:.1}\"/>");
}

fn line_across(out: &mut String, y: f64) {
    let _ = writeln!(out, "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{RIGHT}\"/>");
}

const SECOND: u64 = 1000;
const MINUTE: u64 = 60 * SECOND;
const HOUR: u64 = 60 * MINUTE;
const DAY: u64 = 24 * HOUR;
/// Steps between ticks; all of them divide the time since 1970 into days, hours and so on where a person would.
const STEPS: [u64; 27] = [
    SECOND,
    2 * SECOND,
    5 * SECOND,
    10 * SECOND,
    15 * SECOND,
    30 * SECOND,
    MINUTE,
    2 * MINUTE,
    5 * MINUTE,
    10 * MINUTE,
    15 * MINUTE,
    30 * MINUTE,
    HOUR,
    2 * HOUR,
    3 * HOUR,
    6 * HOUR,
    12 * HOUR,
    DAY,
    2 * DAY,
    5 * DAY,
    10 * DAY,
    20 * DAY,
    50 * DAY,
    100 * DAY,
    200 * DAY,
    500 * DAY,
    1000 * DAY,
];

/// At most [`MOST_TICKS`] times on the axis, and how each is written: by the day, the minute or the second.
fn ticks(from_ms: u64, to_ms: u64) -> Vec<(u64, String)> {
    let span = to_ms - from_ms;
    let step =
        STEPS.into_iter().find(|step| span / step < MOST_TICKS).unwrap_or_else(|| span.div_ceil(MOST_TICKS).max(1));
    let label = |ms: u64| {
        let utc = time::format_utc(ms);
        let part = match step {
            0..MINUTE => 11..19,
            MINUTE..DAY if span <= DAY => 11..16,
            MINUTE..DAY => 5..16,
            _ => 0..10,
        };
        utc.get(part).unwrap_or_default().replace('T', " ")
    };
    let first = from_ms.div_ceil(step);
    let mut all: Vec<(u64, String)> = (first..)
        .map(|n| n.saturating_mul(step))
        .take_while(|ms| *ms <= to_ms)
        .take(MOST_TICKS as usize)
        .map(|ms| (ms, label(ms)))
        .collect();
    if all.is_empty() {
        all.push((from_ms, time::format_utc(from_ms).get(..19).unwrap_or_default().replace('T', " ")));
    }
    all
}

/// A length of time in the largest unit of which it has two or more.
fn lasting(ms: u64) -> String {
    let units = [(DAY, "days"), (HOUR, "hours"), (MINUTE, "minutes"), (SECOND, "seconds")];
    match units.into_iter().find(|(unit, _)| ms >= 2 * unit) {
        Some((unit, name)) => format!("{} {name}", ms.div_ceil(unit)),
        None => "less than two seconds".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_on_the_axis() {
        let at = |utc: &str| time::parse_utc(utc).unwrap();
        let labels = |from: &str, to: &str| ticks(at(from), at(to)).into_iter().map(|t| t.1).collect::<Vec<_>>();
        assert_eq!(
            labels("2026-11-21T08:00:03.000Z", "2026-11-21T08:00:09.500Z").join(" "),
            "08:00:03 08:00:04 08:00:05 08:00:06 08:00:07 08:00:08 08:00:09"
        );
        assert_eq!(
            labels("2026-11-21T08:10:00.000Z", "2026-11-21T13:00:00.000Z").join(" "),
            "09:00 10:00 11:00 12:00 13:00"
        );
        assert_eq!(labels("2026-11-21T08:10:00.000Z", "2026-11-22T23:00:00.000Z")[0], "11-21 12:00");
        assert_eq!(labels("2026-01-01T00:00:00.000Z", "2026-12-31T00:00:00.000Z").len(), 4);
        assert_eq!(labels("2026-01-01T00:00:00.500Z", "2026-01-01T00:00:00.500Z"), ["2026-01-01 00:00:00"]);
        for span in 0..60u32 {
            let from = at("2026-11-21T08:10:00.123Z");
            let all = ticks(from, from + (1u64 << span.min(40)) * 3 / 2);
            assert!((1..=MOST_TICKS as usize).contains(&all.len()), "{span}: {all:?}");
        }
        assert_eq!(
            [1, 3 * SECOND, 90 * MINUTE, 49 * HOUR].map(lasting).join("; "),
            "less than two seconds; 3 seconds; 90 minutes; 3 days"
        );
    }
}
