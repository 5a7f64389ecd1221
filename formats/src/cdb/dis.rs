//! DIS entity types: what a moving model is.
//!
//! Source: IEEE 1278.1, "Entity Type record"; OGC CDB 1.x Volume 1, "MModel library datasets" (the code as file names spell it).

use std::fmt;

use crate::{Error, Result};

/// The seven numbers of an entity type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct EntityType {
    pub kind: u8,
    pub domain: u8,
    pub country: u16,
    pub category: u8,
    pub subcategory: u8,
    pub specific: u8,
    pub extra: u8,
}

impl EntityType {
    /// The numbers of `1.1.225.1.1.8.0`, with dots, underscores or colons. The last three may be left out: 0.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for anything else.
    pub fn parse(text: &str) -> Result<EntityType> {
        let numbers: Option<Vec<u16>> = text
            .split(['.', '_', ':'])
            .map(|n| n.bytes().all(|b| b.is_ascii_digit()).then(|| n.parse().ok()).flatten())
            .collect();
        let small = |n: u16| u8::try_from(n).ok();
        let whole = |n: &[u16]| {
            let at = |i: usize| small(n.get(i).copied().unwrap_or(0));
            Some(EntityType {
                kind: at(0)?,
                domain: at(1)?,
                country: n[2],
                category: at(3)?,
                subcategory: at(4)?,
                specific: at(5)?,
                extra: at(6)?,
            })
        };
        numbers.filter(|n| (4..=7).contains(&n.len())).and_then(|n| whole(&n)).ok_or_else(|| Error::Unsupported {
            format: "DIS entity type",
            what: format!(
                "expected kind.domain.country.category.subcategory.specific.extra, the country up to 65535 and the others \
                 up to 255, as in 1.1.225.1.1.8.0; found {text:?}"
            ),
        })
    }

    pub fn numbers(&self) -> [u16; 7] {
        let e = self;
        [
            e.kind.into(),
            e.domain.into(),
            e.country,
            e.category.into(),
            e.subcategory.into(),
            e.specific.into(),
            e.extra.into(),
        ]
    }

    fn joined(&self, with: &str) -> String {
        self.numbers().map(|n| n.to_string()).join(with)
    }

    /// MMDC, the Moving Model DIS Code: `1_1_225_1_1_8_0`.
    pub fn code(&self) -> String {
        self.joined("_")
    }
}

impl fmt::Display for EntityType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.joined("."))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_read_and_written() {
        let tank = EntityType::parse("1.1.225.1.1.8.0").unwrap();
        assert_eq!((tank.code().as_str(), tank.to_string().as_str()), ("1_1_225_1_1_8_0", "1.1.225.1.1.8.0"));
        assert_eq!(EntityType::parse("1_1_225_1_1_8_0"), Ok(tank));
        assert_eq!(EntityType::parse("1:2:65535:57").unwrap().code(), "1_2_65535_57_0_0_0");
        for wrong in
            ["", "1.1.225", "1.1.225.1.1.8.0.0", "256.1.225.1", "1.1.65536.1", "1.1.225.x", "1.1..1", "+1.1.2.3"]
        {
            assert!(EntityType::parse(wrong).is_err(), "{wrong}");
        }
    }
}
