//! Metadata with security constraints: ISO 19115:2003 in the XML of ISO/TS 19139:2007, which catalogues and GIS read.

use orb_formats::xml::{comment, escape};

use super::{Georeference, bounds};

const CODES: &str = "http://standards.iso.org/iso/19139/resources/gmxCodelists.xml";

fn code(list: &str, value: &str) -> String {
    format!("<gmd:{list} codeList=\"{CODES}#{list}\" codeListValue=\"{value}\">{value}</gmd:{list}>")
}

fn text(value: &str) -> String {
    format!("<gco:CharacterString>{}</gco:CharacterString>", escape(value))
}

/// The code list's name of a banner (MD_ClassificationCode); CUI is `restricted`, and says so in words.
fn classification(banner: &str) -> &'static str {
    match banner.split("//").next().unwrap_or_default() {
        "TOP SECRET" => "topSecret",
        "SECRET" => "secret",
        "CONFIDENTIAL" => "confidential",
        "UNCLASSIFIED" => "unclassified",
        _ => "restricted",
    }
}

/// An absolute accuracy: one standard deviation.
fn accuracy(kind: &str, unit: &str, name: &str, value: f64) -> String {
    format!(
        "<gmd:report><gmd:{kind}><gmd:nameOfMeasure>{}</gmd:nameOfMeasure><gmd:result><gmd:DQ_QuantitativeResult><gmd:valueUnit \
         xlink:href=\"http://www.opengis.net/def/uom/UCUM/0/{unit}\"/><gmd:value><gco:Record>{value:.4}</gco:Record></gmd:value>\
         </gmd:DQ_QuantitativeResult></gmd:result></gmd:{kind}></gmd:report>",
        text(name)
    )
}

