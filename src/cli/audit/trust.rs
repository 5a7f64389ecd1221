//! `orb audit key trust`: whose signatures count for this user.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use serde_json::json;

use super::Outcome;
use crate::audit::events::{self, Happened};
use crate::audit::trust::{self, Added, Entry, Reason, Revocation, SCHEMA};
use crate::audit::{DataFolder, TrustStore, time};
use crate::cli::argv;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct KeyVerbArgs {
    #[command(subcommand)]
    pub verb: KeyVerb,
}

#[derive(Debug, Subcommand)]
pub enum KeyVerb {
    /// Whose signatures count: public keys, authorities, revocation lists
    Trust(TrustArgs),
}

#[derive(Debug, Args)]
pub struct TrustArgs {
    #[command(subcommand)]
    pub verb: TrustVerb,
}

#[derive(Debug, Subcommand)]
pub enum TrustVerb {
    /// Trust a public key, an authority's certificate or a revocation list (PEM); again, to say something else of it
    Add(AddArgs),
    /// List what is trusted
    List(ListArgs),
    /// Trust a key no longer, from a time on
    Revoke(RevokeArgs),
}

#[derive(Debug, Args)]
pub struct AddArgs {
    /// PUBLIC KEY, CERTIFICATE of an authority, or X509 CRL, as PEM
    pub file: PathBuf,
    /// Whose it is
    #[arg(long, value_name = "TEXT")]
    pub name: Option<String>,
    /// Refuse records dated before (YYYY-MM-DDTHH:MM:SS.mmmZ)
    #[arg(long, value_name = "UTC")]
    pub not_before: Option<String>,
    /// Refuse records dated after
    #[arg(long, value_name = "UTC")]
    pub not_after: Option<String>,
    /// The highest marking that the key may sign
    #[arg(long, value_name = "BANNER")]
    pub max_marking: Option<String>,
    /// Of an authority: the extended key usage that its signers' certificates must have where they have any (default
    /// document signing, 1.3.6.1.5.5.7.3.36)
    #[arg(long, value_name = "OID")]
    pub eku: Option<String>,
}

