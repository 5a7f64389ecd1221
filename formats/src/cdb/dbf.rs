//! dBASE III tables (`.dbf`): read, extended and written without touching what is not understood.
//!
//! Source: dBASE III+ file structure: a 32-byte header, 32 bytes a field, 0x0D, fixed-length records, 0x1A. Foreign
//! columns, their order, header flags and deleted records are kept byte for byte.

use std::ops::Range;

use crate::{Error, Result};

const FORMAT: &str = "dBASE table";

/// One column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The descriptor's 32 bytes: name, type at 11, width at 16, decimals at 17.
    raw: [u8; 32],
}

/// A value to be written into a column of any type that can hold it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Text(String),
    Number(f64),
    Logical(bool),
}

/// A table: columns and fixed-length records, each with its deletion flag in front.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    head: [u8; 32],
    columns: Vec<Column>,
    /// What stands between the field terminator and the first record (dBASE variants).
    after: Vec<u8>,
    /// One after the other.
    records: Vec<u8>,
    /// Bytes of a record: the deletion flag and a value of each column.
    record_length: usize,
}

impl Column {
    /// A column of type `C`, `N` or `L`.
    pub fn new(name: &str, kind: u8, width: u8, decimals: u8) -> Column {
        let mut raw = [0; 32];
        for (to, from) in raw.iter_mut().zip(name.bytes().take(10)) {
            *to = from;
        }
        (raw[11], raw[16], raw[17]) = (kind, width, decimals);
        Column { raw }
    }

    pub fn name(&self) -> String {
        String::from_utf8_lossy(self.name_bytes()).into_owned()
    }

    fn name_bytes(&self) -> &[u8] {
        let end = self.raw[..11].iter().position(|&b| b == 0).unwrap_or(11);
        self.raw[..end].trim_ascii_end()
    }

    /// `C`, `N`, `L`, …
    pub fn kind(&self) -> u8 {
        self.raw[11]
    }

    /// Bytes of a value. Character columns use the decimals byte as the high byte of their width.
    pub fn width(&self) -> usize {
        let high = if self.kind() == b'C' { usize::from(self.raw[17]) << 8 } else { 0 };
        usize::from(self.raw[16]) + high
    }

    fn decimals(&self) -> usize {
        if self.kind() == b'C' { 0 } else { usize::from(self.raw[17]) }
    }

    /// The bytes of a value, not yet padded; `None` for a column type that takes no such value.
    fn text(&self, value: &Value) -> Option<String> {
        match (self.kind(), value) {
            (b'C', Value::Text(t)) => Some(t.clone()),
            (b'C', Value::Number(n)) => Some(format!("{n}")),
            (b'N' | b'F', Value::Number(n)) => Some(format!("{n:.*}", self.decimals())),
            (b'N' | b'F', Value::Text(t)) => t.parse::<f64>().ok().map(|n| format!("{n:.*}", self.decimals())),
            (b'N' | b'F', Value::Logical(l)) => Some(u8::from(*l).to_string()),
            (b'L' | b'C', Value::Logical(l)) => Some(if *l { "T" } else { "F" }.into()),
            _ => None,
        }
    }

    /// What stands in a record that says nothing in this column.
    fn blank(&self) -> Vec<u8> {
        // Binary types (integer, double, currency, …) know no spaces.
        let fill = if b"CNFLDM".contains(&self.kind()) { b' ' } else { 0 };
        vec![fill; self.width()]
    }
}

impl Table {
    /// An empty dBASE III table, dated year, month, day.
    pub fn new(columns: Vec<Column>, date: (u16, u8, u8)) -> Table {
        let mut head = [0; 32];
        head[0] = 3;
        let record_length = record_length(&columns);
        let mut table = Table { head, columns, after: Vec::new(), records: Vec::new(), record_length };
        table.set_date(date);
        table
    }

    /// The same table without records.
    pub fn emptied(&self) -> Table {
        Table { records: Vec::new(), ..self.clone() }
    }

    pub fn set_date(&mut self, (year, month, day): (u16, u8, u8)) {
        self.head[1..4].copy_from_slice(&[year.saturating_sub(1900).min(255) as u8, month, day]);
    }

