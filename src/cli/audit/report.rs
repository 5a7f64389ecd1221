//! `orb audit report`: a verification as a document, signed and recorded where that is asked for.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::Outcome;
use super::ledger::ledger_path;
use crate::audit::disk::{self, Disk};
use crate::audit::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use crate::audit::evidence::{Evidence, to_html, to_junit, to_markdown, to_sarif};
use crate::audit::ledger_check::{LedgerRequest, verify_ledger};
use crate::audit::marking::handling::Handling;
use crate::audit::publication::RECORD;
use crate::audit::report::Report;
use crate::audit::statement::{Input, Param, Statement};
use crate::audit::trust::{self, CertChain};
use crate::audit::verify::{Request, changed, check_same, read_record, verify};
use crate::audit::{DataFolder, Ledger, Marking, Policy, TrustStore, allowed, events, ledger, record, time};
use crate::cli::argv;
use crate::cli::sealed::{Evidence as Sealing, PublishArgs, SealedRun};
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct ReportArgs {
    /// The folder that Orb published; this user's ledger unless given
    pub folder: Option<PathBuf>,
    /// The report's file, or with --sign its folder; it must not exist
    #[arg(short, long, value_name = "PATH")]
    pub output: PathBuf,
    /// The report's form
    #[arg(long, value_enum, default_value_t = Form::Html)]
    pub format: Form,
    /// Also check that the result was made from this file (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub input: Vec<PathBuf>,
    /// A checkpoint of the ledger that was kept elsewhere (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Vec<PathBuf>,
    /// Refuse records made with other network weights than this file lists, a SHA-256 a line (exit 4)
    #[arg(long, value_name = "FILE")]
    pub models: Option<PathBuf>,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
    /// Date the report YYYY-MM-DDTHH:MM:SS.mmmZ and judge times by that, so that it can be made again byte for byte
    #[arg(long, value_name = "UTC")]
    pub as_of: Option<String>,
    /// Publish the report in every form as a folder that is marked, signed and recorded like a product: `orb audit verify`
    /// checks it. The options below are for this
    #[arg(long, conflicts_with = "format")]
    pub sign: bool,
    #[command(flatten)]
    pub publish: PublishArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    Html,
    Markdown,
    Json,
    /// The findings as SARIF 2.1.0
    Sarif,
    /// The findings as JUnit XML
    Junit,
}

/// What a report is made of.
struct Verified {
    report: Report,
    records: Vec<Statement>,
    as_of_ms: u64,
    /// What was verified, as an input of a signed report.
    read: Option<Input>,
    trust: TrustStore,
    chains: Vec<CertChain>,
    allowed: Option<Vec<String>>,
}

/// Writes the report. The exit code is the verification's.
pub fn run(args: &ReportArgs, data: &DataFolder) -> Result<Outcome> {
    let PublishArgs { replace, marking, key, .. } = &args.publish;
    if !args.sign && (*replace || marking.classification.is_some() || key.key.is_some() || key.ntp_server.is_some()) {
        return Err(Error::usage("--replace, --classification, --key, --ntp-server").expected("--sign beside them"));
    }
    let verified = verified(args, data)?;
    if args.sign {
        return sign(args, data, verified);
    }
    let text = written(args.format, args, &verified)?;
    Disk::default().write_new(&args.output, text.as_bytes())?;
    events::log_verdict(data, "orb audit report", argv::caller(), &verified.report);
    Ok(Outcome { text: format!("{}\n", args.output.display()), exit_code: verified.report.exit_code })
}

