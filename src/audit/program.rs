//! What a record says of the program that made it and of its cryptography.

use std::path::PathBuf;
use std::sync::OnceLock;

use serde::{Deserialize, Serialize};

use super::{disk, sbom};

#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    pub name: String,
    pub version: String,
    /// Of the source, or `unknown`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub git_commit: Option<String>,
    /// Whether the source differed from the commit; since minor version 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dirty: Option<bool>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rustc: Option<String>,
    /// Of the build, sorted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub features: Option<Vec<String>>,
    /// Of the program's own file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub binary_sha256: Option<String>,
    /// Of what `orb audit sbom` prints; since minor version 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sbom_sha256: Option<String>,
}

impl Tool {
    /// This program, as `build.rs` saw it made.
    pub fn of_this_binary() -> Tool {
        Tool {
            name: "orb".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            git_commit: Some(env!("ORB_BUILD_COMMIT").into()),
            dirty: env!("ORB_BUILD_DIRTY").parse().ok(),
            target: Some(env!("ORB_BUILD_TARGET").into()),
            rustc: Some(env!("ORB_BUILD_RUSTC").into()),
            features: Some(
                env!("ORB_BUILD_FEATURES").split(',').filter(|f| !f.is_empty()).map(str::to_owned).collect(),
            ),
            binary_sha256: binary_sha256(),
            sbom_sha256: Some(sbom::sha256()),
        }
    }

    pub(super) fn check(&self) -> Result<(), String> {
        let hex = super::statement::hex;
        if let Some(commit) = self.git_commit.as_ref().filter(|c| *c != "unknown") {
            hex("tool.git_commit", commit, if commit.len() == 64 { 64 } else { 40 })?;
        }
        for (name, sha256) in [("tool.binary_sha256", &self.binary_sha256), ("tool.sbom_sha256", &self.sbom_sha256)] {
            if let Some(sha256) = sha256 {
                hex(name, sha256, 64)?;
            }
        }
        Ok(())
    }
}

/// SHA-256 of the file that runs; `None` where the system does not let it be read. A program does not change while it runs, so
/// it is read once.
pub fn binary_sha256() -> Option<String> {
    static OF_THIS_PROCESS: OnceLock<Option<String>> = OnceLock::new();
    let read = || {
        // On Linux the file that was started, also where another one has its name by now.
        let running = PathBuf::from("/proc/self/exe");
        let path = if running.exists() { running } else { std::env::current_exe().ok()? };
        disk::hash_file(&path).ok().map(|(_, sha256)| sha256)
    };
    OF_THIS_PROCESS.get_or_init(read).clone()
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Crypto {
    pub provider: String,
    pub provider_version: String,
    pub fips_mode: bool,
    /// The certificate that the module's maker names for it, where the build knows which module it is; since minor version 5.
    /// Whether it covers the platform is not said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub module_certificate_claim: Option<String>,
}

impl Crypto {
    /// Of this program.
    pub fn of_this_binary() -> Crypto {
        let version = aws_lc_rs::awslc_version();
        let fips_mode = aws_lc_rs::try_fips_mode().is_ok();
        let package = sbom::locked_version("aws-lc-fips-sys").unwrap_or_default();
        let claim = module_certificate(version, package, env!("ORB_BUILD_FIPS_MODULE")).filter(|_| fips_mode);
        Crypto {
            provider: "aws-lc-rs".into(),
            provider_version: format!("AWS-LC {version}"),
            fips_mode,
            module_certificate_claim: claim.map(str::to_owned),
        }
    }

    pub(super) fn check(&self) -> Result<(), String> {
        match &self.module_certificate_claim {
            Some(claim) if !self.fips_mode => {
                Err(format!("crypto.module_certificate_claim {claim:?}: expected none while fips_mode is off"))
            }
            _ => Ok(()),
        }
    }
}

/// As the release notes of aws-lc-rs 1.17.1 name them: both certificates are of AWS-LC FIPS 3, which aws-lc-fips-sys 0.13 builds.
/// `module`: how it was linked, as `build.rs` found out.
fn module_certificate(version: &str, package: &str, module: &str) -> Option<&'static str> {
    if !version.starts_with("3.") || !package.starts_with("0.13.") {
        return None;
    }
    match module {
        "static" => Some("CMVP #5314"),
        "dynamic" => Some("CMVP #5298"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_certificate_is_never_made_up() {
        assert_eq!(module_certificate("3.6.0", "0.13.17", "static"), Some("CMVP #5314"));
        assert_eq!(module_certificate("3.6.0", "0.13.17", "dynamic"), Some("CMVP #5298"));
        for (version, package, module) in [
            ("3.6.0", "0.13.17", "unknown"),
            ("4.0.0", "0.14.4", "static"),
            ("3.6.0", "0.14.4", "static"),
            ("", "", ""),
        ] {
            assert_eq!(module_certificate(version, package, module), None);
        }
        let ours = Crypto::of_this_binary();
        assert_eq!(ours.fips_mode, cfg!(feature = "fips"));
        assert_eq!(
            ours.module_certificate_claim.is_some(),
            cfg!(feature = "fips")
                && ours.provider_version.starts_with("AWS-LC 3.")
                && env!("ORB_BUILD_FIPS_MODULE") != "unknown"
        );
        let made_up = Crypto { fips_mode: false, module_certificate_claim: Some("CMVP #1".into()), ..ours };
        assert!(made_up.check().is_err());
    }

    #[test]
    fn this_program() {
        let tool = Tool::of_this_binary();
        assert_eq!(tool.check(), Ok(()));
        assert!(tool.rustc.unwrap().starts_with("rustc "));
        let features = tool.features.unwrap();
        assert!(
            features.is_sorted() && features.contains(&"fips".to_owned()) == cfg!(feature = "fips"),
            "{features:?}"
        );
        let bytes = std::fs::read(std::env::current_exe().unwrap()).unwrap();
        assert_eq!(tool.binary_sha256, Some(super::super::canonical::sha256_hex(&bytes)));
        // A build for development knows no commit unless it was told, another one that of its repository, where it is from one.
        if option_env!("ORB_GIT_COMMIT").is_none() {
            let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
            let knows = env!("ORB_BUILD_PROFILE") != "debug" && root.join(".git").exists();
            let head =
                || std::process::Command::new("git").current_dir(root).args(["rev-parse", "HEAD"]).output().unwrap();
            let commit = if knows { String::from_utf8(head().stdout).unwrap() } else { "unknown".into() };
            assert_eq!(tool.git_commit.as_deref(), Some(commit.trim()));
        }
    }

    #[test]
    fn commits() {
        let of = |commit: &str| Tool { git_commit: Some(commit.into()), ..Tool::default() }.check();
        assert!(of("unknown").is_ok() && of(&"0a".repeat(20)).is_ok() && of(&"0a".repeat(32)).is_ok());
        assert!(of("").is_err() && of("main").is_err() && of(&"0A".repeat(20)).is_err());
    }
}