    /// Reads a table.
    ///
    /// # Errors
    /// [`Error::Malformed`] for cut or inconsistent bytes.
    pub fn read(bytes: &[u8]) -> Result<Table> {
        let Some(head) = bytes.first_chunk::<32>() else {
            return malformed(0, "a header of 32 bytes", format!("{} bytes", bytes.len()));
        };
        let number = |at: usize| usize::from(u16::from_le_bytes([head[at], head[at + 1]]));
        let (header_length, record_length) = (number(8), number(10));
        let count = u32::from_le_bytes([head[4], head[5], head[6], head[7]]) as usize;
        let Some(header) = bytes.get(..header_length).filter(|h| h.len() > 32) else {
            return malformed(8, "the header's length", header_length);
        };
        let (mut columns, mut at) = (Vec::new(), 32);
        while header.get(at).is_some_and(|&b| b != 0x0D) {
            let Some(raw) = header.get(at..at + 32) else {
                return malformed(at, "a field descriptor of 32 bytes", "the end of the header");
            };
            columns.push(Column { raw: std::array::from_fn(|i| raw[i]) });
            at += 32;
        }
        if at >= header_length {
            return malformed(at, "the field terminator 0x0D", "the end of the header");
        }
        let width = self::record_length(&columns);
        if width != record_length {
            return malformed(10, &format!("a record length of {width}, the sum of the columns"), record_length);
        }
        let end = count.checked_mul(record_length).and_then(|n| n.checked_add(header_length));
        let Some(body) = end.and_then(|end| bytes.get(header_length..end)) else {
            return malformed(
                4,
                &format!("{count} records of {record_length} bytes"),
                format!("{} bytes", bytes.len()),
            );
        };
        let records = body.to_vec();
        // Count and lengths are the writer's to fill in.
        let mut head = *head;
        head[4..12].fill(0);
        Ok(Table { head, columns, after: header[at + 1..].to_vec(), records, record_length })
    }

    /// Writes the table.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a header or record past 65535 bytes or more than 2³² − 1 records.
    pub fn write(&self) -> Result<Vec<u8>> {
        let (header, record) = (33 + 32 * self.columns.len() + self.after.len(), self.record_length);
        let (Ok(header_length), Ok(record_length), Ok(count)) =
            (u16::try_from(header), u16::try_from(record), u32::try_from(self.len()))
        else {
            return refuse(format!("a header of {header} and {} records of {record} bytes are too long", self.len()));
        };
        let mut out = Vec::with_capacity(header + self.records.len() + 1);
        out.extend(self.head);
        out[4..8].copy_from_slice(&count.to_le_bytes());
        out[8..10].copy_from_slice(&header_length.to_le_bytes());
        out[10..12].copy_from_slice(&record_length.to_le_bytes());
        self.columns.iter().for_each(|c| out.extend(c.raw));
        out.push(0x0D);
        out.extend(&self.after);
        out.extend_from_slice(&self.records);
        out.push(0x1A);
        Ok(out)
    }

    pub fn len(&self) -> usize {
        self.records.len() / self.record_length
    }

    fn record(&self, index: usize) -> Option<&[u8]> {
        let length = self.record_length;
        self.records.get(index.checked_mul(length)?..)?.get(..length)
    }

    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Whether a memo file (`.dbt`) belongs to the table.
    pub fn has_memo(&self) -> bool {
        self.columns.iter().any(|c| c.kind() == b'M')
    }

    /// The index of a column. CDB names are case-sensitive, but tools exist that write them in capitals.
    pub fn column(&self, name: &str) -> Option<usize> {
        let exact = self.columns.iter().position(|c| c.name_bytes() == name.as_bytes());
        exact.or_else(|| self.columns.iter().position(|c| c.name_bytes().eq_ignore_ascii_case(name.as_bytes())))
    }

    /// The trimmed text of a value; `None` without such a column or record, or when it is blank.
    pub fn text(&self, record: usize, name: &str) -> Option<String> {
        let bytes = self.bytes(record, &self.field(name)?)?;
        Some(String::from_utf8_lossy(bytes).into_owned())
    }

    /// Where a column's values are in a record, to look at many of them by [`Table::bytes`].
    pub fn field(&self, name: &str) -> Option<Range<usize>> {
        let (start, width) = self.span(self.column(name)?);
        Some(start..start + width)
    }

    /// The trimmed bytes of a value; `None` without such a record, or when it is blank.
    pub fn bytes(&self, record: usize, field: &Range<usize>) -> Option<&[u8]> {
        let value = self.record(record)?.get(field.clone())?;
        let fill = |b: &u8| matches!(b, b' ' | 0);
        let start = value.iter().position(|b| !fill(b))?;
        let end = value.iter().rposition(|b| !fill(b))?;
        value.get(start..=end)
    }

    /// A value as a number.
    pub fn number(&self, record: usize, name: &str) -> Option<f64> {
        self.text(record, name)?.parse().ok().filter(|n: &f64| n.is_finite())
    }

