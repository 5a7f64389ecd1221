//! `orb geo --manifest FILE.csv`: many photos into one store, a line each.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use super::{GeoArgs, publish_one};
use crate::audit::canonical::sha256_hex;
use crate::audit::dsse::Envelope;
use crate::audit::statement::{Param, Statement};
use crate::{Error, Kind, Result};

const COLUMNS: [&str; 18] = [
    "photo",
    "name",
    "origin",
    "origin_is",
    "alt_datum",
    "heading",
    "pitch",
    "focal",
    "height",
    "length",
    "width",
    "camera_height",
    "distance",
    "facc",
    "as",
    "dis",
    "material",
    "classification",
];
/// Name of the record's parameter that tells which line a folder came of.
pub const LINE_KEY: &str = "manifest_line";
const LARGEST: u64 = 64 << 20;

/// How a line ended.
enum End {
    Done,
    /// Published by an earlier run.
    Already,
    Failed(Error),
}

/// Runs every line; a bad one is reported and the rest goes on.
///
/// # Errors
/// A manifest that cannot be read, an interrupt. Bad lines alone end in exit code 3.
pub fn run(args: &GeoArgs, path: &Path, stop: &AtomicBool) -> Result<u8> {
    let name = path.display().to_string();
    let (_, lines) = read(path)?;
    let base = path.parent().unwrap_or(Path::new(""));
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let output = args.output.clone().unwrap_or_else(|| PathBuf::from(stem));
    let make = |folder: &Path| std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, &e));
    make(&output)?;
    let store = match (&args.write.cdb, args.format.contains(&super::Format::Cdb)) {
        (Some(given), _) => Some(given.clone()),
        (None, true) => Some(output.join("store.cdb")),
        (None, false) => None,
    };
    if let Some(store) = &store {
        make(store)?;
    }
    let mut taken: Vec<(String, usize)> = Vec::new();
    let (mut done, mut already, mut failed) = (0, 0, Vec::new());
    for line in &lines {
        if stop.load(Ordering::Relaxed) {
            return Err(Error::cancelled().advice("Run the same command again to go on."));
        }
        let end = one(args, line, base, &output, store.as_deref(), &mut taken, stop);
        let label = line.label();
        match end {
            End::Done => {
                done += 1;
                if !args.publish.quiet && !args.json {
                    crate::cli::write_out(&format!("line {:<7} {label}: published\n", line.number));
                }
            }
            End::Already => {
                already += 1;
                if !args.publish.quiet && !args.json {
                    crate::cli::write_out(&format!("line {:<7} {label}: published already\n", line.number));
                }
            }
            End::Failed(e) if e.kind == Kind::Cancelled => {
                return Err(e.advice("Run the same command again to go on."));
            }
            End::Failed(e) => {
                eprintln!("orb: {name}:{}: {label}: {e}", line.number);
                failed.push(line.number.to_string());
            }
        }
    }
    let numbers = if failed.is_empty() { String::new() } else { format!(" (lines {})", failed.join(", ")) };
    let summary = format!(
        "{} lines: {done} published, {already} published already, {} failed{numbers}",
        lines.len(),
        failed.len()
    );
    if args.json {
        let object = serde_json::json!({"lines": lines.len(), "published": done, "already": already, "failed": failed});
        crate::cli::write_out(&format!("{object}\n"));
    } else if !args.publish.quiet {
        crate::cli::write_out(&format!("{summary}\n"));
    }
    Ok(if failed.is_empty() { 0 } else { Kind::Incomplete.exit_code() })
}

/// A manifest's text and its lines.
///
/// # Errors
/// Environment; usage for a file that is too large or no manifest.
pub fn read(path: &Path) -> Result<(String, Vec<Line>)> {
    let name = path.display().to_string();
    let size = std::fs::metadata(path).map_err(|e| Error::io(path, &e).advice("Check the manifest's path."))?.len();
    if size > LARGEST {
        return Err(Error::usage(&name).expected("a manifest of at most 64 MiB").found(format!("{size} bytes")));
    }
    let text = std::fs::read_to_string(path).map_err(|e| Error::io(path, &e).advice("A manifest is UTF-8 text."))?;
    let lines = parse(&name, &text)?;
    Ok((text, lines))
}

