//! Sessions of browsers: in memory alone, so that a restart ends them all.

use std::collections::HashMap;
use std::sync::Mutex;

use sha2::{Digest as _, Sha256};

use super::account::{self, Fingerprint};
use super::{lock, random};
use crate::Result;

/// Milliseconds without a request, and altogether.
pub const IDLE: u64 = 30 * 60 * 1000;
pub const LONGEST: u64 = 12 * 3600 * 1000;
/// Of one account, and of all.
const MOST_EACH: usize = 16;
const MOST: usize = 4096;

/// What a session was begun with, and so what it ends with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Proof {
    /// The SHA-256 of the account's token: another token ends the session.
    Token(Vec<u8>),
    /// A certificate: the session is that certificate's alone, and ends when it is no longer the account's.
    Certificate(Fingerprint),
}

struct Session {
    account: String,
    by: Proof,
    csrf: String,
    began: u64,
    used: u64,
}

/// A session as its owner gets it.
pub struct Begun {
    /// 256 random bits, for the cookie.
    pub id: String,
    /// For the header of requests that change something.
    pub csrf: String,
}

/// A session that goes on.
pub struct Known {
    pub account: String,
    pub by: Proof,
    csrf: String,
}

impl Known {
    pub fn csrf(&self) -> &str {
        &self.csrf
    }

    /// Compared in constant time.
    pub fn has_csrf(&self, given: &str) -> bool {
        account::is_same(given.as_bytes(), self.csrf.as_bytes())
    }
}

/// By the SHA-256 of their names: looking one up tells nothing of the others by how long it takes.
#[derive(Default)]
pub struct Sessions(Mutex<HashMap<[u8; 32], Session>>);

fn key(id: &str) -> [u8; 32] {
    Sha256::digest(id.as_bytes()).into()
}

impl Session {
    fn is_over(&self, now: u64) -> bool {
        now >= self.began.saturating_add(LONGEST) || now >= self.used.saturating_add(IDLE)
    }
}

impl Sessions {
    /// The oldest of an account that has too many ends.
    ///
    /// # Errors
    /// Environment, without random numbers.
    pub fn begin(&self, name: &str, by: Proof, now: u64) -> Result<Begun> {
        let begun = Begun { id: hex::encode(random::<32>()?), csrf: hex::encode(random::<32>()?) };
        let mut all = lock(&self.0);
        all.retain(|_, s| !s.is_over(now));
        let oldest = |all: &HashMap<[u8; 32], Session>, own: bool| {
            all.iter().filter(|(_, s)| !own || s.account == name).min_by_key(|(_, s)| s.used).map(|(k, _)| *k)
        };
        if all.values().filter(|s| s.account == name).count() >= MOST_EACH {
            oldest(&all, true).map(|k| all.remove(&k));
        } else if all.len() >= MOST {
            oldest(&all, false).map(|k| all.remove(&k));
        }
        let session = Session { account: name.to_owned(), by, csrf: begun.csrf.clone(), began: now, used: now };
        all.insert(key(&begun.id), session);
        Ok(begun)
    }

    pub fn find(&self, id: &str, now: u64) -> Option<Known> {
        let mut all = lock(&self.0);
        let session = all.get_mut(&key(id)).filter(|s| !s.is_over(now))?;
        session.used = now;
        Some(Known { account: session.account.clone(), by: session.by.clone(), csrf: session.csrf.clone() })
    }

    pub fn end(&self, id: &str) {
        lock(&self.0).remove(&key(id));
    }

    pub fn end_all_of(&self, name: &str) {
        lock(&self.0).retain(|_, s| s.account != name);
    }

    pub fn end_all_by(&self, certificate: &Fingerprint) {
        lock(&self.0).retain(|_, s| s.by != Proof::Certificate(*certificate));
    }

    pub fn are_by(&self, certificate: &Fingerprint) -> bool {
        lock(&self.0).values().any(|s| s.by == Proof::Certificate(*certificate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn token() -> Proof {
        Proof::Token(b"t".to_vec())
    }

    #[test]
    fn they_end() {
        let sessions = Sessions::default();
        let a = sessions.begin("jane", token(), 0).unwrap();
        assert!(sessions.find(&a.id, IDLE - 1).is_some_and(|s| s.account == "jane" && s.has_csrf(&a.csrf)));
        assert!(sessions.find(&a.id, 2 * IDLE - 2).is_some(), "used since");
        assert!(sessions.find(&a.id, 4 * IDLE).is_none(), "not used for too long");
        let b = sessions.begin("jane", token(), 0).unwrap();
        (1..).map(|i| i * (IDLE - 1)).take_while(|t| *t < LONGEST).for_each(|t| drop(sessions.find(&b.id, t)));
        assert!(sessions.find(&b.id, LONGEST).is_none(), "however much it is used");
        let c = sessions.begin("jane", token(), 0).unwrap();
        sessions.end(&c.id);
        assert!(sessions.find(&c.id, 1).is_none(), "signed out");
        let first = sessions.begin("jane", token(), 10).unwrap();
        for i in 0..MOST_EACH as u64 {
            sessions.begin("jane", token(), 20 + i).unwrap();
        }
        assert!(sessions.find(&first.id, 50).is_none(), "too many of one account");
        assert!(sessions.find("", 0).is_none());
        let [own, other] = [b"a", b"b"].map(|der| Fingerprint::of(der));
        let [d, e] = [own, other].map(|c| sessions.begin("john", Proof::Certificate(c), 0).unwrap());
        assert!(sessions.are_by(&own));
        sessions.end_all_by(&own);
        assert!(!sessions.are_by(&own) && sessions.find(&d.id, 1).is_none() && sessions.find(&e.id, 1).is_some());
    }
}