    /// A value as a truth value.
    pub fn logical(&self, record: usize, name: &str) -> Option<bool> {
        match self.text(record, name)?.as_str() {
            "T" | "t" | "Y" | "y" => Some(true),
            "F" | "f" | "N" | "n" => Some(false),
            _ => None,
        }
    }

    /// Whether a record is marked as deleted.
    pub fn is_deleted(&self, record: usize) -> bool {
        self.record(record).is_some_and(|r| r.first() == Some(&b'*'))
    }

    /// Inserts a column at an index; existing records get `value`, or blanks.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when the value does not fit.
    pub fn insert_column(&mut self, index: usize, column: Column, value: Option<&Value>) -> Result<()> {
        let index = index.min(self.columns.len());
        let start = 1 + self.columns[..index].iter().map(Column::width).sum::<usize>();
        let filler = value.map_or_else(|| Ok(column.blank()), |v| padded(&column, v))?;
        self.insert_bytes(start, &filler);
        self.columns.insert(index, column);
        Ok(())
    }

    /// Adds a blank record and returns its index.
    pub fn push(&mut self) -> usize {
        self.records.push(b' ');
        for column in &self.columns {
            self.records.extend(column.blank());
        }
        self.len() - 1
    }

    /// Copies a record of a table with the same columns.
    pub fn push_from(&mut self, other: &Table, record: usize) {
        if let Some(bytes) = other.record(record).filter(|r| r.len() == self.record_length) {
            self.records.extend_from_slice(bytes);
        }
    }

    /// Sets a value, widening a character or number column that is too narrow (older values stay).
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a column of another type, or one that cannot be widened.
    pub fn set(&mut self, record: usize, column: usize, value: &Value) -> Result<()> {
        let text = self.columns.get(column).and_then(|c| c.text(value));
        if let Some(text) = text {
            self.widen(column, text.len());
        }
        let (Some(c), (start, width)) = (self.columns.get(column), self.span(column)) else { return Ok(()) };
        let bytes = padded(c, value)?;
        let at = record.saturating_mul(self.record_length).saturating_add(start);
        if let Some(place) = self.records.get_mut(at..at.saturating_add(width)) {
            place.copy_from_slice(&bytes);
        }
        Ok(())
    }

    fn widen(&mut self, index: usize, needed: usize) {
        let (start, width) = self.span(index);
        let Some(column) = self.columns.get(index) else { return };
        let right_aligned = match column.kind() {
            b'C' if needed <= 254 => false,
            b'N' | b'F' if needed <= 20 => true,
            _ => return,
        };
        if needed <= width {
            return;
        }
        let at = if right_aligned { start } else { start + width };
        self.insert_bytes(at, &vec![b' '; needed - width]);
        self.columns[index].raw[16] = needed as u8;
    }

    /// Puts bytes into every record at a place in it.
    fn insert_bytes(&mut self, at: usize, bytes: &[u8]) {
        let mut out = Vec::with_capacity(self.records.len() + self.len() * bytes.len());
        for record in self.records.chunks_exact(self.record_length) {
            let (before, after) = record.split_at(at);
            out.extend_from_slice(before);
            out.extend_from_slice(bytes);
            out.extend_from_slice(after);
        }
        self.records = out;
        self.record_length += bytes.len();
    }

    /// Start and width of a column's bytes in a record.
    fn span(&self, column: usize) -> (usize, usize) {
        let before = self.columns.iter().take(column).map(Column::width).sum::<usize>();
        (1 + before, self.columns.get(column).map_or(0, Column::width))
    }
}

fn record_length(columns: &[Column]) -> usize {
    1 + columns.iter().map(Column::width).sum::<usize>()
}

fn padded(column: &Column, value: &Value) -> Result<Vec<u8>> {
    let (name, kind, width) = (column.name(), char::from(column.kind()), column.width());
    let Some(text) = column.text(value) else {
        return refuse(format!("column {name} is of type {kind}, which cannot hold {value:?}"));
    };
    if text.len() > width || !text.is_ascii() {
        return refuse(format!("{text:?} does not fit column {name} of type {kind} and width {width}"));
    }
    let text = if kind == 'C' { format!("{text:<width$}") } else { format!("{text:>width$}") };
    Ok(text.into_bytes())
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: FORMAT, what })
}

