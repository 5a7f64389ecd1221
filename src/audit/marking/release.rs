//! Foreign disclosure and release: NOFORN, REL TO, RELIDO, DISPLAY ONLY, and how they roll up (IC Markings Manual 2016,
//! section D.2, Table 3).

use std::collections::BTreeSet;

use super::Level;

/// Who beyond the United States may have it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Release {
    /// Nothing said. Beside other classified portions that counts as no release at all.
    Unstated,
    To(Audience),
    Noforn,
}

/// Country codes beside USA. Whoever may have something may see it: [`Audience::display`] lists the others only.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Audience {
    pub rel_to: BTreeSet<String>,
    pub display: BTreeSet<String>,
    /// A release official may decide.
    pub relido: bool,
}

/// The codes that Table 3, row 23, allows to be expanded, without USA.
const GROUPS: [(&str, &[&str]); 3] =
    [("ACGU", &["AUS", "CAN", "GBR"]), ("FVEY", &["AUS", "CAN", "GBR", "NZL"]), ("TEYE", &["AUS", "GBR"])];

fn expanded(codes: &BTreeSet<String>) -> BTreeSet<String> {
    let members = |code: &String| match GROUPS.iter().find(|(group, _)| group == code) {
        Some((_, members)) => members.iter().map(|m| (*m).to_owned()).collect(),
        None => vec![code.clone()],
    };
    codes.iter().flat_map(members).collect()
}

/// Codes common to both; lists that are the same are left as they are written.
fn common(a: &BTreeSet<String>, b: &BTreeSet<String>) -> BTreeSet<String> {
    if a == b { a.clone() } else { &expanded(a) & &expanded(b) }
}

/// Trigraphs A–Z, then tetragraphs A–Z.
fn in_order(codes: &BTreeSet<String>) -> Vec<String> {
    let mut all: Vec<String> = codes.iter().cloned().collect();
    all.sort_by_key(|code| (code.len(), code.clone()));
    all
}

/// True for codes of more than one country that [`Release`] understands.
pub(super) fn is_group(code: &str) -> bool {
    GROUPS.iter().any(|(group, _)| *group == code)
}

impl Audience {
    fn may_see(&self) -> BTreeSet<String> {
        &self.rel_to | &self.display
    }

    fn join(&self, other: &Audience) -> Release {
        let rel_to = common(&self.rel_to, &other.rel_to);
        let seen = common(&self.may_see(), &other.may_see());
        let display = match self == other {
            true => self.display.clone(),
            false => &expanded(&seen) - &expanded(&rel_to),
        };
        let relido = self.relido && other.relido;
        if rel_to.is_empty() && display.is_empty() && !relido {
            return Release::Noforn;
        }
        Release::To(Audience { rel_to, display, relido })
    }
}

impl Release {
    /// Of portions of these levels.
    pub fn join(&self, level: Level, other: &Release, other_level: Level) -> Release {
        match (self, other) {
            (Release::Noforn, _) | (_, Release::Noforn) => Release::Noforn,
            (Release::Unstated, Release::Unstated) => Release::Unstated,
            (Release::To(a), Release::To(b)) => a.join(b),
            (Release::Unstated, Release::To(_)) if level.is_classified() => Release::Noforn,
            (Release::To(_), Release::Unstated) if other_level.is_classified() => Release::Noforn,
            (Release::To(a), Release::Unstated) | (Release::Unstated, Release::To(a)) => Release::To(a.clone()),
        }
    }

    /// Every code but USA.
    pub fn codes(&self) -> impl Iterator<Item = &str> {
        let lists = match self {
            Release::To(a) => Some(a.rel_to.iter().chain(&a.display)),
            _ => None,
        };
        lists.into_iter().flatten().map(String::as_str)
    }

    pub fn is_noforn(&self) -> bool {
        *self == Release::Noforn
    }

    /// REL TO, RELIDO and DISPLAY ONLY as a banner writes them, where they are.
    pub fn entries(&self) -> [Option<String>; 3] {
        let Release::To(a) = self else { return [None, None, None] };
        let listed = |codes: &BTreeSet<String>, head: &str| {
            (!codes.is_empty()).then(|| format!("{head}{}", in_order(codes).join(", ")))
        };
        [listed(&a.rel_to, "REL TO USA, "), a.relido.then(|| "RELIDO".to_owned()), listed(&a.display, "DISPLAY ONLY ")]
    }

    pub fn ism_controls(&self) -> impl Iterator<Item = &'static str> {
        let (rel, relido, display) = match self {
            Release::To(a) => (!a.rel_to.is_empty(), a.relido, !a.display.is_empty()),
            _ => (false, false, false),
        };
        [(self.is_noforn(), "NF"), (rel, "REL"), (relido, "RELIDO"), (display, "DISPLAYONLY")]
            .into_iter()
            .filter_map(|(is, name)| is.then_some(name))
    }

    /// Codes of REL TO, USA first, and of DISPLAY ONLY.
    pub fn lists(&self) -> (Vec<String>, Vec<String>) {
        let Release::To(a) = self else { return (Vec::new(), Vec::new()) };
        let mut rel = in_order(&a.rel_to);
        if !rel.is_empty() {
            rel.insert(0, "USA".into());
        }
        (rel, in_order(&a.display))
    }
}
