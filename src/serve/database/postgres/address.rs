//! Where a PostgreSQL server is, and that nothing goes to it over a network unencrypted.

use std::net::IpAddr;
use std::path::Path;
use std::time::Duration;

use postgres::Config;
use postgres::config::{Host, SslMode};

use super::tls::Tls;
use crate::{Error, Result};

/// The option that names it.
pub const OPTION: &str = "--database";
const FORM: &str =
    "postgres://USER@HOST/DATABASE, or postgres://USER@%2Fvar%2Frun%2Fpostgresql/DATABASE for a Unix socket";
const CONNECT: Duration = Duration::from_secs(5);
/// A server that is cut off is noticed after about this and three times [`BETWEEN`].
const IDLE: Duration = Duration::from_secs(10);
const BETWEEN: Duration = Duration::from_secs(5);

/// A server, a database, a user, and how to reach them.
pub struct Address {
    pub(super) config: Config,
    pub(super) tls: Option<Tls>,
    home: String,
    user: Option<String>,
}

impl Address {
    /// `url` as `psql` takes it, without a password; `authorities` are those of the server's certificate, PEM; `now` in
    /// milliseconds since 1970.
    ///
    /// # Errors
    /// Usage for what is no such address or holds a password; policy for a host beyond this machine without
    /// `authorities`; as [`Tls::new`].
    pub fn new(url: &str, password: Option<&str>, authorities: Option<&Path>, now: u64) -> Result<Address> {
        let wrong = |found: String| Error::usage(OPTION).expected(FORM).found(found);
        if !url.starts_with("postgres://") && !url.starts_with("postgresql://") {
            return Err(wrong("an address that does not begin with postgres://".into()));
        }
        let mut config: Config = url.parse().map_err(|e: postgres::Error| {
            wrong(std::error::Error::source(&e).map_or_else(|| e.to_string(), ToString::to_string))
        })?;
        if config.get_password().is_some() {
            return Err(wrong("a password in it, which the list of processes shows to everyone".into())
                .advice("Say where it is by --database-password file:PATH or env:NAME."));
        }
        if config.get_hosts().is_empty() && config.get_hostaddrs().is_empty() {
            return Err(wrong("no host".into()));
        }
        if let Some(password) = password {
            config.password(password);
        }
        let (home, user) = (home(&config), config.get_user().map(str::to_owned));
        let beyond = config.get_hosts().iter().filter(|host| !is_here(host)).map(name);
        let beyond = beyond.chain(config.get_hostaddrs().iter().filter(|a| !a.is_loopback()).map(IpAddr::to_string));
        let beyond: Vec<String> = beyond.collect();
        let by_name = config.get_hosts().iter().any(|host| matches!(host, Host::Tcp(_)));
        let tls = match authorities {
            None if !beyond.is_empty() => {
                return Err(Error::policy(OPTION)
                    .expected("a Unix socket or the loopback, or TLS beyond this machine")
                    .found(format!("{}, without --database-ca", beyond.join(", ")))
                    .advice("Name the authority of the database's certificate by --database-ca PEM, or use ssh -L."));
            }
            Some(path) if by_name || !beyond.is_empty() => Some(Tls::new(path, now)?),
            _ => None,
        };
        // Whatever the address says of it: TLS or none, and never none after all.
        config.ssl_mode(if tls.is_some() { SslMode::Require } else { SslMode::Disable });
        config.connect_timeout(CONNECT).tcp_user_timeout(IDLE + 3 * BETWEEN);
        config.keepalives(true).keepalives_idle(IDLE).keepalives_interval(BETWEEN).keepalives_retries(3);
        config.application_name("orb serve");
        Ok(Address { config, tls, home, user })
    }

    /// What it is called where anyone may read it.
    pub fn words(&self) -> String {
        let user = self.user.as_ref().map(|u| format!(" as {u}")).unwrap_or_default();
        format!("{}{user}", self.home)
    }

    /// Where it is and which of the databases there, without who asks it.
    pub fn home(&self) -> &str {
        &self.home
    }
}

fn is_here(host: &Host) -> bool {
    match host {
        Host::Tcp(name) => name == "localhost" || name.parse::<IpAddr>().is_ok_and(|a| a.is_loopback()),
        #[cfg(unix)]
        Host::Unix(_) => true,
    }
}

fn name(host: &Host) -> String {
    match host {
        Host::Tcp(name) => name.clone(),
        #[cfg(unix)]
        Host::Unix(path) => path.display().to_string(),
    }
}

fn home(config: &Config) -> String {
    let hosts: Vec<String> = match config.get_hosts() {
        [] => config.get_hostaddrs().iter().map(IpAddr::to_string).collect(),
        named => named.iter().map(name).collect(),
    };
    let port = config.get_ports().first().map(|p| format!(" port {p}")).unwrap_or_default();
    let database = config.get_dbname().or(config.get_user()).unwrap_or_default();
    format!("{database:?} at {}{port}", hosts.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;

    #[test]
    fn nothing_goes_over_a_network_unencrypted() {
        let of = |url: &str| Address::new(url, None, None, 0);
        for here in [
            "postgres://orb@%2Fvar%2Frun%2Fpostgresql/orb",
            "postgresql://orb@localhost:5433/orb?sslmode=require",
            "postgres://orb@127.0.0.3/orb",
            "postgres://orb@[::1]/orb",
        ] {
            let address = of(here).unwrap_or_else(|e| panic!("{here}: {e}"));
            assert!(address.tls.is_none() && address.config.get_ssl_mode() == SslMode::Disable, "{here}");
        }
        for beyond in [
            "postgres://orb@db.example/orb",
            "postgres://orb@db.example/orb?sslmode=disable",
            "postgres://orb@192.0.2.1/orb",
            "postgres://orb@localhost,db.example/orb",
            "postgres://orb@localhost/orb?hostaddr=192.0.2.1",
        ] {
            let refused = of(beyond).err().unwrap_or_else(|| panic!("{beyond}"));
            assert_eq!(refused.kind, Kind::Policy, "{beyond}");
            assert!(refused.to_string().contains("--database-ca"), "{refused}");
        }
        let authority = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tls/authority.pem");
        let over =
            Address::new("postgres://orb@db.example/orb?sslmode=disable", None, Some(&authority), 1_790_000_000_000);
        let over = over.unwrap();
        assert!(over.tls.is_some() && over.config.get_ssl_mode() == SslMode::Require);
        assert_eq!(over.words(), "\"orb\" at db.example port 5432 as orb");
        assert_eq!(over.home(), "\"orb\" at db.example port 5432");
    }

    #[test]
    fn a_password_in_an_address_is_refused_and_not_repeated() {
        for wrong in [
            "postgres://orb:hunter2@localhost/orb",
            "postgres://orb@localhost/orb?password=hunter2",
            "postgres://orb@/orb",
            "mysql://orb@localhost/orb",
            "host=localhost password=hunter2",
            "postgres://orb@localhost:x/orb",
        ] {
            let words = Address::new(wrong, None, None, 0).err().unwrap_or_else(|| panic!("{wrong}")).to_string();
            assert!(words.starts_with("--database: expected postgres://") && !words.contains("hunter2"), "{words}");
        }
        let with = Address::new("postgres://orb@localhost/orb", Some("hunter2"), None, 0).unwrap();
        assert!(!with.words().contains("hunter2") && !format!("{:?}", with.config).contains("hunter2"));
    }
}