fn malformed<T>(at: usize, expected: &str, found: impl ToString) -> Result<T> {
    Err(Error::Malformed { format: FORMAT, offset: at as u64, expected: expected.into(), found: found.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sample() -> Table {
        let mut t = Table::new(
            vec![Column::new("CNAM", b'C', 8, 0), Column::new("AO1", b'N', 7, 3), Column::new("AHGT", b'L', 1, 0)],
            (2026, 2, 3),
        );
        for (name, angle, above) in [("UA005000", 359.5, true), ("x", 0.0, false)] {
            let r = t.push();
            t.set(r, 0, &Value::Text(name.into())).unwrap();
            t.set(r, 1, &Value::Number(angle)).unwrap();
            t.set(r, 2, &Value::Logical(above)).unwrap();
        }
        t
    }

    #[test]
    fn bytes_are_dbase_iii() {
        let bytes = sample().write().unwrap();
        assert_eq!(&bytes[..12], [3, 126, 2, 3, 2, 0, 0, 0, 129, 0, 17, 0]);
        assert_eq!(&bytes[64..84], b"AO1\0\0\0\0\0\0\0\0N\0\0\0\0\x07\x03\0\0");
        assert_eq!(&bytes[128..], b"\x0D UA005000359.500T x         0.000F\x1A");
    }

    #[test]
    fn values_read_back() {
        let t = Table::read(&sample().write().unwrap()).unwrap();
        assert_eq!(t, sample());
        assert_eq!(
            (t.text(0, "CNAM").as_deref(), t.number(0, "AO1"), t.logical(0, "AHGT")),
            (Some("UA005000"), Some(359.5), Some(true))
        );
        assert_eq!((t.logical(1, "ahgt"), t.text(2, "CNAM"), t.text(0, "none")), (Some(false), None, None));
    }

    #[test]
    fn what_is_not_understood_stays() {
        // Visual FoxPro: another version byte, flags, and 263 bytes after the terminator; an integer column.
        let mut t = sample();
        t.head[0] = 0x30;
        t.head[29] = 3;
        t.after = vec![7; 263];
        let second = t.record_length;
        t.records[second] = b'*';
        t.insert_column(1, Column::new("ID", b'I', 4, 0), None).unwrap();
        let bytes = t.write().unwrap();
        let back = Table::read(&bytes).unwrap();
        assert_eq!(back, t);
        assert_eq!(back.write().unwrap(), bytes);
        assert!(back.is_deleted(1) && !back.is_deleted(0));
        assert_eq!(back.number(0, "AO1"), Some(359.5));
    }

    #[test]
    fn columns_are_added_and_widened_around_older_values() {
        let mut t = sample();
        t.insert_column(0, Column::new("FACC", b'C', 5, 0), Some(&Value::Text("AL015".into()))).unwrap();
        t.set(1, 1, &Value::Text("UA005000LongerName".into())).unwrap();
        t.set(1, 2, &Value::Number(12345.5)).unwrap();
        let t = Table::read(&t.write().unwrap()).unwrap();
        assert_eq!((t.text(0, "FACC").as_deref(), t.text(1, "FACC").as_deref()), (Some("AL015"), Some("AL015")));
        assert_eq!(t.text(0, "CNAM").as_deref(), Some("UA005000"));
        assert_eq!(
            (t.number(0, "AO1"), t.number(1, "AO1"), t.logical(0, "AHGT")),
            (Some(359.5), Some(12345.5), Some(true))
        );
    }

    #[test]
    fn values_that_do_not_fit_are_refused() {
        let mut t = sample();
        t.insert_column(9, Column::new("PIC", b'G', 4, 0), None).unwrap();
        assert!(t.set(0, 3, &Value::Number(1.0)).is_err());
        assert!(t.set(0, 2, &Value::Number(1.0)).is_err());
        assert!(t.set(0, 0, &Value::Text("ü".into())).is_err());
        assert!(t.set(0, 0, &Value::Text("x".repeat(255))).is_err());
        assert!(t.set(0, 1, &Value::Number(1e30)).is_err());
        assert!(t.set(0, 1, &Value::Text("north".into())).is_err());
    }

    #[test]
    fn broken_bytes_are_refused() {
        let good = sample().write().unwrap();
        for end in 0..good.len() - 1 {
            assert!(Table::read(&good[..end]).is_err(), "cut at {end}");
        }
        for (at, value) in [(4, 9), (7, 255), (8, 0), (8, 128), (10, 1), (128, 0)] {
            let mut broken = good.clone();
            broken[at] = value;
            assert!(Table::read(&broken).is_err(), "byte {at}");
        }
    }

    proptest! {
        #[test]
        fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            if let Ok(t) = Table::read(&bytes) {
                prop_assert_eq!(Table::read(&t.write().unwrap()).unwrap(), t);
            }
        }
    }
}
