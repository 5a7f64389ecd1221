//! The code lists behind the folder names of model libraries: FACC labels, DIS kinds, domains, categories and countries.
//!
//! Source: the code lists of OGC CDB 1.x Volume 2 (Feature_Data_Dictionary, Moving_Model_Codes, DIS_Country_Codes), spelt
//! as there. A store that has lists of its own is named by them; of the dictionary of features only what stands as a body
//! of its own is built in.

use super::dis::EntityType;
use super::store::{self, Store};
use super::xml::{self, Element};
use crate::{Error, Result};

const COUNTRIES: &str = include_str!("codes/countries.txt");
const KINDS: &str = "0=Other 1=Platform 2=Munitions 3=Life_Form 4=Environmental 5=Cultural_Feature 6=Supply 7=Radio \
                     8=Expendable 9=Sensor_Emitter";
const DOMAINS: &str = "0=Other 1=Land 2=Air 3=Surface 4=Subsurface 5=Space";
const TARGETS: &str = "0=Other 1=Anti-Air 2=Anti-Armor 3=Anti-Guided_Weapon 4=Antiradar 5=Antisatellite 6=Antiship \
                       7=Antisubmarine 8=Antipersonnel 9=Battlefield_Support 10=Strategic 11=Tactical \
                       12=Directed_Energy_Weapon";
const LAND: &str = "0=Other 1=Tank 2=Armored_Fighting_Vehicle 3=Armored_Utility_Vehicle 4=Self-propelled_Artillery \
                    5=Towed_Artillery 6=Small_Wheeled_Utility_Vehicle 7=Large_Wheeled_Utility_Vehicle \
                    8=Small_Tracked_Utility_Vehicle 9=Large_Tracked_Utility_Vehicle 10=Mortar 11=Mine_Plow 12=Mine_Rake \
                    13=Mine_Roller 14=Cargo_Trailer 15=Fuel_Trailer 16=Generator_Trailer 17=Water_Trailer \
                    18=Engineer_Equipment 19=Heavy_Equipment_Trailer 20=Maintenance_Equipment_Trailer 21=Limber \
                    22=Chemical_Decontamination_Trailer 23=Warning_System 24=Train_Engine 25=Train_Car 26=Train_Caboose \
                    27=Civilian_Vehicle 28=Air-Missile_Defense_Equipment 29=C3I_System 30=Operations_Facility \
                    31=Intelligence_Facility 32=Surveillance_Facility 33=Communication_Facility 34=Command_Facility \
                    35=C4I_Facility 36=Control_Facility 37=Fire_Control_Facility 38=Missile_Defense_Facility \
                    39=Field_Command_Post 40=Observation_Post";
const AIR: &str = "0=Other 1=Fighter-Air_Defense 2=Attack-Strike 3=Bomber 4=Cargo-Tanker 5=ASW-Patrol-Observation 6=EW \
                   7=Reconnaissance 8=Surveillance-C2 20=Attack_Helo 21=Utility_Helo 22=ASW_Patrol_Helo 23=Cargo_Helo \
                   24=Observation_Helo 25=Special_Ops_Helo 40=Trainer 50=Unmanned 57=Commercial_Aircraft";
const SURFACE: &str = "0=Other 1=Carrier 2=Command_Ship_Cruiser 3=Guided_Missile_Cruiser 4=Guided_Missile_Destroyer \
                       5=Destroyer 6=Guided_Missile_Frigate 7=Light-Patrol_Craft 8=Mine_Countermeasure_Ship-Craft \
                       9=Dock_Landing_Ship 10=Tank_Landing_Ship 11=Landing_Craft 12=Light_Carrier \
                       13=Cruiser-Helo_Carrier 14=Hydrofoil 15=Air_Cushion-Surface_Effect 16=Auxiliary \
                       17=Merchant_Marine 18=Utility 50=Frigate 51=Battleship 52=Heavy_Cruiser 53=Destroyer_Tender \
                       54=Amphibious_Assault_Ship 55=Amphibious_Cargo_Ship 56=Amphibious_Transport_Dock \
                       57=Ammunition_Ship 58=Combat_Stores_Ship 59=SURTASS 60=Fast_Combat_Support_Ship \
                       61=Non-Combatant_Ship";
const SUBSURFACE: &str = "0=Other 1=SSBN 2=SSGN 3=SSN 4=SSG 5=SS 6=SSAN 7=SSA";
const SPACE: &str = "0=Other 1=Manned 2=Unmanned 3=Booster";
const MUNITIONS: &str = "0=Other 1=Guided 2=Ballistic 3=Fixed";
const RADIO: &str = "0=Other 1=Voice_Link 2=Data_Link 3=Voice_and_Data_Link 4=ILS_Glideslope_Transmitter \
                     5=ILS_Localizer_Transmitter 6=ILS_Outer_Marker_Beacon 7=ILS_Middle_Marker_Beacon \
                     8=ILS_Inner_Marker_Beacon 9=ILS_Receiver 10=TACAN_TX-Moving 11=TACAN_RX 12=TACAN_TXRX-Moving \
                     13=VOR_TX_Fixed 14=VOR_with_DME 15=VOR-ILS_Moving 16=VOR_TACAN 17=NDB_TX 18=NDB_RX \
                     19=NDB_with_DME 20=DME";
