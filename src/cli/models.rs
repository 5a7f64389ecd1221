//! `orb models`: import networks, list them, check them, remove them. Offline: nothing is fetched.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::audit::Outcome;
use super::networks::{EngineArgs, registry};
use crate::audit::events::{self, Happened};
use crate::audit::statement::Model;
use crate::audit::{DataFolder, record};
use crate::models::registry::catalogue::{Catalogue, DepthKind};
use crate::models::registry::{Import, Manifest, Registry, import};
use crate::{Error, Result};

#[derive(Args, Clone, Debug)]
pub struct ModelsArgs {
    #[command(subcommand)]
    pub verb: ModelsVerb,
}

#[derive(Subcommand, Clone, Debug)]
pub enum ModelsVerb {
    /// Take a network's files into the data folder: hashed, checked against what Orb can run, loaded once
    Import(ImportArgs),
    /// The networks that were imported
    List(ListArgs),
    /// Hash every file again; exit code 1 names one that changed
    Verify(OneArgs),
    /// Everything about a network
    Show(ShowArgs),
    /// Remove a network's files
    Remove(RemoveArgs),
}

#[derive(Args, Clone, Debug)]
pub struct ImportArgs {
    /// ONNX files, a folder or a ZIP archive; all of one network
    #[arg(required = true, value_name = "FILE|DIR|ZIP")]
    pub sources: Vec<PathBuf>,
    /// What it is, by the catalogue's name, where its hash does not tell (`orb models list --known`)
    #[arg(long = "as", value_name = "NAME")]
    pub known_as: Option<String>,
    /// The name to keep it under
    #[arg(long, value_name = "NAME")]
    pub id: Option<String>,
    /// Take weights whose SHA-256 Orb does not know; records call them unverified
    #[arg(long)]
    pub allow_unpinned: bool,
    /// You have read the licence of these weights and it allows what you do
    #[arg(long)]
    pub accept_licence: bool,
    /// What a depth network's numbers mean, where the catalogue does not say
    #[arg(long, value_enum)]
    pub depth_kind: Option<DepthKind>,
    /// Take the place of a network of the same name
    #[arg(long)]
    pub replace: bool,
    #[command(flatten)]
    pub engine: EngineArgs,
}

#[derive(Args, Clone, Debug)]
pub struct ListArgs {
    /// Also the networks that Orb knows and that are not here
    #[arg(long)]
    pub known: bool,
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Clone, Debug)]
pub struct OneArgs {
    /// Its name; without one, all
    pub id: Option<String>,
}

#[derive(Args, Clone, Debug)]
pub struct ShowArgs {
    pub id: String,
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Clone, Debug)]
pub struct RemoveArgs {
    pub id: String,
}

/// # Errors
/// As the registry's functions.
pub fn run(args: &ModelsArgs, data: &DataFolder) -> Result<Outcome> {
    let registry = registry(data);
    let text = match &args.verb {
        ModelsVerb::Import(args) => run_import(args, data, &registry)?,
        ModelsVerb::List(args) => list(args, &registry)?,
        ModelsVerb::Verify(args) => verify(args, &registry)?,
        ModelsVerb::Show(args) => {
            let manifest = registry.get(&args.id)?;
            if args.json { json(&manifest)? } else { described(&manifest, &registry) }
        }
        ModelsVerb::Remove(args) => remove(args, data, &registry)?,
    };
    Ok(Outcome { text, exit_code: 0 })
}

fn run_import(args: &ImportArgs, data: &DataFolder, registry: &Registry) -> Result<String> {
    let mut say = |line: &str| eprintln!("orb: {line}");
    let engine = args.engine.open(data, &mut say)?;
    let request = Import {
        sources: args.sources.clone(),
        known_as: args.known_as.clone(),
        id: args.id.clone(),
        allow_unpinned: args.allow_unpinned,
        accept_licence: args.accept_licence,
        depth_kind: args.depth_kind,
        replace: args.replace,
        ..Import::default()
    };
    let manifest = import(registry, &request, &*engine, &mut say)?;
    let imported = Happened::new("model.import", "orb models import", super::argv::caller());
    events::log(data, &Happened { models: vec![recorded(&manifest)], ..imported })?;
    Ok(described(&manifest, registry))
}