#[derive(Debug, Args)]
pub struct ListArgs {
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct RevokeArgs {
    /// The key's fingerprint, as `list` prints it
    pub fingerprint: String,
    /// Why. After a compromise only signatures count that a trusted time stamp proves to be older
    #[arg(long, value_enum)]
    pub reason: Reason,
    /// From when on (YYYY-MM-DDTHH:MM:SS.mmmZ); now unless given
    #[arg(long, value_name = "UTC")]
    pub from: Option<String>,
}

pub fn run(args: &KeyVerbArgs, data: &DataFolder) -> Result<Outcome> {
    let KeyVerb::Trust(TrustArgs { verb }) = &args.verb;
    match verb {
        TrustVerb::Add(args) => add(args, data),
        TrustVerb::List(args) => list(args, data),
        TrustVerb::Revoke(args) => revoke(args, data),
    }
}

fn add(args: &AddArgs, data: &DataFolder) -> Result<Outcome> {
    let AddArgs { file, name, not_before, not_after, max_marking, eku } = args;
    let entry = Entry {
        schema: SCHEMA.into(),
        name: name.clone(),
        not_before: not_before.clone(),
        not_after: not_after.clone(),
        max_marking: max_marking.clone(),
        eku: eku.clone(),
        revoked: None,
        with: None,
    };
    let added = trust::add_file(data, file, &entry)?;
    let happened = Happened::new("key.trust", "orb audit key trust add", argv::caller());
    let happened = match &added {
        Added::Key(fingerprint) => happened.to("key_fingerprint", fingerprint),
        Added::Pair(first, second) => happened.to("key_fingerprint", first).to("second_key_fingerprint", second),
        Added::Authority(sha256) => happened.to("certificate_sha256", sha256),
        Added::Crl(sha256) => happened.to("crl_sha256", sha256),
    };
    events::log(data, &happened)?;
    let text = match added {
        Added::Key(fingerprint) => format!(
            "trusted: key, SPKI SHA-256 {fingerprint}\n  Compare it with what the signer told you by another way.\n"
        ),
        Added::Pair(first, second) => format!(
            "trusted: two keys that count together only, SPKI SHA-256\n  {first}\n  {second}\n  \
             Compare them with what the signer told you by another way.\n"
        ),
        Added::Authority(sha256) => format!(
            "trusted: authority, certificate SHA-256 {sha256}\n  Compare it with what the authority publishes.\n"
        ),
        Added::Crl(sha256) => format!("added: revocation list, SHA-256 {sha256}\n"),
    };
    Ok(Outcome { text, exit_code: 0 })
}

fn list(args: &ListArgs, data: &DataFolder) -> Result<Outcome> {
    let store = TrustStore::load(data, &[])?;
    if args.json {
        let keys = store
            .keys()
            .map(|(key, entry)| json!({"fingerprint": key.fingerprint(), "kind": key.kind(), "entry": entry}));
        let authorities =
            store.authorities().map(|a| json!({"sha256": a.sha256(), "subject": a.subject, "entry": a.entry}));
        let value = json!({
            "schema": "orb.trust-list/v1",
            "trust_store_sha256": store.sha256(),
            "keys": keys.collect::<Vec<_>>(),
            "authorities": authorities.collect::<Vec<_>>(),
            "revocation_lists": store.crls().collect::<Vec<_>>(),
        });
        return Ok(Outcome { text: format!("{value}\n"), exit_code: 0 });
    }
    let mut text = format!("trust store {}\n", store.sha256());
    for (key, entry) in store.keys() {
        text.push_str(&format!("key {}  {}\n{}", key.fingerprint(), key.kind(), said(entry)));
    }
    for authority in store.authorities() {
        text.push_str(&format!("authority {}  {}\n{}", authority.sha256(), authority.subject, said(&authority.entry)));
    }
    for sha256 in store.crls() {
        text.push_str(&format!("revocation list {sha256}\n"));
    }
    Ok(Outcome { text, exit_code: 0 })
}

fn said(entry: &Entry) -> String {
    let revoked = entry.revoked.as_ref().map(|r| format!("from {}, {:?}", r.from, r.reason).to_lowercase());
    let parts = [
        ("name", entry.name.clone()),
        ("not before", entry.not_before.clone()),
        ("not after", entry.not_after.clone()),
        ("up to", entry.max_marking.clone()),
        ("usage", entry.eku.clone()),
        ("only with", entry.with.clone()),
        ("REVOKED", revoked),
    ];
    parts.into_iter().filter_map(|(name, value)| Some(format!("    {name:<11}{}\n", value?))).collect()
}

fn revoke(args: &RevokeArgs, data: &DataFolder) -> Result<Outcome> {
    let from = match &args.from {
        Some(text) => text.clone(),
        None => time::now()?.utc(),
    };
    if time::parse_utc(&from).is_none() {
        return Err(Error::usage("--from").expected("a time like 2026-11-21T08:00:00.000Z").found(format!("{from:?}")));
    }
    let revocation = Revocation { from: from.clone(), reason: args.reason };
    trust::check_revoke(data, &args.fingerprint, &revocation)?;
    // Said before it takes effect: this user's own key may be the one.
    let revoked = Happened::new("key.revoke", "orb audit key trust revoke", argv::caller());
    let reason = format!("{:?}", args.reason).to_lowercase();
    let revoked = revoked.to("key_fingerprint", &args.fingerprint).to("from", &from).to("reason", reason);
    events::log(data, &revoked)?;
    trust::revoke(data, &args.fingerprint, revocation)?;
    Ok(Outcome { text: format!("revoked from {from}: {}\n", args.fingerprint), exit_code: 0 })
}