fn verified(args: &ReportArgs, data: &DataFolder) -> Result<Verified> {
    let as_of_ms = match &args.as_of {
        None => time::now()?.unix_ms,
        Some(text) => time::parse_utc(text).ok_or_else(|| {
            Error::usage("--as-of").expected("a time like 2026-11-21T08:00:00.000Z").found(format!("{text:?}"))
        })?,
    };
    let trust = TrustStore::load(data, &args.trust_key)?;
    let allowed = args.models.as_deref().map(allowed::read).transpose()?;
    let policy = Policy { models: allowed.as_deref(), ..Policy::default() };
    if let Some(folder) = &args.folder {
        let request = Request { inputs: &args.input, policy, ..Request::new(folder, &trust, as_of_ms) };
        let (report, (envelope, statement)) = (verify(&request)?, read_record(folder)?);
        check_same(folder, &report, &envelope)?;
        let (path, records) = (folder.join(RECORD), vec![statement]);
        let bytes = disk::read_limited(&path, MAX_ENVELOPE_BYTES as u64)?;
        if !Envelope::parse(&bytes).is_ok_and(|again| again == envelope) {
            return Err(changed(&path, report.trail_hash.as_deref().unwrap_or_default()));
        }
        let read = Some(record::input(RECORD, &bytes, "application/json", "record", None));
        let chains = trust::chains_in(folder)?;
        return Ok(Verified { report, records, as_of_ms, read, trust, chains, allowed });
    }
    let ledger = ledger_path(None, data);
    let request = LedgerRequest {
        ledger: &ledger,
        trust: &trust,
        checkpoints: &args.checkpoint,
        require_anchor: false,
        now_ms: as_of_ms,
        strict: false,
        policy,
    };
    // Before it is read for its records: what is appended meanwhile is no part of this.
    let read = match args.sign {
        false => None,
        true => {
            let (size, sha256) = disk::hash_file(&ledger).map_err(|e| Error::io(&ledger, &e))?;
            let like = record::input("orb-ledger.jsonl", b"", "application/jsonl", "ledger", None);
            Some(Input { size, sha256, ..like })
        }
    };
    // A chain that is broken has no facts to show beside its findings.
    let (report, records) = (verify_ledger(&request)?, Ledger::at(ledger.clone()).read_chain().unwrap_or_default());
    let records = verified_part(records, &report, &ledger)?;
    let chains = trust::chains_in(&ledger::chains_beside(&ledger))?;
    Ok(Verified { report, records, as_of_ms, read, trust, chains, allowed })
}

/// The records that were verified, of those that were read apart: what was appended meanwhile is no part of the report. In a
/// chain, where the last one is the same, all are.
fn verified_part(mut records: Vec<Statement>, report: &Report, ledger: &Path) -> Result<Vec<Statement>> {
    let (Some(range), Some(verified)) = (report.range, &report.trail_hash) else { return Ok(records) };
    records.truncate(usize::try_from(range.last).map_or(usize::MAX, |last| last.saturating_add(1)));
    match records.last() {
        Some(last) if last.predicate.trail_hash.as_ref() != Some(verified) => Err(changed(ledger, verified)),
        _ => Ok(records),
    }
}

fn written(form: Form, args: &ReportArgs, verified: &Verified) -> Result<String> {
    let Verified { report, records, as_of_ms, trust, chains, allowed, .. } = verified;
    let (folder, allowed) = (args.folder.as_deref(), allowed.as_deref());
    let evidence = Evidence { report, records, folder, trust, chains, allowed, as_of_ms: *as_of_ms };
    Ok(match form {
        Form::Html => to_html(&evidence)?,
        Form::Markdown => to_markdown(&evidence)?,
        Form::Json => format!("{}\n", report.to_json()),
        Form::Sarif => to_sarif(report),
        Form::Junit => to_junit(report),
    })
}

