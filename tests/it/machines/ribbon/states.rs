//! States in which the programs of the ribbon line begin and end, whatever ran before.

use macroline::project::Project;

use super::{controls, each_control};

/// Blocks of the program that runs, without comments.
fn blocks_of_run(project: &Project) -> Vec<String> {
    let files = project.written().files;
    let texts = files.0.iter().map(|file| file.text.as_str()).filter(|text| text.contains("RIBBON LINE - RUN"));
    texts.flat_map(str::lines).map(|line| line.split(['(', ';']).next().unwrap().trim().to_owned()).collect()
}

#[test]
fn programs_set_millimetres_and_speed_and_end_without_volts() {
    for control in controls() {
        for variant in ["ready-made", "published", "precomputed"] {
            let blocks = blocks_of_run(&each_control::project(control.id, &[("variant", variant)]));
            let opening = blocks.iter().position(|block| block.ends_with("G97"));
            let at = opening.unwrap_or_else(|| panic!("{} {variant}: {blocks:#?}", control.id));
            assert!(["G21", "G71"].iter().any(|metric| blocks[at].contains(metric)), "{}: {}", control.id, blocks[at]);
            let moves = blocks.iter().position(|block| block.contains("G0") || block.contains("G1 "));
            assert!(moves.is_none_or(|moves| at < moves), "{} {variant}", control.id);
            // A key would turn the unwinder at the last S.
            assert!(blocks.iter().any(|block| block.contains("M5 S0")), "{} {variant}", control.id);
        }
    }
}

#[test]
fn final_speed_is_read_after_the_entries_are_checked() {
    let line = each_control::project("mitsubishi-e60", &[("override-form", "final-speed")]);
    let blocks = blocks_of_run(&line);
    let at = |what: &str| blocks.iter().position(|block| block.contains(what)).unwrap();
    assert!(at("M98") < at("M3") && at("G92") < at("M3"), "{blocks:#?}");
}
