//! A cell of a table: words, and the records that they are about, each a link to its row of the table of events.

/// More spans of records than this are counted, not named.
const MOST_SPANS: usize = 8;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Cell {
    pub text: String,
    /// The record that this is the place of, for links.
    pub place_of: Option<u64>,
    /// Spans of records, first and last of each.
    pub about: Vec<[u64; 2]>,
}

/// What a cell shows, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Piece {
    Words(String),
    Record(u64),
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell { text, ..Cell::default() }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Cell {
        text.to_owned().into()
    }
}

impl Cell {
    /// The place of a record.
    pub fn place(seq: u64) -> Cell {
        Cell { place_of: Some(seq), ..seq.to_string().into() }
    }

    /// Words about records.
    pub fn about(text: impl Into<String>, about: Vec<[u64; 2]>) -> Cell {
        Cell { about, ..text.into().into() }
    }

    pub fn pieces(&self) -> Vec<Piece> {
        let words = |text: &str| Piece::Words(text.into());
        let mut out = Vec::new();
        if !self.text.is_empty() {
            out.push(words(&self.text));
        }
        let all: u64 = self.about.iter().map(|[first, last]| last - first + 1).sum();
        if !self.text.is_empty() && all > 0 {
            out.push(words(if all == 1 { ": record " } else { ": records " }));
        }
        for (i, [first, last]) in self.about.iter().take(MOST_SPANS).enumerate() {
            if i > 0 {
                out.push(words(", "));
            }
            out.push(Piece::Record(*first));
            if last > first {
                out.push(words(if last - first == 1 { ", " } else { " to " }));
                out.push(Piece::Record(*last));
            }
        }
        let more: u64 = self.about.iter().skip(MOST_SPANS).map(|[first, last]| last - first + 1).sum();
        if more > 0 {
            out.push(words(&format!(" and {more} more")));
        }
        out
    }
}

/// Numbers that rise, as spans without gaps.
pub(super) fn spans(numbers: impl IntoIterator<Item = u64>) -> Vec<[u64; 2]> {
    let mut out: Vec<[u64; 2]> = Vec::new();
    for n in numbers {
        match out.last_mut() {
            Some([_, last]) if *last + 1 == n => *last = n,
            _ => out.push([n, n]),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_in_few_words() {
        assert_eq!(spans([]), [[0; 2]; 0]);
        assert_eq!(spans([0, 1, 2, 4, 7, 8]), [[0, 2], [4, 4], [7, 8]]);
        let shown = |numbers: &[u64], text: &str| {
            let pieces = Cell::about(text, spans(numbers.iter().copied())).pieces();
            let word = |piece: &Piece| match piece {
                Piece::Words(text) => text.clone(),
                Piece::Record(n) => format!("<{n}>"),
            };
            pieces.iter().map(word).collect::<String>()
        };
        assert_eq!(shown(&[], "nothing"), "nothing");
        assert_eq!(shown(&[3], "signed"), "signed: record <3>");
        assert_eq!(shown(&[0, 1, 2, 4, 7, 8], "signed"), "signed: records <0> to <2>, <4>, <7>, <8>");
        assert_eq!(shown(&[5], ""), "<5>");
        let odd: Vec<u64> = (0..30).map(|n| 2 * n).collect();
        assert_eq!(shown(&odd, ""), "<0>, <2>, <4>, <6>, <8>, <10>, <12>, <14> and 22 more");
    }
}
