//! Names of the sources of the shipped catalogue. `docs/reference/parts.md` has each of them in full.

use crate::text::catalog::words;

/// Keys of the sources and the titles of the documents. A customer reads them in the bill: a title says where data are a copy.
const SOURCES: [(&str, &str); 29] = [
    ("apex-ab", "Apex AB/ABR catalogue (copied table, unverified)"),
    ("apex-ae", "Apex AE/AER catalogue (copied table, unverified)"),
    ("apex-pii", "Apex PII/PIIR catalogue (copied table, unverified)"),
    ("beckhoff-ag2250", "Beckhoff infosys, AG2250"),
    ("beckhoff-ag2400", "Beckhoff infosys, AG2400"),
    ("beckhoff-ag3400", "Beckhoff infosys, AG3400"),
    ("ctrlx-mc20", "ctrlX MC20 (table of a private project, unverified)"),
    ("ctrlx-xc20", "ctrlX XC20 (table of a private project, unverified)"),
    ("dealer-j2s", "sande-elec.com, MR-J2S"),
    ("fr-e800", "FR-E800 catalogue L(na)06130-J, p.81-83 (copied table, unverified)"),
    ("gearbox-configurator", "Motor table of a gear maker’s selector, unverified"),
    ("hg-kn", "mitsubishielectric.com, MELSERVO-JE HG-KN"),
    ("hk-st-g5", "MELSERVO-J5 HK series manual, p.166"),
    ("j2s-catalogue", "J2S motor catalogue, p.36 (copied table, unverified)"),
    ("lbnl", "LBNL Buildings library, InductionMotors.Data"),
    ("meldas-hc", "MELDAS HC series manual, p.13-15"),
    ("mr-j2s", "MR-J2S-A/-B manuals, 1.6 (copied table, unverified)"),
    ("mr-j4", "MR-J4 (copied table, unverified); MR-J4-_B manual, 11-13"),
    ("mr-j4-b", "MR-J4-_B manual, 11-13"),
    ("omron-g5", "Omron Accurax G5 manual, 4-39"),
    ("s120-combi", "SINAMICS S120 Combi manual 07/2012, p.165"),
    ("s210-manual", "SINAMICS S210 manual 12/2017, p.52"),
    ("sgd7s", "Yaskawa SGD7S catalogue (copied table, unverified); manual, 12-37"),
    ("siemens-d21-4", "Siemens D 21.4, 2017, p.7/60"),
    ("sigma-2", "Yaskawa Sigma II manual, p.8-15"),
    ("soga-mt3", "SOGA MT3 IE3, p.17"),
    ("ted-1fk2", "Siemens TED, 1FK2 (copied table, unverified)"),
    ("ted-s210", "Siemens TED, S210 (copied table, unverified)"),
    ("wat-ie3", "WAT IE3 80M"),
];

/// Title of the document behind a key, in the language in use; another source, as a user's own table states it, stays as it is.
pub fn source_title(key: &str) -> &str {
    SOURCES.iter().find(|row| row.0 == key).map_or(key, |row| words(row.1))
}
