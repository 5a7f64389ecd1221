//! `orb serve`: jobs for several people, on a port; and their accounts.

mod database;

use std::ffi::OsString;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::{Args, Subcommand, ValueEnum as _};
use tokio::sync::Semaphore;

use super::device::Device;
use super::key::KeyArgs;
use crate::audit::{Marking, time};
use crate::serve::account::Fingerprint;
use crate::serve::administration::{By, TOKEN_DAYS};
use crate::serve::live::Live;
use crate::serve::place::Place;
use crate::serve::recorder::Recorder;
use crate::serve::role::{Role, Roles};
use crate::serve::runner::{self, Runner};
use crate::serve::session::Sessions;
use crate::serve::tls::{Door, Files};
use crate::serve::viewers::Viewers;
use crate::serve::{Clock, Limits, Server, api};
use crate::view::webgl::Script;
use crate::web::listen;
use crate::{Error, Result};
use database::{DataArgs, Opened};

/// Connections at once.
const CONNECTIONS: usize = 512;
/// At once: submissions taken in, files sent, jobs watched.
const UPLOADS: usize = 4;
const DOWNLOADS: usize = 16;
const STREAMS: usize = 256;
/// Threads that wait for the disk: more than files that are sent at once.
const WAITING: usize = 32;
/// How often refusals are looked at, and the files of revocation lists.
const FLUSH: Duration = Duration::from_secs(1);

/// Serve jobs to several people: a page and an interface for programs on a port. Ends with Ctrl-C; a job that runs then is
/// run again at the next start.
#[derive(Args, Clone, Debug)]
#[command(args_conflicts_with_subcommands = true)]
pub struct ServeArgs {
    #[command(subcommand)]
    verb: Option<Verb>,

    /// Where it listens; port 0 takes a free one.
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8080")]
    bind: SocketAddr,

    #[command(flatten)]
    data: DataArgs,

    /// The highest marking that is taken in and shown: UNCLASSIFIED, CUI, SECRET//NOFORN, … There is no default.
    #[arg(long, value_name = "BANNER", required = true)]
    max_marking: Option<String>,

    /// A name that this server is called by, beside localhost and addresses (may be given several times).
    #[arg(long = "name", value_name = "HOST")]
    names: Vec<String>,

    #[command(flatten)]
    tls: TlsArgs,

    /// What runs and viewers compute on.
    #[arg(long, value_enum, default_value_t)]
    device: Device,

    /// Let viewers draw scenes in the browser too, by the script in this folder: viewer/dist, where `npm ci && npm run build`
    /// in viewer/ builds it.
    #[arg(long, value_name = "FOLDER")]
    webgl: Option<PathBuf>,

    /// Jobs that may wait or run.
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    max_queue: u64,

    /// Megabytes of one photo.
    #[arg(long, value_name = "MB", default_value_t = 64, value_parser = clap::value_parser!(u64).range(1..=256))]
    max_upload: u64,

    /// Megabytes of all files of one submission.
    #[arg(long, value_name = "MB", default_value_t = 512, value_parser = clap::value_parser!(u64).range(1..=65_536))]
    max_submission: u64,

    /// Photos of one submission.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    max_photos: u64,

    /// Megapixels of one photo.
    #[arg(long, value_name = "MP", default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..=1000))]
    max_pixels: u64,

    /// Gigabytes of all jobs together; each publishes up to a few tens of megabytes more than its photo.
    #[arg(long, value_name = "GB", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    max_stored: u64,

    /// Seconds that one run may take.
    #[arg(long, value_name = "SECONDS", default_value_t = 3600, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    max_seconds: u64,

    #[command(flatten)]
    key: KeyArgs,
}

/// What protects tokens and scenes on their way.
#[derive(Args, Clone, Debug)]
struct TlsArgs {
    /// Speak TLS: the server's certificate and those between it and its authority, PEM.
    #[arg(long, value_name = "PEM", requires = "tls_key")]
    tls_cert: Option<PathBuf>,

    /// The certificate's private key, PEM, without a passphrase, for this user's eyes only (mode 0600).
    #[arg(long, value_name = "PEM", requires = "tls_cert")]
    tls_key: Option<PathBuf>,

    /// Answer to those alone who have a certificate of one of these authorities, PEM. They need a token besides, unless the
    /// certificate is bound to an account (`orb serve account bind`).
    #[arg(long, value_name = "PEM", requires = "tls_cert")]
    client_ca: Option<PathBuf>,