const SENSORS: &str = "0=Other 1=Multi-spectral 2=RF_Active 3=RF_Passive 4=Optical 5=Electro-Optical 6=Seismic \
                       7=Chemical_point_detector 8=Chemical_standoff 9=Thermal 10=Acoustic_Active 11=Acoustic_Passive \
                       12=Contact-Pressure 13=Electro-Magnetic_Radiation 14=Particle_Radiation 15=Magnetic \
                       16=Gravitational";
/// Category, subcategory and type of features, each followed by its label.
const FEATURES: &str = "A=Culture AL=Misc_Feature AL015=Building AL099=Hut AL100=Hut AL101=Cabin AL110=Light_Standard \
                        AL130=Monument AL200=Ruins AL220=Steeple AL240=Tower-NC AL241=Tower_General AL260=Wall \
                        AL375=Castle AM=Storage AM011=Container AM020=Grain_Silo AM030=Grain_Elevator AM070=Tank \
                        AM080=Water_Tower AM091=Silo AT=Comm AT040=Power_Pylon U=EDD UA=Abstract_Object UA004=Furniture \
                        UA005=Man_Made_Object UA009=Object UC=Administration UC001=Flagpole UD=Agriculture UD001=Haystack";

fn find(list: &'static str, code: &str) -> Option<String> {
    list.split_whitespace().find_map(|entry| entry.strip_prefix(code)?.strip_prefix('=')).map(String::from)
}

fn categories(kind: u8, domain: u8) -> &'static str {
    match (kind, domain) {
        (1, 1) => LAND,
        (1, 2) => AIR,
        (1, 3) => SURFACE,
        (1, 4) => SUBSURFACE,
        (1, 5) => SPACE,
        (2, 1..=12) => MUNITIONS,
        (3, 1) => "0=Other 1=Dismounted_Infantry 5=Animal",
        (3, 2) => "0=Other 1=Parachutist 2=Bird 3=Flock_Of_Birds",
        (3, 3) => "0=Other 1=Swimmer 2=Occupied_Life_Raft",
        (3, 4) => "0=Other 1=Diver 2=School_Of_Fish 3=School_Of_Shrimp 4=Whale",
        (3, 5) => "0=Other 1=Astronaut",
        (7, 1) => RADIO,
        (8, 2) => "0=Other 1=Chaff 2=Flare 3=Combined_Chaff_Flare 4=Active_Emitter 5=Passive_Decoy",
        (8, 3) => "0=Other 2=Flare 4=Active_Emitter 5=Passive_Decoy",
        (8, 4) => "0=Other 4=Active_Emitter 5=Passive_Decoy",
        (9, 1..=5) => SENSORS,
        _ => "0=Other",
    }
}

/// The labels of a store: its own code lists where it has them, before those that are built in.
#[derive(Debug, Default)]
pub struct Labels {
    features: Option<Element>,
    moving: Option<Element>,
    countries: Option<Element>,
}

impl Labels {
    /// # Errors
    /// [`Error::Unsupported`] for a list that is no XML.
    pub fn read(store: &dyn Store) -> Result<Labels> {
        let list = |name: &str| {
            let path = format!("Metadata/{name}.xml");
            let text = store::read_text(store, &path)?;
            text.map(|t| xml::parse(&t).map_err(|e| store::unreadable(&path, &e))).transpose()
        };
        Ok(Labels {
            features: list("Feature_Data_Dictionary")?,
            moving: list("Moving_Model_Codes")?,
            countries: list("DIS_Country_Codes")?,
        })
    }

    /// The labels of category, subcategory and type of a feature code; each `None` where no list has it.
    pub fn feature(&self, facc: &str) -> [Option<String>; 3] {
        let at = |n: usize| facc.get(..n).unwrap_or_default();
        let label = |e: Option<&Element>| e.and_then(|e| e.child_text("Label")).map(String::from);
        let root = self.features.as_ref();
        let category = root.and_then(|e| coded(e, "Category", at(1)));
        let subcategory = category.and_then(|e| coded(e, "Subcategory", facc.get(1..2).unwrap_or_default()));
        let kind = subcategory.and_then(|e| coded(e, "Feature_Type", facc.get(2..).unwrap_or_default()));
        [(category, 1), (subcategory, 2), (kind, 5)].map(|(e, n)| label(e).or_else(|| find(FEATURES, at(n))))
    }

