//! What has to be answered for, as events of the ledger: `orb audit events` lists them.
//!
//! An act is recorded before it is done, and not done if it cannot be. Refusals are recorded too; since anyone can cause
//! them, those of one kind are counted for a minute and recorded together.

use std::collections::BTreeMap;
use std::sync::Mutex;

use super::lock;
use crate::Result;
use crate::audit::DataFolder;
use crate::audit::events::{self, Happened};
use crate::audit::invocation::{Interface, Invocation};
use crate::audit::report::Report;
use crate::audit::statement::Param;

/// Milliseconds for which refusals of one kind are counted.
const COUNTED_FOR: u64 = 60_000;
/// Kinds of refusals that are counted apart.
const MOST_KINDS: usize = 256;

pub struct Recorder {
    data: DataFolder,
    command: &'static str,
    by: Invocation,
    refused: Mutex<BTreeMap<(String, &'static str), Refused>>,
}

struct Refused {
    since: u64,
    times: i64,
}

impl Recorder {
    pub fn new(data: DataFolder, command: &'static str, by: Invocation) -> Recorder {
        Recorder { data, command, by: Invocation { interface: Interface::Server, ..by }, refused: Mutex::default() }
    }

    pub fn data(&self) -> &DataFolder {
        &self.data
    }

    /// An event of one of [`events::EVENT_TYPES`], before it happens.
    ///
    /// # Errors
    /// As [`events::log`].
    pub fn act(&self, kind: &'static str, about: &[(&str, &str)]) -> Result<()> {
        let mut happened = Happened::new(kind, self.command, self.by.clone());
        for (name, value) in about {
            happened = happened.to(name, *value);
        }
        events::log(&self.data, &happened)
    }

    /// One that came to nothing, and why.
    ///
    /// # Errors
    /// As [`events::log`].
    pub fn failed(&self, kind: &'static str, code: &str, about: &[(&str, &str)]) -> Result<()> {
        let happened = Happened::new(kind, self.command, self.by.clone()).failed(Some(code));
        events::log(&self.data, &about.iter().fold(happened, |h, (name, value)| h.to(name, *value)))
    }

    /// The verdict of a verification.
    pub fn verdict(&self, report: &Report) {
        events::log_verdict(&self.data, self.command, self.by.clone(), report);
    }

    /// A refusal: recorded with the next [`Recorder::flush`].
    pub fn refused(&self, account: &str, code: &'static str, now: u64) {
        let mut refused = lock(&self.refused);
        let key = (account.to_owned(), code);
        let key = if refused.len() < MOST_KINDS || refused.contains_key(&key) { key } else { (String::new(), "MANY") };
        refused.entry(key).or_insert(Refused { since: now, times: 0 }).times += 1;
    }

    /// Records refusals whose minute is over, or all of them. A refusal that cannot be recorded is said on standard error.
    pub fn flush(&self, now: u64, all: bool) {
        let due: Vec<((String, &'static str), i64)> = {
            let mut refused = lock(&self.refused);
            let is_due = |r: &Refused| all || now.saturating_sub(r.since) >= COUNTED_FOR;
            let keys: Vec<_> = refused.iter().filter(|(_, r)| is_due(r)).map(|(k, _)| k.clone()).collect();
            keys.into_iter().filter_map(|k| refused.remove(&k).map(|r| (k, r.times))).collect()
        };
        for ((account, code), times) in due {
            let mut happened = Happened::new("access.refused", self.command, self.by.clone())
                .failed(Some(code))
                .to("account", account);
            happened.params.insert("times".into(), Param::Int(times));
            if let Err(e) = events::log(&self.data, &happened) {
                eprintln!("orb: warning: a refusal was not recorded: {e}");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Ledger;

    #[test]
    fn records_tell_a_server_from_a_command_line() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path());
        events::log(&data, &Happened::new("serve.start", "orb serve", Invocation::default())).unwrap();
        Recorder::new(data.clone(), "orb serve", Invocation::default())
            .act("account.add", &[("account", "jane")])
            .unwrap();
        let chain = Ledger::open(&data).unwrap().read_chain().unwrap();
        let ways: Vec<(&str, &str)> =
            chain.iter().map(|s| (s.predicate.event.kind.as_str(), s.predicate.source.interface.as_str())).collect();
        assert_eq!(ways, [("key.generate", "cli"), ("serve.start", "cli"), ("account.add", "server")]);
    }
}
