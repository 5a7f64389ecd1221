//! Who may do what: denied unless the table says otherwise (NIST SP 800-53 AC-2, AC-6, AU-9(4)).

use std::collections::BTreeSet;
use std::str::FromStr;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use crate::{Error, Result};

/// What an account is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Looks at scenes at or below its ceiling
    Viewer,
    /// Submits jobs, cancels and deletes its own
    Operator,
    /// Marks its jobs above UNCLASSIFIED and enters authority blocks; needs `operator` beside it to submit them
    MarkingOfficer,
    /// Reads the ledger's events, records and verifications; no scenes, no jobs
    Auditor,
    /// Makes and disables accounts; sees no scenes and no ledger
    Admin,
    /// Reads metrics
    Monitor,
}

/// What a role can allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Right {
    /// Jobs: that they are, their states and records, their verification.
    Records,
    /// What jobs published.
    Scenes,
    Submit,
    /// Submit above UNCLASSIFIED.
    Mark,
    Accounts,
    Events,
    Metrics,
}

impl Role {
    pub fn allows(self, right: Right) -> bool {
        use Right::*;
        match self {
            Role::Viewer => matches!(right, Records | Scenes),
            Role::Operator => matches!(right, Records | Scenes | Submit),
            Role::MarkingOfficer => matches!(right, Records | Scenes | Mark),
            Role::Auditor => matches!(right, Records | Events),
            Role::Admin => matches!(right, Accounts),
            Role::Monitor => matches!(right, Metrics),
        }
    }

    /// Who watches over others does not do what he watches over.
    pub fn stands_alone(self) -> bool {
        matches!(self, Role::Admin | Role::Auditor)
    }

    pub fn name(self) -> String {
        self.to_possible_value().map(|v| v.get_name().to_owned()).unwrap_or_default()
    }
}

/// Roles of one account, at least one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Role>")]
pub struct Roles(BTreeSet<Role>);

impl Roles {
    pub fn allow(&self, right: Right) -> bool {
        self.0.iter().any(|role| role.allows(right))
    }

    pub fn iter(&self) -> impl Iterator<Item = Role> + '_ {
        self.0.iter().copied()
    }

    /// As the database and `ORB_OPERATOR_ROLE` have them.
    pub fn text(&self) -> String {
        self.iter().map(Role::name).collect::<Vec<_>>().join(",")
    }
}

impl TryFrom<Vec<Role>> for Roles {
    type Error = Error;

    fn try_from(roles: Vec<Role>) -> Result<Roles> {
        let roles: BTreeSet<Role> = roles.into_iter().collect();
        if roles.is_empty() || roles.len() > 1 && roles.iter().any(|r| r.stands_alone()) {
            return Err(Error::usage("role")
                .expected("at least one role, and admin or auditor alone")
                .found(roles.iter().map(|r| r.name()).collect::<Vec<_>>().join(",")));
        }
        Ok(Roles(roles))
    }
}

impl FromStr for Roles {
    type Err = Error;

    fn from_str(text: &str) -> Result<Roles> {
        let one = |name: &str| {
            Role::from_str(name, false)
                .map_err(|_| Error::usage("role").expected("a role's name").found(name.to_owned()))
        };
        text.split(',').map(one).collect::<Result<Vec<Role>>>()?.try_into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duties_are_separate() {
        for (text, sound) in [
            ("viewer", true),
            ("operator,marking-officer", true),
            ("admin", true),
            ("admin,viewer", false),
            ("auditor,operator", false),
            ("", false),
            ("root", false),
        ] {
            assert_eq!(text.parse::<Roles>().is_ok(), sound, "{text}");
        }
        let all = Role::value_variants();
        let who = |right| all.iter().filter(|r| r.allows(right)).map(|r| r.name()).collect::<Vec<_>>().join(" ");
        assert_eq!(who(Right::Submit), "operator");
        assert_eq!(who(Right::Mark), "marking-officer");
        assert_eq!(who(Right::Scenes), "viewer operator marking-officer");
        assert_eq!(who(Right::Records), "viewer operator marking-officer auditor");
        assert_eq!(who(Right::Events), "auditor");
        assert_eq!(who(Right::Accounts), "admin");
        assert_eq!(who(Right::Metrics), "monitor");
    }
}
