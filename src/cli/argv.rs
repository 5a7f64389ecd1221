//! The command line as records have it: as it was understood, without what may be secret or tell about people.

use std::any::TypeId;
use std::ffi::{OsStr, OsString};

use clap::builder::ValueParser;
use clap::parser::ValueSource;
use clap::{Arg, CommandFactory};

use super::Cli;
use crate::audit::invocation::Invocation;
use crate::audit::record::printable;

/// In place of what is left out.
const LEFT_OUT: &str = "[...]";

/// Who called this process, how, and where it runs, for records.
pub fn caller() -> Invocation {
    Invocation::of_this_process(redacted(std::env::args_os()))
}

/// Options by their long names, in the order in which they were given. A value stands there if it is a number or one of a list
/// that Orb has; of everything else only that it was given: what can be said in free words may be a secret, a name or a place, and
/// events are records that are not marked above UNCLASSIFIED. `None` for a line that is not understood.
pub fn redacted(line: impl IntoIterator<Item = OsString>) -> Option<Vec<String>> {
    let mut command = Cli::command();
    command.build();
    let matches = command.clone().try_get_matches_from(line).ok()?;
    let (mut command, mut matches) = (&command, &matches);
    let mut words = vec![command.get_name().to_owned()];
    loop {
        let mut given: Vec<(usize, Vec<String>)> = Vec::new();
        for arg in command.get_arguments() {
            let id = arg.get_id().as_str();
            if matches.value_source(id) != Some(ValueSource::CommandLine) {
                continue;
            }
            let mut at = matches.indices_of(id).into_iter().flatten();
            if !arg.get_action().takes_values() {
                given.extend(at.map(|i| (i, name(arg).into_iter().collect())));
                continue;
            }
            for values in matches.get_raw_occurrences(id).into_iter().flatten() {
                let values: Vec<String> = values.map(|v| shown(arg, v)).collect();
                let Some(first) = at.next() else { continue };
                // Each value has a place of its own.
                at.by_ref().take(values.len().saturating_sub(1)).for_each(drop);
                let values = if arg.get_value_delimiter().is_some() { vec![values.join(",")] } else { values };
                given.push((first, name(arg).into_iter().chain(values).collect()));
            }
        }
        given.sort();
        words.extend(given.into_iter().flat_map(|(_, words)| words));
        let Some((verb, below)) = matches.subcommand() else { return Some(words) };
        words.push(verb.to_owned());
        (command, matches) = (command.find_subcommand(verb)?, below);
    }
}

/// `--seed`; nothing for what stands without a name.
fn name(arg: &Arg) -> Option<String> {
    let short = || arg.get_short().map(|s| format!("-{s}"));
    arg.get_long().map(|long| format!("--{long}")).or_else(short)
}

fn shown(arg: &Arg, value: &OsStr) -> String {
    match !arg.get_possible_values().is_empty() || is_number(arg.get_value_parser()) {
        true => printable(&value.to_string_lossy()),
        false => LEFT_OUT.to_owned(),
    }
}

fn is_number(parser: &ValueParser) -> bool {
    let id = parser.type_id();
    [
        TypeId::of::<f64>(),
        TypeId::of::<f32>(),
        TypeId::of::<u64>(),
        TypeId::of::<u32>(),
        TypeId::of::<u16>(),
        TypeId::of::<u8>(),
        TypeId::of::<usize>(),
        TypeId::of::<bool>(),
    ]
    .iter()
    .any(|number| id == *number)
}

#[cfg(test)]
mod tests {
    use clap::Command;

    use super::*;

    fn of(line: &str) -> Vec<String> {
        redacted(line.split_whitespace().map(OsString::from)).unwrap_or_else(|| panic!("{line}"))
    }

    #[test]
    fn a_line() {
        assert_eq!(
            of("orb geo /home/jane/van.jpg -o out --seed=7 --format cdb,ply --origin 34.5,-118.4,740 --replace -q"),
            [
                "orb",
                "geo",
                "[...]",
                "--output",
                "[...]",
                "--seed",
                "7",
                "--format",
                "cdb,ply",
                "--origin",
                "[...]",
                "--replace",
                "--quiet"
            ]
        );
        assert_eq!(of("orb audit key trust list"), ["orb", "audit", "key", "trust", "list"]);
        assert_eq!(redacted(["orb", "fly"].map(OsString::from)), None);
    }

    #[test]
    fn secrets_and_people() {
        let key = "pkcs11:token=unit;object=jane?module-path=/usr/lib/softhsm/libsofthsm2.so&pin-value=1234";
        for line in [
            format!("orb geo van.jpg -o out --key {key} --key-passphrase file:/home/jane/hunter2"),
            "orb audit keygen -o unit.pem --passphrase env:hunter2".into(),
            "orb geo van.jpg -o out --classified-by jane --derived-from jane --declassify-on 20300101".into(),
            "orb geo van.jpg -o out --raise-reason jane --ntp-server jane.example".into(),
        ] {
            let words = of(&line).join(" ");
            for secret in ["jane", "hunter2", "1234", "libsofthsm2", "2030"] {
                assert!(!words.contains(secret), "{secret} in {words}");
            }
            assert!(words.contains("[...]"), "{words}");
        }
    }

    /// What is not from a list and no number is left out, whatever option it is of.
    #[test]
    fn every_option_of_every_verb() {
        fn each(command: &Command, seen: &mut usize) {
            for arg in command.get_arguments().filter(|a| a.get_action().takes_values()) {
                let word = shown(arg, OsStr::new("/home/jane/secret"));
                let is_listed = !arg.get_possible_values().is_empty() || is_number(arg.get_value_parser());
                assert!(is_listed || word == LEFT_OUT, "{arg:?}: {word}");
                *seen += 1;
            }
            command.get_subcommands().for_each(|c| each(c, seen));
        }
        let mut command = Cli::command();
        command.build();
        let mut seen = 0;
        each(&command, &mut seen);
        assert!(seen > 100, "{seen}");
    }
}
