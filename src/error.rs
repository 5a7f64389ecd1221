//! One error for the whole program: what failed, where, what was expected, what was found, what to do.

use std::fmt;

pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Decides the exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A byte is not what the record says: exit 1.
    Integrity,
    /// Wrong arguments or an input that cannot be used: exit 2.
    Usage,
    /// Something needed for a verdict is missing: exit 3.
    Incomplete,
    /// Refused by policy (marking, key, algorithm): exit 4.
    Policy,
    /// The machine: disk, permissions, memory: exit 5.
    Environment,
    /// Stopped by the user: exit 130, as shells do for an interrupt.
    Cancelled,
}

impl Kind {
    pub fn exit_code(self) -> u8 {
        match self {
            Kind::Integrity => 1,
            Kind::Usage => 2,
            Kind::Incomplete => 3,
            Kind::Policy => 4,
            Kind::Environment => 5,
            Kind::Cancelled => 130,
        }
    }
}

/// Built as a sentence: `Error::usage("--origin").expected("…").found("…").advice("…")`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    pub kind: Kind,
    /// The file, option or stage.
    pub subject: String,
    pub expected: String,
    pub found: String,
    pub advice: String,
}

impl Error {
    pub fn new(kind: Kind, subject: impl Into<String>) -> Self {
        Error { kind, subject: subject.into(), expected: String::new(), found: String::new(), advice: String::new() }
    }
    pub fn usage(subject: impl Into<String>) -> Self {
        Self::new(Kind::Usage, subject)
    }
    pub fn integrity(subject: impl Into<String>) -> Self {
        Self::new(Kind::Integrity, subject)
    }
    pub fn incomplete(subject: impl Into<String>) -> Self {
        Self::new(Kind::Incomplete, subject)
    }
    pub fn policy(subject: impl Into<String>) -> Self {
        Self::new(Kind::Policy, subject)
    }
    pub fn environment(subject: impl Into<String>) -> Self {
        Self::new(Kind::Environment, subject)
    }
    pub fn cancelled() -> Self {
        Self::new(Kind::Cancelled, "stopped").found("an interrupt").advice("Nothing was published.")
    }
    /// An input or output error on a path: environment, with the system's own words.
    pub fn io(path: &std::path::Path, error: &std::io::Error) -> Self {
        Self::environment(path.display().to_string()).found(error.to_string())
    }
    pub fn expected(mut self, text: impl Into<String>) -> Self {
        self.expected = text.into();
        self
    }
    pub fn found(mut self, text: impl Into<String>) -> Self {
        self.found = text.into();
        self
    }
    pub fn advice(mut self, text: impl Into<String>) -> Self {
        self.advice = text.into();
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.subject)?;
        match (self.expected.is_empty(), self.found.is_empty()) {
            (false, false) => write!(f, ": expected {}, found {}", self.expected, self.found)?,
            (false, true) => write!(f, ": expected {}", self.expected)?,
            (true, false) => write!(f, ": {}", self.found)?,
            (true, true) => {}
        }
        if !self.advice.is_empty() {
            write!(f, "\n  {}", self.advice)?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}