fn remove(args: &RemoveArgs, data: &DataFolder, registry: &Registry) -> Result<String> {
    // A damaged manifest does not keep a network from being removed.
    let models = registry.get(&args.id).iter().map(recorded).collect();
    let folder = registry.remove(&args.id)?;
    let removed = Happened::new("model.remove", "orb models remove", super::argv::caller()).to("network", &args.id);
    events::log(data, &Happened { models, ..removed })?;
    Ok(format!("removed      {}\n", folder.display()))
}

/// A network as records name it.
pub(super) fn recorded(m: &Manifest) -> Model {
    Model {
        licence: Some(m.licence.clone()),
        runtime: None,
        pin_source: Some(m.pin_source().into()),
        ..record::model(&m.id, &m.version, &m.weights_sha256(), m.bytes(), "")
    }
}

fn list(args: &ListArgs, registry: &Registry) -> Result<String> {
    let here = registry.list()?;
    if args.json {
        return json(&here);
    }
    let mut out = String::new();
    for m in &here {
        let _ = writeln!(
            out,
            "{:<30} {:<9} {:>7} MiB  {:<14} {}",
            m.id,
            m.family.stage().name(),
            m.bytes() >> 20,
            m.licence,
            if m.pinned { "pinned" } else { "unverified" }
        );
    }
    if here.is_empty() {
        let _ =
            writeln!(out, "no network was imported to {}; the built-in ones need no import", registry.root().display());
    }
    if args.known {
        let _ = writeln!(out, "\nOrb knows, and does not fetch:");
        for e in Catalogue::load(registry.root())?.entries.iter().filter(|e| here.iter().all(|m| m.id != e.id)) {
            let stage = e.families.first().map_or("", |f| f.stage().name());
            let terms = if e.commercial { "" } else { ", no commercial use" };
            let _ = writeln!(out, "{:<30} {:<9} {} ({}{terms})", e.id, stage, e.upstream, e.licence);
        }
    }
    Ok(out)
}

fn verify(args: &OneArgs, registry: &Registry) -> Result<String> {
    let all = match &args.id {
        Some(id) => vec![registry.get(id)?],
        None => registry.list()?,
    };
    let mut out = String::new();
    for manifest in &all {
        registry.verified(manifest)?;
        let _ = writeln!(out, "as imported  {} ({} files)", manifest.id, manifest.files.len());
    }
    Ok(out)
}

fn described(m: &Manifest, registry: &Registry) -> String {
    let mut out = String::new();
    let mut line = |name: &str, words: String| {
        let _ = writeln!(out, "{name:<12} {words}");
    };
    line("network", format!("{} {}", m.id, m.version));
    line("for", format!("{} ({})", m.family.stage().name(), m.family.name()));
    line("licence", format!("{}{}", m.licence, if m.commercial { "" } else { ": read it before commercial use" }));
    line(
        "pin",
        if m.pinned { "SHA-256 known to Orb".into() } else { "unverified: the user vouched for it".to_owned() },
    );
    if let Some(kind) = m.depth_kind {
        line("numbers are", format!("{kind:?}").to_lowercase());
    }
    line("folder", registry.root().join(&m.id).display().to_string());
    for part in &m.parts {
        line(part.role.name(), part.path.clone());
    }
    for file in &m.files {
        line("file", format!("{}  {} ({} bytes)", file.sha256, file.path, file.bytes));
    }
    out
}

fn json(value: &impl serde::Serialize) -> Result<String> {
    let text = serde_json::to_string(value).map_err(|e| Error::environment("--json").found(e.to_string()))?;
    Ok(text + "\n")
}
