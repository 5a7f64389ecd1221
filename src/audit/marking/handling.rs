//! From what the operator asks for and what the inputs carry to what a product is marked, and why.

use super::authority::{Authority, Designation};
use super::register::CountryRegister;
use super::{Marking, Profile};
use crate::{Error, Result};

/// What the operator says.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// None: the inputs' marking.
    pub banner: Option<String>,
    pub profile: Profile,
    /// Why the product is marked above its inputs.
    pub raised_reason: Option<String>,
    pub authority: Option<Authority>,
    pub designation: Option<Designation>,
    /// Country codes beyond those that Orb lists.
    pub register: Option<CountryRegister>,
}

/// A product's marking with everything that belongs to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Handling {
    pub marking: Marking,
    pub profile: Profile,
    pub raised_reason: Option<String>,
    pub authority: Option<Authority>,
    pub designation: Option<Designation>,
    /// Of the user's register the codes that the product or an input is marked with.
    pub register: Option<CountryRegister>,
}

impl From<Marking> for Handling {
    fn from(marking: Marking) -> Self {
        let profile = Profile::Dod;
        Handling { marking, profile, raised_reason: None, authority: None, designation: None, register: None }
    }
}

impl Request {
    /// The marking of a product made of `inputs`, each with the marking that it carries.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`]: `MARKING_UNSUPPORTED`, also for a country code that is on no list; `MARKING_DOWNGRADE` below an input's; `MARKING_REASON_REQUIRED` above
    /// them without a reason; `AUTHORITY_REQUIRED` for classified work without its authority block; `AUTHORITY_INVALID`.
    pub fn decide<'a>(self, inputs: impl IntoIterator<Item = Option<&'a Marking>>) -> Result<Handling> {
        let carried: Vec<&Marking> = inputs.into_iter().flatten().collect();
        let join = Marking::join_all(carried.iter().copied());
        let marking = match &self.banner {
            Some(text) => Marking::read_for_output(text, self.profile)?,
            None => {
                join.check_expressible(self.profile)?;
                join.clone()
            }
        };
        let used = carried.iter().copied().chain([&marking]);
        let register = CountryRegister::used_by(self.register.as_ref(), used)?;
        check_not_below(&marking, &join)?;
        let raised = !carried.is_empty() && marking != join;
        let reason = self.raised_reason.filter(|r| !r.trim().is_empty());
        if raised && reason.is_none() {
            return Err(Error::policy("--raise-reason")
                .expected(format!("why the product is {marking} where its inputs are {join}"))
                .found("MARKING_REASON_REQUIRED: none"));
        }
        let handling = Handling {
            marking,
            profile: self.profile,
            raised_reason: reason.filter(|_| raised),
            authority: self.authority,
            designation: self.designation,
            register,
        };
        handling.check()?;
        Ok(handling)
    }
}

impl Handling {
    /// The blocks that the marking asks for are there and sound.
    fn check(&self) -> Result<()> {
        let level = self.marking.level();
        match &self.authority {
            Some(authority) if level.is_classified() => authority.check()?,
            Some(_) => {
                return Err(Error::policy("--classified-by")
                    .expected("an authority block for classified work only")
                    .found(format!("AUTHORITY_INVALID: one for {}", self.marking)));
            }
            None if level.is_classified() => {
                return Err(Error::policy("classification")
                    .expected(format!("a classification authority block for {}", self.marking))
                    .found("AUTHORITY_REQUIRED: none")
                    .advice("Give --classified-by, --derived-from and --declassify-on (32 CFR 2001.22), and sign with --key FILE."));
            }
            None => {}
        }
        self.designation.as_ref().map_or(Ok(()), Designation::check)
    }
}