    /// Certificates that these authorities revoked, PEM (may be given several times): a list of each authority in a chain. Read
    /// again whenever the files change.
    #[arg(long, value_name = "PEM", requires = "client_ca")]
    client_crl: Vec<PathBuf>,

    /// A TLS proxy on this machine stands before it: browsers send their cookies under TLS alone.
    #[arg(long, conflicts_with = "tls_cert")]
    behind_tls: bool,

    /// Listen beyond this machine without encryption: tokens and scenes can be read on the way.
    #[arg(long)]
    insecure_http: bool,
}

impl TlsArgs {
    fn files(&self) -> Option<Files> {
        let (certificate, key) = (self.tls_cert.clone()?, self.tls_key.clone()?);
        Some(Files { certificate, key, client_ca: self.client_ca.clone(), client_crl: self.client_crl.clone() })
    }

    /// For the ledger.
    fn words(&self) -> &'static str {
        match (self.tls_cert.is_some(), self.behind_tls) {
            (true, _) => "on",
            (false, true) => "proxy",
            (false, false) => "off",
        }
    }
}

#[derive(Subcommand, Clone, Debug)]
enum Verb {
    /// Accounts: there are none until one is added here
    #[command(subcommand)]
    Account(AccountVerb),
    /// Print the OpenAPI document of the interface
    Openapi,
}

#[derive(Subcommand, Clone, Debug)]
enum AccountVerb {
    /// Make an account and print its token, this once
    Add {
        /// Lower case letters, digits, hyphens
        name: String,
        /// What it is for, separated by commas; admin and auditor stand alone
        #[arg(long, value_enum, value_delimiter = ',', required = true)]
        role: Vec<Role>,
        /// Highest marking that it takes part in
        #[arg(long, value_name = "BANNER")]
        ceiling: String,
        /// Days that the token is good for
        #[arg(long, default_value_t = TOKEN_DAYS, value_parser = clap::value_parser!(u32).range(1..=3650))]
        days: u32,
        #[command(flatten)]
        data: DataArgs,
    },
    /// List accounts
    List {
        /// One JSON object
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        data: DataArgs,
    },
    /// Disable an account
    Disable {
        name: String,
        #[command(flatten)]
        data: DataArgs,
    },
    /// Enable an account again, and unlock it
    Enable {
        name: String,
        #[command(flatten)]
        data: DataArgs,
    },
    /// Bind a client certificate to an account: who comes with it is this account, without a token
    Bind {
        name: String,
        /// Its file, PEM, or its SHA-256 in hexadecimal digits
        certificate: String,
        #[command(flatten)]
        data: DataArgs,
    },
    /// Take a client certificate from an account
    Unbind {
        name: String,
        /// Its file, PEM, or its SHA-256 in hexadecimal digits
        certificate: String,
        #[command(flatten)]
        data: DataArgs,
    },
    /// Print another token for an account; the one before is no longer good
    Token {
        name: String,
        /// Days that the token is good for
        #[arg(long, default_value_t = TOKEN_DAYS, value_parser = clap::value_parser!(u32).range(1..=3650))]
        days: u32,
        #[command(flatten)]
        data: DataArgs,
    },
}

/// Runs the verb. `stop` is set by the interrupt handler.
pub fn run(args: &ServeArgs, stop: &AtomicBool) -> Result<u8> {
    match &args.verb {
        None => serve(args, stop),
        Some(Verb::Account(verb)) => account(verb),
        Some(Verb::Openapi) => {
            let json = api::document().to_pretty_json();
            super::write_out(&format!("{}\n", json.map_err(|e| Error::environment("openapi").found(e.to_string()))?));
            Ok(0)
        }
    }
}