/// Some lines of a manifest as one of their own, each at the number that it had; their photos as seen from anywhere, `base` being
/// the folder of the manifest that they come of.
pub fn write(lines: &[&Line], base: &Path) -> String {
    let row = |cells: &mut dyn Iterator<Item = String>| {
        let quoted: Vec<String> = cells.map(|c| format!("\"{}\"", c.replace('"', "\"\""))).collect();
        quoted.join(",") + "\n"
    };
    let Some(first) = lines.first() else { return "photo\n".into() };
    let mut out = row(&mut first.cells.iter().map(|(column, _)| column.clone()));
    let mut number = 2;
    for line in lines {
        let blank = line.number.saturating_sub(number);
        out.extend(std::iter::repeat_n('\n', blank));
        let text = row(&mut line.cells.iter().map(|(column, cell)| match column.as_str() {
            "photo" => base.join(cell).display().to_string(),
            _ => cell.clone(),
        }));
        number = number.max(line.number) + text.matches('\n').count();
        out += &text;
    }
    out
}

fn one(
    args: &GeoArgs,
    line: &Line,
    base: &Path,
    output: &Path,
    store: Option<&Path>,
    taken: &mut Vec<(String, usize)>,
    stop: &AtomicBool,
) -> End {
    let mut attempt = || -> Result<End> {
        let mut own = args.clone();
        own.manifest = None;
        own.write.cdb = store.map(Path::to_owned);
        let photo = line.apply(&mut own)?;
        let photo = base.join(photo);
        let name = line.name().unwrap_or_default();
        if super::super::format::safe_stem(Path::new(&format!("{name}.x"))) != name {
            return Err(Error::usage("name")
                .expected("letters, digits, _ and -, 24 at most")
                .found(format!("`{name}`")));
        }
        if let Some((_, earlier)) = taken.iter().find(|(n, _)| *n == name) {
            return Err(Error::usage("name")
                .expected("a name of its own")
                .found(format!("`{name}`, which line {earlier} has"))
                .advice("Fill the column `name`."));
        }
        taken.push((name.clone(), line.number));
        let folder = output.join(&name);
        let key = line.key();
        if folder.join("orb-record.dsse.json").is_file() && !own.publish.replace {
            return match published_line(&folder) {
                Some(found) if found == key => Ok(End::Already),
                _ => Err(Error::usage(folder.display().to_string())
                    .expected("a folder of the same line")
                    .found("one that was published from another line, or before this line changed")
                    .advice("Add --replace, or give the line another name.")),
            };
        }
        own.output = Some(folder);
        own.stem = Some(name);
        own.publish.quiet = true;
        own.json = false;
        own.photo = Some(photo);
        publish_one(&own, stop, Some(&key)).map(|_| End::Done)
    };
    attempt().unwrap_or_else(End::Failed)
}

/// The key of the line that a published folder came of, from its record.
fn published_line(folder: &Path) -> Option<String> {
    let bytes = std::fs::read(folder.join("orb-record.dsse.json")).ok()?;
    let envelope = Envelope::parse(&bytes).ok()?;
    let (statement, _) = Statement::parse(&envelope.payload).ok()?;
    match statement.predicate.params.get(LINE_KEY)? {
        Param::Text(key) => Some(key.clone()),
        _ => None,
    }
}

/// A line of the manifest, its cells by their columns' names.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub number: usize,
    cells: Vec<(String, String)>,
    /// More or fewer cells than columns.
    fault: Option<String>,
}

impl Line {
    fn get(&self, column: &str) -> Option<&str> {
        self.cells.iter().find(|(c, v)| c == column && !v.is_empty()).map(|(_, v)| v.as_str())
    }

    /// As it is written there, beside the manifest.
    pub fn photo(&self) -> Option<&str> {
        self.get("photo")
    }

    /// Of the model: its own, else the photo's; none without a photo.
    pub fn name(&self) -> Option<String> {
        let of_photo = || self.photo().map(|p| super::super::format::safe_stem(Path::new(p)));
        self.get("name").map(str::to_owned).or_else(of_photo)
    }