/// Refuses a product below what went into it.
///
/// # Errors
/// [`crate::Kind::Policy`], `MARKING_DOWNGRADE`.
pub fn check_not_below(marking: &Marking, inputs: &Marking) -> Result<()> {
    if marking.covers(inputs) {
        return Ok(());
    }
    Err(Error::policy("classification")
        .expected(format!("{} or above, for an input carries {inputs}", marking.join(inputs)))
        .found(format!("MARKING_DOWNGRADE: {marking}"))
        .advice("A product is never marked below its inputs. Only the inputs' owner can change their marking."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;

    fn asked(banner: Option<&str>) -> Request {
        Request { banner: banner.map(str::to_owned), ..Request::default() }
    }

    fn authority() -> Option<Authority> {
        Some(Authority {
            classified_by: "J. Doe, analyst".into(),
            derived_from: "Guide, Agency, 20240105".into(),
            declassify_on: "20400101".into(),
            date_of_origin: "20261121".into(),
            sources: vec![],
        })
    }

    fn code(result: Result<Handling>) -> String {
        let error = result.unwrap_err();
        assert_eq!(error.kind, Kind::Policy);
        error.found.split(':').next().unwrap_or_default().to_owned()
    }

    #[test]
    fn inputs_join_and_are_never_undercut() {
        let secret = Marking::parse("SECRET//REL TO USA, GBR").unwrap();
        let cui = Marking::CUI;
        let of = |request: Request, inputs: &[&Marking]| request.decide(inputs.iter().map(|m| Some(*m)));
        assert_eq!(of(asked(None), &[]).unwrap().marking, Marking::UNCLASSIFIED);
        assert_eq!(of(asked(None), &[&cui]).unwrap().marking, Marking::CUI);
        let joined = Request { authority: authority(), ..asked(None) };
        assert_eq!(of(joined, &[&cui, &secret]).unwrap().marking, secret);
        assert_eq!(code(of(asked(Some("UNCLASSIFIED")), &[&cui])), "MARKING_DOWNGRADE");
        let wider = Request { authority: authority(), ..asked(Some("SECRET//REL TO USA, AUS, GBR")) };
        assert_eq!(code(of(wider, &[&secret])), "MARKING_DOWNGRADE");
        // Above an input: with a reason, which is kept.
        assert_eq!(code(of(asked(Some("CUI")), &[&Marking::UNCLASSIFIED])), "MARKING_REASON_REQUIRED");
        let reason = Some("compilation with the site's name".to_owned());
        let raised = Request { raised_reason: reason.clone(), ..asked(Some("CUI")) };
        assert_eq!(of(raised, &[&Marking::UNCLASSIFIED]).unwrap().raised_reason, reason);
        // Nothing was raised where no input is marked.
        assert_eq!(of(asked(Some("CUI")), &[]).unwrap().raised_reason, None);
    }

    #[test]
    fn classified_work_names_its_authority() {
        assert_eq!(code(asked(Some("SECRET")).decide([])), "AUTHORITY_REQUIRED");
        let complete = Request { authority: authority(), ..asked(Some("CONFIDENTIAL//NOFORN")) };
        assert!(complete.clone().decide([]).is_ok());
        assert_eq!(code(Request { banner: Some("CUI".into()), ..complete }.decide([])), "AUTHORITY_INVALID");
    }

    #[test]
    fn profiles_of_cui() {
        assert_eq!(code(asked(Some("CUI//SP-CTI")).decide([])), "MARKING_UNSUPPORTED");
        let isoo = Request { profile: Profile::Isoo, ..asked(Some("CUI//SP-CTI//NOFORN")) };
        assert_eq!(isoo.decide([]).unwrap().marking.banner(), "CUI//SP-CTI//NOFORN");
        // An input's detail cannot be lost in the DoD banner.
        let input = Marking::parse("CUI//SP-CTI").unwrap();
        assert_eq!(code(asked(None).decide([Some(&input)])), "MARKING_UNSUPPORTED");
        assert_eq!(code(asked(Some("CUI")).decide([Some(&input)])), "MARKING_DOWNGRADE");
    }
}