fn account(verb: &AccountVerb) -> Result<u8> {
    use AccountVerb::{Add, Bind, Disable, Enable, List, Token, Unbind};
    let (Add { data: args, .. }
    | List { data: args, .. }
    | Disable { data: args, .. }
    | Enable { data: args, .. }
    | Bind { data: args, .. }
    | Unbind { data: args, .. }
    | Token { data: args, .. }) = verb;
    let data = args.folder()?;
    let database = args.database(&Place::open(&data)?)?.database;
    let recorder = Recorder::new(data, "orb serve account", super::argv::caller());
    let now = time::now()?.unix_ms;
    let by = By { database: &database, recorder: &recorder, actor: None, now };
    let text = match verb {
        Add { name, role, ceiling, days, .. } => {
            let roles: Roles = role.clone().try_into()?;
            by.add(name, roles, Marking::parse(ceiling)?, *days)?.to_string()
        }
        Token { name, days, .. } => by.renew(name, *days)?.to_string(),
        Disable { name, .. } => by.disable(name, true).map(|()| format!("{name} is disabled"))?,
        Enable { name, .. } => by.disable(name, false).map(|()| format!("{name} is enabled"))?,
        Bind { name, certificate, .. } => {
            let certificate = fingerprint(certificate)?;
            by.bind(name, &certificate).map(|()| format!("{name} is who comes with {certificate}"))?
        }
        Unbind { name, certificate, .. } => {
            let certificate = fingerprint(certificate)?;
            by.unbind(name, &certificate).map(|()| format!("{certificate} is nobody's"))?
        }
        List { json, .. } => {
            let certificates = database.certificates()?;
            let of = |name: &str| certificates.get(name).map_or(&[][..], Vec::as_slice);
            let told: Vec<_> = database.accounts()?.iter().map(|a| a.told(of(&a.name), now)).collect();
            match json {
                true => serde_json::json!({ "accounts": told }).to_string(),
                false => told.iter().map(line).collect::<Vec<_>>().join("\n"),
            }
        }
    };
    if !text.is_empty() {
        super::write_out(&format!("{text}\n"));
    }
    Ok(0)
}

/// Of a file, or as it is.
fn fingerprint(text: &str) -> Result<Fingerprint> {
    match text.parse() {
        Ok(fingerprint) => Ok(fingerprint),
        Err(_) => crate::serve::tls::fingerprint(std::path::Path::new(text)),
    }
}

fn line(a: &crate::serve::account::Told) -> String {
    let roles: Vec<String> =
        a.roles.iter().filter_map(|r| r.to_possible_value()).map(|v| v.get_name().to_owned()).collect();
    let state = if a.disabled {
        "disabled"
    } else if a.locked {
        "locked"
    } else {
        "enabled"
    };
    let used = a.last_used.as_deref().unwrap_or("never used");
    let certificates = match a.certificates.len() {
        0 => String::new(),
        n => format!("  {n} certificates"),
    };
    format!(
        "{:<20} {:<9} {:<28} {:<16} token until {}  {used}{certificates}",
        a.name,
        state,
        roles.join(","),
        a.ceiling,
        a.token_expires
    )
}