    /// The names of kind, domain, country and category of an entity type.
    pub fn entity(&self, e: &EntityType) -> [Option<String>; 4] {
        let name = |e: Option<&Element>| e.and_then(|e| e.attribute("name")).map(String::from);
        let root = self.moving.as_ref();
        let kind = root.and_then(|r| coded(r, "Kind", &e.kind.to_string()));
        let domain = kind.and_then(|k| coded(k, "Domain", &e.domain.to_string()));
        let category = domain.and_then(|d| coded(d, "Category", &e.category.to_string()));
        let country = self.countries.as_ref().and_then(|c| coded(c, "Country", &e.country.to_string()));
        let domains = match e.kind {
            2 => TARGETS,
            0 | 6 => "0=Other",
            _ => DOMAINS,
        };
        [
            name(kind).or_else(|| find(KINDS, &e.kind.to_string())),
            name(domain).or_else(|| find(domains, &e.domain.to_string())),
            name(country).or_else(|| find(COUNTRIES, &e.country.to_string())),
            name(category).or_else(|| find(categories(e.kind, e.domain), &e.category.to_string())),
        ]
    }
}

/// The child of a name and a code, whether or not either is padded with zeros.
fn coded<'a>(parent: &'a Element, name: &'a str, code: &str) -> Option<&'a Element> {
    let bare = |c: &str| c.trim().trim_start_matches('0').to_string();
    parent.children_named(name).find(|c| c.attribute("code").is_some_and(|found| bare(found) == bare(code)))
}

/// What to say where a list lacks a code.
pub fn unknown(what: &str, code: &str, list: &str) -> Error {
    Error::Unsupported {
        format: "CDB codes",
        what: format!(
            "no label is known for {what} {code}, and folders are named by it; put the standard's {list}.xml into the store's \
             Metadata, or choose another code"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::super::store::{Empty, Memory};
    use super::*;

    fn known<const N: usize>(labels: [Option<String>; N]) -> String {
        labels.map(|l| l.unwrap_or("?".into())).join("/")
    }

    #[test]
    fn the_standard_s_examples_have_their_names() {
        let lists = Labels::read(&Empty).unwrap();
        let entity = |text: &str| known(lists.entity(&EntityType::parse(text).unwrap()));
        assert_eq!(entity("1.1.225.1.1.8.0"), "Platform/Land/United_States/Tank");
        assert_eq!(entity("1.2.225.21.1.0.0"), "Platform/Air/United_States/Utility_Helo");
        assert_eq!(entity("2.9.224.2"), "Munitions/Battlefield_Support/United_Kingdom/Ballistic");
        assert_eq!(entity("6.0.78.0"), "Supply/Other/Germany/Other");
        assert_eq!(entity("1.1.999.99"), "Platform/Land/?/?");
        assert_eq!(known(lists.feature("AL015")), "Culture/Misc_Feature/Building");
        assert_eq!(known(lists.feature("UA005")), "EDD/Abstract_Object/Man_Made_Object");
        assert_eq!(known(lists.feature("AL999")), "Culture/Misc_Feature/?");
        assert_eq!(COUNTRIES.split_whitespace().count(), 263);
    }

    #[test]
    fn a_store_s_own_lists_come_first() {
        let mut store = Memory::default();
        let mut put = |name: &str, text: &str| store.files.insert(format!("Metadata/{name}.xml"), text.into());
        put(
            "Moving_Model_Codes",
            "<Moving_Model_Codes><Kind code=\"1\" name=\"Platform\"><Domain code=\"1\" name=\"Land\">\
             <Category code=\"99\" name=\"Rickshaw\"/></Domain></Kind></Moving_Model_Codes>",
        );
        put("DIS_Country_Codes", "<DIS_Country_Codes><Country code=\"300\" name=\"Utopia\"/></DIS_Country_Codes>");
        put(
            "Feature_Data_Dictionary",
            "<Feature_Data_Dictionary><Category code=\"A\"><Label>Culture</Label><Subcategory code=\"L\"><Label>Misc_Feature\
             </Label><Feature_Type code=\"019\"><Label>Shed</Label></Feature_Type></Subcategory></Category>\
             </Feature_Data_Dictionary>",
        );
        let lists = Labels::read(&store).unwrap();
        let entity = |text: &str| known(lists.entity(&EntityType::parse(text).unwrap()));
        assert_eq!(entity("1.1.300.99"), "Platform/Land/Utopia/Rickshaw");
        assert_eq!(entity("1.1.225.1"), "Platform/Land/United_States/Tank", "what they lack is built in");
        assert_eq!(known(lists.feature("AL019")), "Culture/Misc_Feature/Shed");
    }
}