/// Publishes the report like a product: its own record says what was verified, with which verdict, and who signed that.
fn sign(args: &ReportArgs, data: &DataFolder, mut verified: Verified) -> Result<Outcome> {
    const COMMAND: &str = "orb audit report";
    let handling = handling(args, &verified)?;
    if let Some(read) = &mut verified.read {
        read.marking.clone_from(&verified.report.marking);
    }
    let params = params(&verified);
    // The report is marked as a whole, and that may be above what it is about.
    verified.report.marking = Some(handling.marking.banner());
    let mut run = SealedRun::begin_in(data.clone(), COMMAND, &args.output, handling, &args.publish)?;
    for (name, form, media_type) in [
        ("report.html", Form::Html, "text/html"),
        ("report.json", Form::Json, "application/json"),
        ("report.md", Form::Markdown, "text/markdown"),
    ] {
        run.publication.add(name, written(form, args, &verified)?.as_bytes(), media_type, "report")?;
    }
    events::log_verdict(data, COMMAND, argv::caller(), &verified.report);
    let published = run.seal(Sealing {
        event_type: "report.publish",
        time: time::now()?,
        inputs: verified.read.into_iter().collect(),
        models: Vec::new(),
        params,
    })?;
    let folder = published.folder.display();
    let text = format!("{folder}\n  signed by {}\n  Check it: orb audit verify {folder}\n", published.signed_by);
    Ok(Outcome { text, exit_code: verified.report.exit_code })
}

/// The report's marking: never below that of the records it shows.
fn handling(args: &ReportArgs, verified: &Verified) -> Result<Handling> {
    let Some(banner) = &verified.report.marking else {
        return Err(Error::policy("--sign")
            .expected("records that a trusted key signed: the report takes their marking")
            .found("MARKING_UNKNOWN: none")
            .advice("Get the signer's public key from the signer and name it with --trust-key, or write the report without --sign."));
    };
    let (inputs, utc) = ([Some(Marking::read(banner)?)], time::now()?.utc());
    match (&args.folder, verified.records.as_slice()) {
        (Some(_), [record]) => args.publish.marking.decide_like(&record.predicate.marking, &inputs, &utc),
        _ => args.publish.marking.decide(&inputs, &utc),
    }
}