    fn label(&self) -> &str {
        self.get("name").or(self.photo()).unwrap_or("no photo")
    }

    /// Changes when any cell changes.
    fn key(&self) -> String {
        let text: Vec<String> = self.cells.iter().map(|(c, v)| format!("{c}={v}\n")).collect();
        sha256_hex(text.concat().as_bytes())
    }

    /// Fills the options that the line gives; what it leaves empty stays as on the command line. Returns the photo.
    ///
    /// # Errors
    /// Usage: cells without columns, no photo, a cell that is not what its column says.
    pub fn apply(&self, to: &mut GeoArgs) -> Result<PathBuf> {
        if let Some(fault) = &self.fault {
            return Err(Error::usage("line").expected("a cell for each column").found(fault.clone()));
        }
        let number = |column: &str| match self.get(column).map(|t| (t, t.parse::<f64>())) {
            None => Ok(None),
            Some((_, Ok(v))) if v.is_finite() => Ok(Some(v)),
            Some((t, _)) => Err(Error::usage(column).expected("a number").found(format!("`{t}`"))),
        };
        fn choice<T: clap::ValueEnum>(line: &Line, column: &str) -> Result<Option<T>> {
            let Some(text) = line.get(column) else { return Ok(None) };
            T::from_str(text, true).map(Some).map_err(|_| {
                let names: Vec<String> = T::value_variants()
                    .iter()
                    .filter_map(|v| v.to_possible_value())
                    .map(|v| v.get_name().to_owned())
                    .collect();
                Error::usage(column).expected(names.join(" or ")).found(format!("`{text}`"))
            })
        }
        let p = &mut to.place;
        p.origin = self.get("origin").map(str::to_owned).or(p.origin.take());
        p.origin_is = choice(self, "origin_is")?.or(p.origin_is);
        p.alt_datum = choice(self, "alt_datum")?.or(p.alt_datum);
        p.heading = number("heading")?.or(p.heading);
        to.photos.pitch = number("pitch")?.or(to.photos.pitch);
        to.photos.focal = number("focal")?.or(to.photos.focal);
        let s = &mut to.size;
        s.height = number("height")?.or(s.height);
        s.length = number("length")?.or(s.length);
        s.width = number("width")?.or(s.width);
        s.camera_height = number("camera_height")?.or(s.camera_height);
        s.distance = number("distance")?.or(s.distance);
        let w = &mut to.write;
        if let Some(facc) = self.get("facc") {
            w.facc = facc.to_owned();
        }
        w.kind = choice(self, "as")?.unwrap_or(w.kind);
        w.dis = self.get("dis").map(str::to_owned).or(w.dis.take());
        w.material = self.get("material").map(str::to_owned).or(w.material.take());
        if let Some(banner) = self.get("classification") {
            to.publish.marking.classification = Some(banner.to_owned());
        }
        self.photo().map(PathBuf::from).ok_or_else(|| Error::usage("photo").expected("a file").found("an empty cell"))
    }
}

/// RFC 4180: quotes, doubled quotes, line breaks inside quotes; a header first; empty lines and lines that begin with `#`
/// are skipped. Faults of single lines are kept in them.
///
/// # Errors
/// No header, a column that does not exist, no column `photo`.
fn parse(name: &str, text: &str) -> Result<Vec<Line>> {
    let mut rows = rows(text.trim_start_matches('\u{feff}')).into_iter();
    let Some((_, header)) = rows.next() else {
        return Err(Error::usage(name).expected("a header line with the columns' names").found("nothing"));
    };
    let header: Vec<String> = header.iter().map(|h| h.trim().to_ascii_lowercase()).collect();
    if let Some(wrong) = header.iter().find(|h| !COLUMNS.contains(&h.as_str())) {
        return Err(Error::usage(name)
            .expected(format!("columns among {}", COLUMNS.join(", ")))
            .found(format!("`{wrong}`"))
            .advice("The first line of a manifest names its columns."));
    }
    if !header.iter().any(|h| h == "photo") {
        return Err(Error::usage(name).expected("a column `photo`").found(header.join(", ")));
    }
    let line = |(number, cells): (usize, Vec<String>)| {
        let fault =
            (cells.len() != header.len()).then(|| format!("{} cells for {} columns", cells.len(), header.len()));
        let cells = header.iter().cloned().zip(cells.into_iter().map(|c| c.trim().to_owned())).collect();
        Line { number, cells, fault }
    };
    Ok(rows.map(line).collect())
}

