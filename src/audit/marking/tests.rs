//! The grammar, the lattice, and the manual's roll-up table.

use proptest::prelude::*;
use proptest::sample::{select, subsequence};

use super::*;
use crate::Kind;

fn read(text: &str) -> Marking {
    Marking::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"))
}

/// Any marking that can be written.
fn marking() -> impl Strategy<Value = Marking> {
    let codes = || subsequence(vec!["AUS", "CAN", "FRA", "GBR", "NZL", "ACGU", "FVEY", "TEYE"], 0..4);
    let release = prop_oneof![
        2 => Just(vec![]),
        1 => Just(vec!["NOFORN".to_owned()]),
        6 => (codes(), codes(), any::<bool>()).prop_map(|(rel, display, relido)| {
            let display: Vec<&str> = display.into_iter().filter(|d| !rel.contains(d)).collect();
            let mut all = Vec::new();
            all.extend((!rel.is_empty()).then(|| format!("REL TO USA, {}", rel.join(", "))));
            all.extend((relido && display.is_empty()).then(|| "RELIDO".to_owned()));
            all.extend((!display.is_empty()).then(|| format!("DISPLAY ONLY {}", display.join(", "))));
            all
        }),
    ];
    let controls = subsequence(vec!["ORCON", "IMCON", "PROPIN", "FISA"], 0..=4);
    let cui = (
        subsequence(vec!["SP-CTI", "SP-EXPT", "CTI", "PRVCY"], 0..=4),
        subsequence(vec!["FED ONLY", "DELIB", "NOCON"], 0..=3),
    );
    (select(Level::ALL.to_vec()), release, controls, any::<bool>(), cui).prop_filter_map(
        "a marking",
        |(level, release, controls, limdis, (categories, limits))| {
            let mut text = level.name().to_owned();
            let mut put = |entries: Vec<String>| {
                if !entries.is_empty() {
                    text.push_str("//");
                    text.push_str(&entries.join("/"));
                }
            };
            let owned = |all: Vec<&str>| all.into_iter().map(str::to_owned).collect::<Vec<_>>();
            if level == Level::Cui {
                put(owned(categories));
                put([owned(limits), release].concat());
            } else {
                put([owned(controls), release].concat());
                put(limdis.then(|| "LIMDIS".to_owned()).into_iter().collect());
            }
            Marking::parse(&text).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn join_is_a_semilattice(a in marking(), b in marking(), c in marking()) {
        prop_assert_eq!(a.join(&a), a.clone());
        let ab = a.join(&b);
        prop_assert_eq!(&ab, &b.join(&a));
        prop_assert_eq!(ab.join(&c), a.join(&b.join(&c)), "{} {} {}", a, b, c);
        prop_assert!(ab.covers(&a) && ab.covers(&b), "{} {} {}", a, b, ab);
        prop_assert!(ab.level() >= a.level() && ab.level() >= b.level());
        // The least upper bound, and monotone: whatever covers both covers the join, and joining keeps the order.
        let abc = ab.join(&c);
        prop_assert!(abc.covers(&ab) && a.join(&c).join(&ab) == abc);
        prop_assert_eq!(Marking::UNCLASSIFIED.join(&a), a.clone());
    }

    #[test]
    fn what_is_written_is_read_again(a in marking(), b in marking()) {
        for m in [a.clone(), b.clone(), a.join(&b)] {
            if m.check_expressible(Profile::Isoo).is_ok() {
                prop_assert_eq!(&read(&m.banner()), &m, "{}", m);
                prop_assert!(m.line().is_ascii() && m.portion().starts_with('('));
            }
        }
    }

    #[test]
    fn nothing_else_is_read(text in "[A-Z/ ,-]{0,24}") {
        match Marking::parse(&text) {
            Ok(m) => prop_assert_eq!(read(&m.banner()), m),
            Err(e) => prop_assert!(e.kind == Kind::Policy && e.found.contains("MARKING_UNSUPPORTED")),
        }
    }
}

#[test]
fn the_order_is_the_handling_order() {
    for pair in Level::ALL.windows(2) {
        let (low, high) = (Marking::of(pair[0]), Marking::of(pair[1]));
        assert!(pair[0] < pair[1] && low.join(&high) == high && high.covers(&low) && !low.covers(&high));
    }
    assert_eq!(Marking::join_all([]), Marking::UNCLASSIFIED);
    assert_eq!(Marking::join_all([&Marking::CUI, &Marking::SECRET, &Marking::UNCLASSIFIED]), Marking::SECRET);
}

#[test]
fn banners_and_portions() {
    for (text, banner, portion) in [
        ("UNCLASSIFIED", "", "(U)"),
        ("CUI", "", "(CUI)"),
        ("CONTROLLED", "CUI", "(CUI)"),
        ("CONFIDENTIAL", "", "(C)"),
        ("SECRET//NOFORN", "", "(S//NF)"),
        ("TOP SECRET//ORCON/NOFORN", "", "(TS//OC/NF)"),
        ("SECRET//NOFORN/ORCON", "SECRET//ORCON/NOFORN", "(S//OC/NF)"),
        ("SECRET//REL TO USA, GBR, AUS", "SECRET//REL TO USA, AUS, GBR", "(S//REL TO USA, AUS, GBR)"),
        ("SECRET//REL TO USA, FVEY, DEU", "SECRET//REL TO USA, DEU, FVEY", "(S//REL TO USA, DEU, FVEY)"),
        ("SECRET//IMCON/PROPIN/REL TO USA, GBR/RELIDO/FISA", "", "(S//IMC/PR/REL TO USA, GBR/RELIDO/FISA)"),
        ("SECRET//REL TO USA, GBR/DISPLAY ONLY FRA", "", "(S//REL TO USA, GBR/DISPLAY ONLY FRA)"),
        ("UNCLASSIFIED//LIMDIS", "", "(U//DS)"),
        ("SECRET//NOFORN//LIMDIS", "", "(S//NF//DS)"),
        ("CUI//SP-CTI/PRVCY//FED ONLY/NOFORN", "", "(CUI//SP-CTI/PRVCY//FED ONLY/NF)"),
        ("CUI//NOFORN", "", "(CUI//NF)"),
    ] {
        let m = read(text);
        assert_eq!(
            (m.banner().as_str(), m.portion().as_str()),
            (if banner.is_empty() { text } else { banner }, portion)
        );
    }
    assert_eq!(read("CUI//SP-CTI/ZZTOP").unknown_categories(), ["ZZTOP"]);
    let ism = read("SECRET//ORCON/REL TO USA, GBR//LIMDIS").ism();
    assert_eq!((ism.classification.as_str(), ism.dissemination_controls), ("S", vec!["OC".into(), "REL".into()]));
    assert_eq!((ism.releasable_to, ism.non_ic_markings), (vec!["USA".into(), "GBR".into()], vec!["DS".to_owned()]));
}

#[test]
fn what_is_refused_says_why() {
    for (text, why) in [
        ("", "no level"),
        ("secret", "upper case"),
        (" SECRET", "upper case"),
        ("S", "spelled out"),
        ("TS", "spelled out"),
        ("FOUO", "retired"),
        ("UNCLASSIFIED//FOUO", "retired"),
        ("UNCLASSIFIED//FOR OFFICIAL USE ONLY", "retired"),
        ("TOP SECRET//SI", "SCI"),
        ("TOP SECRET//SI-G/TK//NOFORN", "SCI"),
        ("TOP SECRET//HCS-P", "SCI"),
        ("SECRET//SAR-XY", "special access"),
        ("SECRET//RD", "Atomic Energy"),
        ("SECRET//FGI DEU", "foreign"),
        ("//NATO SECRET", "non-US"),
        ("//JOINT SECRET USA GBR", "non-US"),
        ("NATO SECRET", "NATO"),
        ("RESTRICTED", "no level"),
        ("SECRET//NOFORN/REL TO USA, GBR", "beside"),
        ("SECRET//NOFORN/RELIDO", "beside"),
        ("SECRET//RELIDO/DISPLAY ONLY GBR", "RELIDO beside"),
        ("SECRET//REL TO USA", "at least one more"),
        ("SECRET//REL TO GBR", "USA"),
        ("SECRET//REL TO USA, QQQ", "QQQ"),
        ("SECRET//REL TO USA,GBR", "USA,GBR"),
        ("SECRET//REL TO USA, GBR, GBR", "twice"),
        ("SECRET//DISPLAY ONLY USA", "beside USA"),
        ("SECRET//USA/GBR EYES ONLY", "no control"),
        ("UNCLASSIFIED//NOFORN", "classified levels"),
        ("UNCLASSIFIED//ORCON", "classified levels"),
        ("CONFIDENTIAL//IMCON/NOFORN", "IMCON"),
        ("SECRET//IMCON", "IMCON"),
        ("SECRET//", "empty"),
        ("SECRET////NOFORN", "empty"),
        ("SECRET//NOFORN//NOFORN", "no control"),
        ("SECRET//ORCON/ORCON", "twice"),
        ("SECRET//LIMDIS/NOFORN", "LIMDIS"),
        ("SECRET//CUI", "CUI"),
        ("CUI//sp-cti", "no category"),
        ("CUI//SP-CTI//RELIDO", "no limited"),
        ("CUI//SP-CTI//NOFORN//FED ONLY", "more than"),
        ("CUI//SECRET//ORCON", "no limited"),
    ] {
        let error = Marking::parse(text).expect_err(text);
        assert_eq!(error.kind, Kind::Policy, "{text}");
        assert!(error.found.contains("MARKING_UNSUPPORTED") && error.found.contains(why), "{text}: {error}");
    }
}

/// IC Markings Manual 2016, section D.2, Table 3. Rows whose second kind of portion this grammar refuses (SBU-NF, LES-NF,
/// EYES ONLY) are rows of refusal. Row 17 leaves a choice by date of origin, of which the stricter is taken.
#[test]
fn release_rolls_up_by_the_27_rows() {
    const REFUSED: &str = "refused";
    let rows: [(u32, &str, &str, &str); 30] = [
        (1, "NOFORN", "", "NOFORN"),
        (2, "NOFORN", "REL TO USA, GBR", "NOFORN"),
        (2, "NOFORN", "RELIDO", "NOFORN"),
        (2, "NOFORN", "DISPLAY ONLY GBR", "NOFORN"),
        (2, "NOFORN", "USA/GBR EYES ONLY", REFUSED),
        (3, "NOFORN", "SBU-NF", REFUSED),
        (4, "", "SBU-NF", REFUSED),
        (5, "RELIDO", "SBU-NF", REFUSED),
        (6, "NOFORN", "LES-NF", REFUSED),
        (7, "", "LES-NF", REFUSED),
        (8, "RELIDO", "LES-NF", REFUSED),
        (9, "REL TO USA, GBR", "REL TO USA, AUS", "NOFORN"),
        (10, "REL TO USA, GBR", "RELIDO", "NOFORN"),
        (11, "REL TO USA, GBR", "DISPLAY ONLY FRA", "NOFORN"),
        (12, "REL TO USA, GBR/RELIDO", "", "NOFORN"),
        (13, "REL TO USA, GBR", "USA/AUS EYES ONLY", REFUSED),
        (14, "REL TO USA, GBR", "SBU-NF", REFUSED),
        (15, "REL TO USA, GBR", "LES-NF", REFUSED),
        (16, "REL TO USA, GBR", "", "NOFORN"),
        (17, "RELIDO", "", "NOFORN"),
        (18, "RELIDO", "DISPLAY ONLY GBR", "NOFORN"),
        (19, "DISPLAY ONLY GBR", "", "NOFORN"),
        (20, "DISPLAY ONLY GBR", "DISPLAY ONLY FRA", "NOFORN"),
        (21, "REL TO USA, AUS, GBR", "REL TO USA, CAN, GBR", "REL TO USA, GBR"),
        (22, "REL TO USA, GBR", "USA/GBR EYES ONLY", REFUSED),
        (23, "REL TO USA, FVEY", "REL TO USA, DEU, GBR", "REL TO USA, GBR"),
        (24, "RELIDO", "RELIDO", "RELIDO"),
        (25, "DISPLAY ONLY FRA, GBR", "DISPLAY ONLY DEU, GBR", "DISPLAY ONLY GBR"),
        (26, "DISPLAY ONLY FRA, GBR", "REL TO USA, DEU, GBR", "DISPLAY ONLY GBR"),
        (
            27,
            "REL TO USA, AUS, GBR/DISPLAY ONLY FRA",
            "REL TO USA, GBR/DISPLAY ONLY AUS, FRA",
            "REL TO USA, GBR/DISPLAY ONLY AUS, FRA",
        ),
    ];
    let seen: BTreeSet<u32> = rows.iter().map(|r| r.0).collect();
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), (1..=27).collect::<Vec<_>>());
    for (row, one, other, banner) in rows {
        for level in [Level::Confidential, Level::Secret, Level::TopSecret] {
            let with = |entry: &str| {
                let text =
                    if entry.is_empty() { level.name().to_owned() } else { format!("{}//{entry}", level.name()) };
                Marking::parse(&text)
            };
            let (Ok(one), other) = (with(one), with(other)) else { panic!("row {row}") };
            match other {
                Ok(other) => {
                    assert_eq!(one.join(&other), with(banner).unwrap(), "row {row}");
                    assert_eq!(other.join(&one), with(banner).unwrap(), "row {row}");
                }
                Err(error) => assert!(banner == REFUSED && error.found.contains("MARKING_UNSUPPORTED"), "row {row}"),
            }
        }
    }
    // What is not classified counts as no portion without release.
    assert_eq!(read("SECRET//REL TO USA, GBR").join(&Marking::UNCLASSIFIED), read("SECRET//REL TO USA, GBR"));
    assert_eq!(read("SECRET//REL TO USA, GBR").join(&Marking::CUI), read("SECRET//REL TO USA, GBR"));
}