/// The verdict, and of what.
fn params(verified: &Verified) -> BTreeMap<String, Param> {
    let Report { verdict, exit_code, ledger_id, range, anchored_through, trust_store_sha256, trail_hash, .. } =
        &verified.report;
    let number = |n: u64| i64::try_from(n).ok().map(Param::Int);
    let text = |t: &Option<String>| t.clone().map(Param::Text);
    let all = [
        ("verdict", Some(Param::Text(format!("{verdict:?}").to_lowercase()))),
        ("exit_code", Some(Param::Int((*exit_code).into()))),
        ("as_of", Some(Param::Text(time::format_utc(verified.as_of_ms)))),
        ("trust_store_sha256", Some(Param::Text(trust_store_sha256.clone()))),
        ("ledger_id", text(ledger_id)),
        // Not by the name that the record has for its own.
        ("verified_trail_hash", text(trail_hash)),
        ("first_record", range.and_then(|r| number(r.first))),
        ("last_record", range.and_then(|r| number(r.last))),
        ("anchored_through", anchored_through.and_then(number)),
    ];
    all.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?))).collect()
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use serde_json::json;

    use super::super::export::{self, ExportArgs};
    use super::*;
    use crate::audit::by_hand;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::publication::tests::publish;
    use crate::audit::verify::tests::forge;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        args: ReportArgs,
    }

    #[derive(Parser)]
    struct Export {
        #[command(flatten)]
        args: ExportArgs,
    }

    #[test]
    fn a_folder_and_a_ledger_as_documents_and_exports() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let data = DataFolder::at(dir.path().join("data"));
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let (out, key) = (path("out"), path("out/orb-record.pub.pem"));
        let report = |file: &str, more: &[&str]| {
            let file = path(file);
            let words = [&["report", "-o", &file, "--trust-key", &key], more].concat();
            run(&Line::try_parse_from(words).unwrap().args, &data)
                .map(|done| (done, std::fs::read_to_string(file).unwrap()))
        };
        let as_of = ["--as-of", "2026-01-01T00:00:00.000Z"];
        let (done, html) = report("a.html", &[&[out.as_str()], &as_of[..]].concat()).unwrap();
        assert!(done.exit_code == 0 && html.contains("Verify again, without Orb"), "{}", done.text);
        let (_, again) = report("b.html", &[&[out.as_str()], &as_of[..]].concat()).unwrap();
        assert_eq!(html, again);
        let (done, text) = report("ledger.md", &["--format", "markdown"]).unwrap();
        assert!(done.exit_code == 0 && text.contains("1 records verified"), "{text}");
        for (form, word) in [("sarif", "\"version\":\"2.1.0\""), ("junit", "failures=\"0\"")] {
            assert!(report(form, &[&out, "--format", form]).unwrap().1.contains(word));
        }
        assert_eq!(report("a.html", &[&out]).unwrap_err().expected, "a new file");
        assert_eq!(report("c.html", &["--as-of", "today"]).unwrap_err().kind, crate::Kind::Usage);

        let export = |system: &str| {
            let file = path(&format!("{system}.json"));
            let words = ["export", &out, "--for", system, "-o", &file, "--trust-key", &key];
            let done = export::run(&Export::try_parse_from(words).unwrap().args, &data).unwrap();
            (done.exit_code, std::fs::read_to_string(file).ok())
        };
        for system in ["oscal", "slsa", "civium"] {
            let (code, text) = export(system);
            assert_eq!(code, 0);
            serde_json::from_str::<serde_json::Value>(&text.unwrap()).unwrap();
            std::fs::remove_file(path(&format!("{system}.json"))).unwrap();
        }
        std::fs::write(dir.path().join("out/scene.ply"), "changed").unwrap();
        assert_eq!(export("oscal"), (1, None), "nothing is exported that does not verify");
    }

    /// `--models`: a list with the network that ran, one without it, and files that are no lists.
    #[test]
    fn a_report_against_a_list_of_networks() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let data = DataFolder::at(dir.path().join("data"));
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let (out, key) = (path("out"), path("out/orb-record.pub.pem"));
        let report = |what: &[&str], list: &str| {
            std::fs::write(path("list.txt"), list).unwrap();
            let (file, list) = (path("report.md"), path("list.txt"));
            let _ = std::fs::remove_file(&file);
            let words = ["report", "-o", &file, "--trust-key", &key, "--format", "markdown", "--models", &list];
            run(&Line::try_parse_from([&words, what].concat()).unwrap().args, &data)
                .map(|done| (done.exit_code, std::fs::read_to_string(file).unwrap()))
        };
        let used = crate::audit::canonical::sha256_hex(b"w");
        let other = crate::audit::canonical::sha256_hex(b"v");
        for what in [&[out.as_str()][..], &[]] {
            let (exit_code, text) = report(what, &format!("{other}  other.rten\n{used}  scene.rten\n")).unwrap();
            assert!(exit_code == 0 && text.contains("| scene | ran | yes |"), "{what:?}: {text}");
            assert!(!text.contains("MODEL") && text.contains("| colmap | not-used |  |"), "{what:?}: {text}");
            let (exit_code, text) = report(what, &other).unwrap();
            assert!(exit_code == 4 && text.contains("MODEL\\_NOT\\_ALLOWED"), "{what:?}: {text}");
            assert!(text.contains("| scene | ran | no |") && text.contains("REFUSED"), "{what:?}: {text}");
            let error = report(what, &format!("{used}\nscene.rten\n")).unwrap_err();
            assert!(error.subject.ends_with("list.txt, line 2") && error.kind == crate::Kind::Usage, "{error}");
            assert_eq!(error.found, "\"scene.rten\"");
            assert!(error.expected.contains("64 hexadecimal digits") && !dir.path().join("report.md").exists());
        }
    }

    /// A signed report is a product: it verifies, with Orb and without, and one byte less or another marking does not.
    #[test]
    fn signed_reports() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let data = DataFolder::at(dir.path().join("data"));
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let (out, key) = (path("out"), path("out/orb-record.pub.pem"));
        let report = |to: &str, more: &[&str]| {
            let to = path(to);
            let words = [&["report", "--sign", "-q", "-o", &to, "--trust-key", &key], more].concat();
            run(&Line::try_parse_from(words).unwrap().args, &data)
        };
        let made = report("signed", &[&out]).unwrap();
        assert!(made.exit_code == 0 && made.text.contains("orb audit verify"), "{}", made.text);
        let signed = dir.path().join("signed");
        let (_, statement) = read_record(&signed).unwrap();
        let p = &statement.predicate;
        assert_eq!((p.event.kind.as_str(), &p.params["verdict"]), ("report.publish", &Param::Text("pass".into())));
        let record = std::fs::read(dir.path().join("out").join(RECORD)).unwrap();
        assert_eq!(p.inputs[0].sha256, crate::audit::canonical::sha256_hex(&record));
        let names: Vec<&str> = statement.subject.iter().map(|s| s.name.as_str()).collect();
        assert_eq!(names, ["orb-marking.json", "report.html", "report.json", "report.md"]);

        // By the user's own key, which the data folder trusts.
        let trust = TrustStore::load(&data, &[]).unwrap();
        let input = [dir.path().join("out").join(RECORD)];
        let check = || {
            let request = Request { inputs: &input, ..Request::new(&signed, &trust, time::now().unwrap().unix_ms) };
            let report = verify(&request).unwrap();
            let errors = report.findings.iter().filter(|f| f.severity == crate::audit::report::Severity::Error);
            (report.exit_code, errors.map(|f| f.code).collect::<Vec<_>>())
        };
        assert_eq!(check(), (0, vec![]));
        let commands = by_hand::openssl_commands(&signed, by_hand::Beside { inputs: &input, store: None }).unwrap();
        let done = std::process::Command::new("sh").args(["-e", "-c", &commands]).output().unwrap();
        assert!(done.status.success() && String::from_utf8_lossy(&done.stdout).contains("report.html: OK"), "{done:?}");
        for name in ["report.html", "report.json", "report.md"] {
            let file = signed.join(name);
            let whole = std::fs::read(&file).unwrap();
            let mut bytes = whole.clone();
            bytes[whole.len() / 2] ^= 1;
            std::fs::write(&file, &bytes).unwrap();
            assert_eq!(check(), (1, vec!["OUTPUT_DIGEST"]), "{name}");
            std::fs::write(&file, whole).unwrap();
        }
        let (file, envelope) = (signed.join(RECORD), std::fs::read_to_string(signed.join(RECORD)).unwrap());
        let at = envelope.find("\"payload\":\"").unwrap() + 1000;
        let other = if envelope.as_bytes()[at] == b'A' { "B" } else { "A" };
        std::fs::write(&file, format!("{}{other}{}", &envelope[..at], &envelope[at + 1..])).unwrap();
        assert!(check().0 == 1 && check().1.contains(&"SIG_INVALID"), "{:?}", check());
        std::fs::write(&file, envelope).unwrap();

        // The ledger, after all that.
        report("of-ledger", &[]).unwrap();
        let (_, statement) = read_record(&dir.path().join("of-ledger")).unwrap();
        assert_eq!(statement.predicate.inputs[0].role, "ledger");
        assert!(events::list(&ledger_path(None, &data)).unwrap().contains("report.publish     success"));
    }

    /// The records of a ledger's report are those that its verification saw.
    #[test]
    fn a_ledger_that_grows_or_is_exchanged_meanwhile() {
        use crate::audit::publication::tests::{destination, fill, ledger};
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let mut trust = TrustStore::default();
        trust.insert(shared_key().public().clone());
        let path = ledger(dir.path()).path().to_path_buf();
        let request = LedgerRequest {
            ledger: &path,
            trust: &trust,
            checkpoints: &[],
            require_anchor: false,
            now_ms: 1_763_700_000_000,
            strict: false,
            policy: Policy::default(),
        };
        let report = verify_ledger(&request).unwrap();
        let mut publication = crate::audit::Publication::begin(&destination(&dir.path().join("more"))).unwrap();
        fill(&mut publication).unwrap();
        publication.seal(&record::tests::draft(), shared_key(), &mut ledger(dir.path())).unwrap();
        let records = ledger(dir.path()).read_chain().unwrap();
        let kept = verified_part(records.clone(), &report, &path).unwrap();
        assert_eq!((records.len(), kept), (2, records[..1].to_vec()));
        let other = Report { trail_hash: Some("0".repeat(64)), ..report };
        assert!(verified_part(records, &other, &path).unwrap_err().found.contains("changed while it was read"));
        assert!(verified_part(Vec::new(), &other, &path).unwrap().is_empty(), "a broken chain has no facts to show");
    }

    /// A report takes the marking of what it shows, its blocks too, and is signed by a key that may sign that.
    #[test]
    fn marked_reports() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("data"));
        publish(dir.path());
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let (out, key, named) = (path("out"), path("out/orb-record.pub.pem"), path("unit.pem"));
        shared_key().save(&dir.path().join("unit.pem"), None).unwrap();
        let report = |to: &str, more: &[&str]| {
            let to = path(to);
            let words = [&["report", &out, "-o", &to, "--trust-key", &key], more].concat();
            run(&Line::try_parse_from(words).unwrap().args, &data)
        };
        let found = |result: Result<Outcome>| result.unwrap_err().found;
        assert_eq!(report("x", &["--key", &named]).unwrap_err().expected, "--sign beside them");
        let raised = ["--sign", "-q", "--classification", "CUI", "--key", &named];
        assert!(found(report("a", &raised)).starts_with("MARKING_REASON_REQUIRED"));
        report("b", &[&raised[..], &["--raise-reason", "names of people"]].concat()).unwrap();
        let html = std::fs::read_to_string(dir.path().join("b/report.html")).unwrap();
        assert_eq!((html.matches(">CUI</div>").count(), html.matches(">CUI</text>").count()), (2, 2));
        let json = std::fs::read_to_string(dir.path().join("b/report.json")).unwrap();
        assert!(json.contains("\"marking\":\"CUI\""), "{json}");

        // Another banner in the page than in the record is found, also where the digest would be right.
        let cui = crate::audit::inband::marking("report.html", html.as_bytes()).unwrap().unwrap();
        assert_eq!(cui.banner(), "CUI");
        assert!(crate::audit::inband::mismatch("report.html", html.as_bytes(), &Marking::UNCLASSIFIED).is_some());

        // A classified record's blocks go with its report; without a named key there is none.
        let authority = json!({"classified_by": "J. Doe, analyst", "derived_from": "Guide, Agency, 20240105",
            "declassify_on": "20400101", "date_of_origin": "20251121"});
        forge(&dir.path().join("out"), shared_key(), |v| {
            v["predicate"]["marking"] =
                json!({"profile": "dod", "banner": "SECRET", "ism": {"classification": "S"}, "authority": authority});
        });
        let refused = found(report("c", &["--sign", "-q"]));
        assert!(refused.starts_with("KEY_REQUIRED"), "{refused}");
        let lowered = ["--sign", "-q", "--key", &named, "--classification", "CUI"];
        assert!(found(report("d", &lowered)).starts_with("MARKING_DOWNGRADE"));
        let made = report("e", &["--sign", "-q", "--key", &named]).unwrap();
        assert_eq!(made.exit_code, 1, "the forged record's outputs are marked otherwise");
        let marking = &read_record(&dir.path().join("e")).unwrap().1.predicate.marking;
        assert_eq!((marking.banner.as_str(), marking.inputs_join.as_deref()), ("SECRET", Some("SECRET")));
        assert_eq!(marking.authority.as_ref().unwrap().derived_from, "Guide, Agency, 20240105");

        // Of what nobody trusted signed, no marking is known.
        let stranger = DataFolder::at(dir.path().join("stranger"));
        let to = path("f");
        let line = Line::try_parse_from(["report", &out, "-o", &to, "--sign"]).unwrap();
        assert!(run(&line.args, &stranger).unwrap_err().found.starts_with("MARKING_UNKNOWN"));
        assert!(!dir.path().join("f").exists() && !dir.path().join("a").exists() && !dir.path().join("d").exists());
    }
}