/// Rows with the number of their first line.
fn rows(text: &str) -> Vec<(usize, Vec<String>)> {
    let (mut rows, mut row, mut cell) = (Vec::new(), Vec::new(), String::new());
    let (mut quoted, mut line, mut began) = (false, 1, 1);
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' if quoted && chars.peek() == Some(&'"') => {
                chars.next();
                cell.push('"');
            }
            '"' if quoted => quoted = false,
            '"' if cell.trim().is_empty() => {
                quoted = true;
                cell.clear();
            }
            ',' if !quoted => row.push(std::mem::take(&mut cell)),
            '\r' if !quoted && chars.peek() == Some(&'\n') => {}
            '\n' if !quoted => {
                line += 1;
                row.push(std::mem::take(&mut cell));
                rows.push((began, std::mem::take(&mut row)));
                began = line;
            }
            c => {
                line += usize::from(c == '\n');
                cell.push(c);
            }
        }
    }
    if !cell.is_empty() || !row.is_empty() {
        row.push(cell);
        rows.push((began, row));
    }
    let empty = |cells: &[String]| cells.iter().all(|c| c.trim().is_empty());
    rows.retain(|(_, cells)| !empty(cells) && !cells[0].trim_start().starts_with('#'));
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_comments_and_faults_of_single_lines() {
        let text = "\u{feff}photo,origin,heading\r\n# a comment\r\n\"a,\"\"b\"\".jpg\",\"34.5,-118.4,740\",45\r\n\r\nb.jpg,11SLU1234 740\nc.jpg,\"1,2,3\",\n";
        let lines = parse("m.csv", text).unwrap();
        assert_eq!(lines.len(), 3);
        assert_eq!(lines[0].get("photo"), Some("a,\"b\".jpg"));
        assert_eq!((lines[0].number, lines[0].get("origin")), (3, Some("34.5,-118.4,740")));
        assert_eq!(lines[1].fault.as_deref(), Some("2 cells for 3 columns"));
        assert_eq!((lines[2].number, lines[2].get("heading")), (6, None));
        assert_ne!(lines[0].key(), lines[2].key());
    }

    #[test]
    fn lines_keep_their_numbers() {
        let text = "photo,origin\na.jpg,\"1,2,\n3\"\n# no\nb.jpg,\"say \"\"x\"\"\"\n\n/c.jpg,\n";
        let lines = parse("m.csv", text).unwrap();
        let kept: Vec<&Line> = vec![&lines[0], &lines[1], &lines[2]];
        let again = parse("n.csv", &write(&kept, Path::new("/base"))).unwrap();
        let told = |l: &Line| (l.number, l.get("photo").map(str::to_owned), l.get("origin").map(str::to_owned));
        let of = |n, photo: &str, origin: Option<&str>| (n, Some(photo.to_owned()), origin.map(str::to_owned));
        assert_eq!(told(&again[0]), of(2, "/base/a.jpg", Some("1,2,\n3")));
        assert_eq!(told(&again[1]), of(5, "/base/b.jpg", Some("say \"x\"")));
        assert_eq!(told(&again[2]), of(7, "/c.jpg", None));
        let last = parse("n.csv", &write(&kept[2..], Path::new("/base"))).unwrap();
        assert_eq!((last.len(), last[0].number), (1, 7));
        assert_eq!(parse("n.csv", &write(&[], Path::new("/"))).unwrap(), []);
    }

    #[test]
    fn wrong_headers_are_refused() {
        for (text, words) in [("", "nothing"), ("photo,colour\n", "`colour`"), ("name\nx\n", "`photo`")] {
            let e = parse("m.csv", text).unwrap_err().to_string();
            assert!(e.contains(words) && e.contains("m.csv"), "{e}");
        }
    }
}
