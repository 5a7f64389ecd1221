//! The options that mark a product, for every verb that publishes one.

use std::path::PathBuf;

use clap::Args;

use crate::audit::Marking;
use crate::audit::inband;
use crate::audit::marking::Level;
use crate::audit::marking::Profile;
use crate::audit::marking::authority::{Authority, Designation};
use crate::audit::marking::handling::{Handling, Request};
use crate::audit::marking::register::CountryRegister;
use crate::audit::statement::MarkingBlock;
use crate::{Error, Result};

/// How the product is marked.
#[derive(Args, Clone, Debug, Default)]
pub struct MarkingArgs {
    /// UNCLASSIFIED, CUI, CONFIDENTIAL, SECRET or TOP SECRET, with controls: SECRET//REL TO USA, GBR. Default: what the
    /// inputs carry, else UNCLASSIFIED; never below the inputs'.
    #[arg(long, value_name = "BANNER", help_heading = "Marking")]
    pub classification: Option<String>,

    /// Rules for the banner of CUI: DoD's three letters, or ISOO's with categories.
    #[arg(long, value_enum, default_value_t, help_heading = "Marking")]
    pub marking_profile: Profile,

    /// Why the product is marked above its inputs.
    #[arg(long, value_name = "TEXT", help_heading = "Marking")]
    pub raise_reason: Option<String>,

    /// Country codes for REL TO and DISPLAY ONLY beyond ISO 3166, ACGU, FVEY and TEYE, one at the beginning of each line.
    #[arg(long, value_name = "FILE", help_heading = "Marking")]
    pub country_register: Option<PathBuf>,

    /// Who classified the product, with position and office; needed for classified work, with the next two.
    #[arg(long, value_name = "TEXT", help_heading = "Marking")]
    pub classified_by: Option<String>,

    /// Title, agency and date of the source or guide; `Multiple Sources` with a --source each.
    #[arg(long, value_name = "TEXT", help_heading = "Marking")]
    pub derived_from: Option<String>,

    /// YYYYMMDD, an event, or an exemption such as `25X1, 20601231`.
    #[arg(long, value_name = "WHEN", help_heading = "Marking")]
    pub declassify_on: Option<String>,

    /// One of multiple sources.
    #[arg(long, value_name = "TEXT", help_heading = "Marking")]
    pub source: Vec<String>,

    /// Designation indicator block of CUI: the component that controls it; needs the office, the category and the contact.
    #[arg(long, value_name = "TEXT", requires_all = ["cui_office", "cui_category", "cui_poc"], help_heading = "Marking")]
    pub cui_controlled_by: Option<String>,

    #[arg(long, value_name = "TEXT", requires = "cui_controlled_by", help_heading = "Marking")]
    pub cui_office: Option<String>,

    #[arg(long, value_name = "TEXT", requires = "cui_controlled_by", help_heading = "Marking")]
    pub cui_category: Option<String>,

    /// Distribution statement or limited dissemination control.
    #[arg(long, value_name = "TEXT", requires = "cui_controlled_by", help_heading = "Marking")]
    pub cui_dissemination: Option<String>,

    /// Name and telephone or mail of the point of contact.
    #[arg(long, value_name = "TEXT", requires = "cui_controlled_by", help_heading = "Marking")]
    pub cui_poc: Option<String>,
}

impl MarkingArgs {
    /// The marking of a product made of inputs that carry these, on the day `utc` (`YYYY-MM-DD…`). Says on standard error
    /// what is worth a second look.
    ///
    /// # Errors
    /// As [`Request::decide`].
    pub fn decide(&self, inputs: &[Option<Marking>], utc: &str) -> Result<Handling> {
        let request = Request {
            banner: self.classification.clone(),
            profile: self.marking_profile,
            raised_reason: self.raise_reason.clone(),
            authority: self.authority(utc)?,
            designation: self.designation(),
            register: self.country_register.as_deref().map(CountryRegister::read).transpose()?,
        };
        let handling = request.decide(inputs.iter().map(Option::as_ref))?;
        let written = self.classification.as_deref().filter(|text| *text != handling.marking.banner());
        if let Some(text) = written {
            eprintln!("orb: warning: `{text}` is written {} in the order of the Register", handling.marking);
        }
        for mark in handling.marking.unknown_categories() {
            eprintln!("orb: warning: {mark} is no category mark of CUI that Orb knows");
        }
        if handling.marking.level() == Level::Cui && handling.designation.is_none() {
            eprintln!(
                "orb: warning: CUI without its designation indicator block: see --cui-controlled-by, --cui-office, \
                 --cui-category, --cui-poc"
            );
        }
        Ok(handling)
    }

    /// As [`MarkingArgs::decide`], for a product about one that is marked like `of`: where nothing is said, its rules and its
    /// blocks are taken over, dated `utc`.
    ///
    /// # Errors
    /// As [`MarkingArgs::decide`].
    pub fn decide_like(&self, of: &MarkingBlock, inputs: &[Option<Marking>], utc: &str) -> Result<Handling> {
        let MarkingArgs { classification, raise_reason, classified_by, derived_from, declassify_on, .. } = self;
        let said = [classification, raise_reason, classified_by, derived_from, declassify_on, &self.cui_controlled_by];
        if said.iter().any(|option| option.is_some()) || !self.source.is_empty() || self.country_register.is_some() {
            return self.decide(inputs, utc);
        }
        let authority = of.authority.clone().map(|a| Authority { date_of_origin: day(utc), ..a });
        let (designation, register) = (of.cui_block.clone(), of.country_register.clone());
        let request = Request { profile: of.profile, authority, designation, register, ..Request::default() };
        request.decide(inputs.iter().map(Option::as_ref))
    }

    fn authority(&self, utc: &str) -> Result<Option<Authority>> {
        match (&self.classified_by, &self.derived_from, &self.declassify_on) {
            (None, None, None) if self.source.is_empty() => Ok(None),
            (Some(by), Some(from), Some(on)) => Ok(Some(Authority {
                classified_by: by.clone(),
                derived_from: from.clone(),
                declassify_on: on.clone(),
                date_of_origin: day(utc),
                sources: self.source.clone(),
            })),
            _ => Err(Error::policy("--classified-by, --derived-from, --declassify-on")
                .expected("all three lines of the authority block")
                .found("AUTHORITY_INVALID: not all of them")),
        }
    }

    fn designation(&self) -> Option<Designation> {
        Some(Designation {
            controlled_by: self.cui_controlled_by.clone()?,
            office: self.cui_office.clone()?,
            category: self.cui_category.clone()?,
            dissemination: self.cui_dissemination.clone(),
            poc: self.cui_poc.clone()?,
        })
    }
}

/// `YYYYMMDD`.
fn day(utc: &str) -> String {
    utc.get(..10).unwrap_or_default().replace('-', "")
}

/// What a file that goes into a product is marked, by what stands inside it.
///
/// # Errors
/// As [`Marking::parse`]: a marking that is not understood is not passed over.
pub fn carried(name: &str, bytes: &[u8]) -> Result<Option<Marking>> {
    inband::marking(name, bytes).map_err(|e| Error { subject: name.to_owned(), ..e })
}