pub(super) fn write(g: &Georeference) -> String {
    let [west, south, east, north] = bounds(&g.footprint);
    let date = g.utc.get(..10).unwrap_or("1970-01-01");
    let party = |role: &str| {
        format!(
            "<gmd:CI_ResponsibleParty><gmd:organisationName>{}</gmd:organisationName><gmd:role>{}</gmd:role></gmd:CI_ResponsibleParty>",
            text("the operator of the record that lies beside this file"),
            code("CI_RoleCode", role)
        )
    };
    let decimal = |name: &str, v: f64| format!("<gmd:{name}><gco:Decimal>{v}</gco:Decimal></gmd:{name}>");
    let (low, high) = (g.placement.origin.height, g.placement.origin.height + g.size[2]);
    let u = &g.uncertainty;
    let quality = [
        accuracy(
            "DQ_AbsoluteExternalPositionalAccuracy",
            "m",
            "horizontal position, one standard deviation",
            u.horizontal,
        ),
        accuracy("DQ_AbsoluteExternalPositionalAccuracy", "m", "vertical position, one standard deviation", u.vertical),
        accuracy("DQ_QuantitativeAttributeAccuracy", "deg", "heading, one standard deviation", u.heading),
        accuracy("DQ_QuantitativeAttributeAccuracy", "%25", "scale, one standard deviation", u.scale * 100.0),
    ]
    .concat();
    let abstract_text = format!(
        "A 3D model reconstructed from one photo: {:.2} m wide, {:.2} m deep, {:.2} m high, heading {:.1} degrees.",
        g.size[0], g.size[1], g.size[2], g.placement.heading
    );
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{marking}\n<gmd:MD_Metadata xmlns:gmd=\"http://www.isotc211.org/2005/gmd\" \
         xmlns:gco=\"http://www.isotc211.org/2005/gco\" xmlns:gml=\"http://www.opengis.net/gml\" \
         xmlns:xlink=\"http://www.w3.org/1999/xlink\"><gmd:fileIdentifier>{id}</gmd:fileIdentifier>\
         <gmd:language>{language}</gmd:language><gmd:characterSet>{charset}</gmd:characterSet>\
         <gmd:hierarchyLevel>{level}</gmd:hierarchyLevel><gmd:contact>{contact}</gmd:contact>\
         <gmd:dateStamp><gco:Date>{date}</gco:Date></gmd:dateStamp><gmd:metadataStandardName>{standard}</gmd:metadataStandardName>\
         <gmd:metadataStandardVersion>{version}</gmd:metadataStandardVersion>\
         <gmd:referenceSystemInfo><gmd:MD_ReferenceSystem><gmd:referenceSystemIdentifier><gmd:RS_Identifier><gmd:code>{crs}</gmd:code>\
         <gmd:codeSpace>{epsg}</gmd:codeSpace></gmd:RS_Identifier></gmd:referenceSystemIdentifier></gmd:MD_ReferenceSystem>\
         </gmd:referenceSystemInfo><gmd:identificationInfo><gmd:MD_DataIdentification><gmd:citation><gmd:CI_Citation>\
         <gmd:title>{title}</gmd:title><gmd:date><gmd:CI_Date><gmd:date><gco:Date>{date}</gco:Date></gmd:date>\
         <gmd:dateType>{creation}</gmd:dateType></gmd:CI_Date></gmd:date></gmd:CI_Citation></gmd:citation>\
         <gmd:abstract>{abstract_text}</gmd:abstract><gmd:pointOfContact>{originator}</gmd:pointOfContact>\
         <gmd:resourceConstraints><gmd:MD_SecurityConstraints><gmd:classification>{class}</gmd:classification>\
         <gmd:userNote>{banner}</gmd:userNote><gmd:classificationSystem>{system}</gmd:classificationSystem>\
         </gmd:MD_SecurityConstraints></gmd:resourceConstraints><gmd:language>{language}</gmd:language>\
         <gmd:topicCategory><gmd:MD_TopicCategoryCode>structure</gmd:MD_TopicCategoryCode></gmd:topicCategory>\
         <gmd:extent><gmd:EX_Extent><gmd:geographicElement><gmd:EX_GeographicBoundingBox>{box_west}{box_east}{box_south}{box_north}\
         </gmd:EX_GeographicBoundingBox></gmd:geographicElement><gmd:verticalElement><gmd:EX_VerticalExtent>\
         <gmd:minimumValue><gco:Real>{low:.4}</gco:Real></gmd:minimumValue><gmd:maximumValue><gco:Real>{high:.4}</gco:Real></gmd:maximumValue>\
         <gmd:verticalCRS xlink:href=\"http://www.opengis.net/def/crs/EPSG/0/4979\"/></gmd:EX_VerticalExtent></gmd:verticalElement>\
         </gmd:EX_Extent></gmd:extent></gmd:MD_DataIdentification></gmd:identificationInfo>\
         <gmd:dataQualityInfo><gmd:DQ_DataQuality><gmd:scope><gmd:DQ_Scope><gmd:level>{level}</gmd:level></gmd:DQ_Scope></gmd:scope>\
         {quality}<gmd:lineage><gmd:LI_Lineage><gmd:statement>{lineage}</gmd:statement></gmd:LI_Lineage></gmd:lineage>\
         </gmd:DQ_DataQuality></gmd:dataQualityInfo></gmd:MD_Metadata>\n",
        marking = comment(&format!("CLASSIFICATION: {}", g.banner)),
        id = text(&g.name),
        language = "<gmd:LanguageCode codeList=\"http://www.loc.gov/standards/iso639-2/\" codeListValue=\"eng\">eng</gmd:LanguageCode>",
        charset = code("MD_CharacterSetCode", "utf8"),
        level = code("MD_ScopeCode", "model"),
        contact = party("pointOfContact"),
        standard = text("ISO 19115:2003"),
        version = text("ISO/TS 19139:2007"),
        crs = text("4979"),
        epsg = text("EPSG"),
        title = text(&g.name),
        creation = code("CI_DateTypeCode", "creation"),
        abstract_text = text(&abstract_text),
        originator = party("originator"),
        class = code("MD_ClassificationCode", classification(&g.banner)),
        banner = text(&g.banner),
        system = text("DoD"),
        box_west = decimal("westBoundLongitude", west),
        box_east = decimal("eastBoundLongitude", east),
        box_south = decimal("southBoundLatitude", south),
        box_north = decimal("northBoundLatitude", north),
        lineage = text(&g.lineage.join(" ")),
    )
}