fn serve(args: &ServeArgs, stop: &AtomicBool) -> Result<u8> {
    let ceiling = Marking::parse(args.max_marking.as_deref().unwrap_or_default())?;
    let tls = args.tls.files().map(|files| files.load(&args.names, time::now()?.unix_ms)).transpose()?;
    let script = args.webgl.as_deref().map(Script::load).transpose()?.map(Arc::new);
    if !args.bind.ip().is_loopback() && tls.is_none() && !args.tls.insecure_http {
        return Err(Error::policy("--bind")
            .expected("an address of the loopback, where nobody listens on the way")
            .found(args.bind.ip().to_string())
            .advice("Give --tls-cert and --tls-key, or use ssh -L; --insecure-http does without."));
    }
    let data = args.data.folder()?;
    let place = Place::open(&data)?;
    let _only = place.lock()?;
    let Opened { database, words: kept_in, home } = args.data.database(&place)?;
    database.hold()?;
    place.keep_database(&home)?;
    let clock: Clock = Arc::new(|| time::now().map(|t| t.unix_ms).unwrap_or_default());
    let server = Arc::new(Server {
        database,
        place,
        sessions: Sessions::default(),
        live: Live::default(),
        recorder: Recorder::new(data, "orb serve", super::argv::caller()),
        trail: Default::default(),
        viewers: Viewers::new(args.device, script.clone()),
        limits: Limits {
            queue: args.max_queue,
            queue_each: args.max_queue,
            upload: args.max_upload * 1_000_000,
            submission: args.max_submission * 1_000_000,
            photos: usize::try_from(args.max_photos).unwrap_or(usize::MAX),
            pixels: args.max_pixels * 1_000_000,
            stored: args.max_stored * 1_000_000_000,
            seconds: args.max_seconds,
            ..Limits::default()
        },
        ceiling,
        has_key: args.key.key.is_some(),
        names: args.names.clone(),
        encrypted: tls.is_some() || args.tls.behind_tls,
        tls: tls.is_some(),
        clock,
        counts: Default::default(),
        uploads: Arc::new(Semaphore::new(UPLOADS)),
        downloads: Arc::new(Semaphore::new(DOWNLOADS)),
        streams: Arc::new(Semaphore::new(STREAMS)),
        checks: Arc::new(Semaphore::new(1)),
    });
    runner::recover(&server)?;
    let (runtime, listener, bound) = listen::open(args.bind, WAITING, "Choose another with --bind.")?;
    let banner = server.ceiling.banner();
    let mut about = vec![("max_marking", banner.as_str()), ("tls", args.tls.words()), ("database", kept_in.as_str())];
    if let Some(tls) = &tls {
        tls.warnings.iter().for_each(|w| eprintln!("orb: warning: {w}"));
        about.push(("certificate_sha256", &tls.certificate_sha256));
        about.push(("client_certificates", if tls.clients.is_some() { "required" } else { "not asked for" }));
        about.push(("revocation_lists", if args.tls.client_crl.is_empty() { "none" } else { "read" }));
    }
    let script_sha256 = script.map(|s| s.sha256());
    about.extend(script_sha256.as_deref().map(|sha256| ("webgl_script_sha256", sha256)));
    server.recorder.act("serve.start", &about)?;
    super::write_out(&format!("{banner}\nhttp{}://{bound}/\n", if server.tls { "s" } else { "" }));
    if server.database.accounts()?.is_empty() {
        eprintln!("orb: there are no accounts yet: orb serve account add NAME --role … --ceiling …");
    }
    let runner = Runner { program: program()?, options: options(args)?, secrets: args.data.secrets() };
    std::thread::scope(|threads| {
        threads.spawn(|| runner.work(&server, stop));
        threads.spawn(|| {
            while !stop.load(Ordering::Relaxed) {
                std::thread::sleep(FLUSH);
                server.recorder.flush(server.now(), false);
                if let Some(clients) = tls.as_ref().and_then(|tls| tls.clients.as_ref()) {
                    clients.look(&server);
                }
            }
        });
        let router = api::router(Arc::clone(&server));
        match &tls {
            None => runtime.block_on(listen::serve(listener, listen::Plain, router, stop, CONNECTIONS)),
            Some(tls) => {
                let door = Door::new(tls, Arc::clone(&server));
                runtime.block_on(listen::serve(listener, door, router, stop, CONNECTIONS));
            }
        }
        server.live.call();
        // Ends the connections.
        runtime.shutdown_timeout(Duration::from_secs(1));
    });
    server.recorder.flush(server.now(), true);
    server.recorder.act("serve.stop", &[])?;
    Ok(0)
}

/// This program, as it was started.
fn program() -> Result<PathBuf> {
    std::env::current_exe().map_err(|e| Error::environment("this program").found(e.to_string()))
}

/// What every run is told beside its job's own options; paths as seen from anywhere.
fn options(args: &ServeArgs) -> Result<Vec<OsString>> {
    let mut out = Vec::new();
    let mut say = |option: &str, value: OsString| {
        let mut word = OsString::from(format!("--{option}="));
        word.push(value);
        out.push(word);
    };
    let absolute = |path: &PathBuf| std::path::absolute(path).map_err(|e| Error::io(path, &e));
    if let Some(device) = args.device.to_possible_value() {
        say("device", device.get_name().into());
    }
    let key = &args.key;
    match &key.key {
        // A token's name is no path.
        Some(path) if path.to_string_lossy().starts_with("pkcs11:") => say("key", path.into()),
        Some(path) => say("key", absolute(path)?.into()),
        None => {}
    }
    match &key.key_passphrase {
        Some(super::key::PassphraseSource::File(path)) => {
            let mut word = OsString::from("file:");
            word.push(absolute(path)?);
            say("key-passphrase", word);
        }
        Some(super::key::PassphraseSource::Variable(name)) => say("key-passphrase", format!("env:{name}").into()),
        Some(super::key::PassphraseSource::Prompt) => {
            return Err(Error::usage("--key-passphrase")
                .expected("file:PATH or env:NAME: every run needs it")
                .found("prompt"));
        }
        None => {}
    }
    if let Some(algorithm) = key.algorithm.and_then(|a| a.to_possible_value().map(|v| v.get_name().to_owned())) {
        say("sign-algorithm", algorithm.into());
    }
    if let Some(path) = &key.cert_chain {
        say("cert-chain", absolute(path)?.into());
    }
    if let Some(host) = &key.ntp_server {
        say("ntp-server", host.into());
    }
    Ok(out)
}
