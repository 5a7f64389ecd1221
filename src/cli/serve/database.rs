//! Where a server keeps what: its folder, and its accounts and jobs there or in PostgreSQL.

use std::path::PathBuf;

use clap::Args;
use zeroize::Zeroizing;

use crate::audit::keys::Passphrase as _;
use crate::audit::{DataFolder, time};
use crate::cli::key::PassphraseSource;
use crate::serve::database::Database;
use crate::serve::database::postgres::{Address, OPTION};
use crate::serve::place::{POSTGRES, Place, SQLITE};
use crate::{Error, Result};

/// In place of `--database`.
const ADDRESS: &str = "ORB_DATABASE";
/// In place of `--database-password`.
const PASSWORD: &str = "ORB_DATABASE_PASSWORD";

#[derive(Args, Clone, Debug)]
pub struct DataArgs {
    /// Folder of jobs, accounts, key and ledger. Default: the user's data folder, ORB_DATA_DIR.
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,

    /// Keep jobs and accounts in PostgreSQL: postgres://USER@HOST/DATABASE, without a password. Default: ORB_DATABASE, else
    /// SQLite in the folder.
    #[arg(long, value_name = "URL")]
    database: Option<String>,

    /// Where the database's password is: file:PATH (its first line, mode 0600) or env:NAME. Default: ORB_DATABASE_PASSWORD.
    #[arg(long, value_name = "SOURCE")]
    database_password: Option<PassphraseSource>,

    /// Authorities of the database's certificate, PEM: TLS, without which no host beyond this machine is asked.
    #[arg(long, value_name = "PEM")]
    database_ca: Option<PathBuf>,
}

/// A variable that is set to something.
fn variable(name: &str) -> Result<Option<Zeroizing<String>>> {
    match std::env::var(name) {
        Ok(value) => Ok(Some(Zeroizing::new(value)).filter(|v| !v.is_empty())),
        Err(std::env::VarError::NotPresent) => Ok(None),
        Err(std::env::VarError::NotUnicode(_)) => Err(Error::usage(name).expected("text in UTF-8")),
    }
}

/// The database, and what it is called.
pub struct Opened {
    pub database: Database,
    /// In the ledger.
    pub words: String,
    /// In the folder, which stays with it whoever asks.
    pub home: String,
}

impl DataArgs {
    pub fn folder(&self) -> Result<DataFolder> {
        match &self.data {
            Some(path) => std::path::absolute(path).map(DataFolder::at).map_err(|e| Error::io(path, &e)),
            None => DataFolder::from_environment(|name| std::env::var_os(name)),
        }
    }

    /// Opened or made.
    ///
    /// # Errors
    /// As [`Address::new`], [`Database::at`], [`Database::file`], [`Place::check_database`]; usage for a password without a
    /// database to give it to.
    pub fn database(&self, place: &Place) -> Result<Opened> {
        let url = match &self.database {
            Some(url) => Some(Zeroizing::new(url.clone())),
            None => variable(ADDRESS)?,
        };
        let Some(url) = url else {
            if self.database_password.is_some() || self.database_ca.is_some() {
                return Err(Error::usage(OPTION)
                    .expected("one, beside --database-password or --database-ca")
                    .found("none"));
            }
            place.check_database(SQLITE)?;
            return Ok(Opened {
                database: Database::file(&place.database())?,
                words: SQLITE.into(),
                home: SQLITE.into(),
            });
        };
        let password = match &self.database_password {
            Some(PassphraseSource::Prompt) => {
                return Err(Error::usage("--database-password").expected("file:PATH or env:NAME").found("prompt"));
            }
            Some(source) => Some(source.read()?),
            None => variable(PASSWORD)?,
        };
        let password = password.as_ref().map(|p| p.as_str());
        let address = Address::new(&url, password, self.database_ca.as_deref(), time::now()?.unix_ms)?;
        let (words, home) = (format!("{POSTGRES} {}", address.words()), format!("{POSTGRES} {}", address.home()));
        place.check_database(&home)?;
        Ok(Opened { database: Database::at(address, place.name()?)?, words, home })
    }

    /// Variables that are nothing to the processes that runs are.
    pub fn secrets(&self) -> Vec<String> {
        let named = match &self.database_password {
            Some(PassphraseSource::Variable(name)) => Some(name.clone()),
            _ => None,
        };
        [ADDRESS, PASSWORD].map(str::to_owned).into_iter().chain(named).collect()
    }
}
