//! Interface and ladder of the ribbon line as their sheets list them; that of the E60 is figure 1 of the paper, with the rungs that it lacks.

use std::path::PathBuf;

use expect_test::expect_file;

use super::at_defaults;
use super::each_control::rows;

/// Compares a sheet with its golden in `tests/data/machines/ribbon-line/<control>`.
#[track_caller]
fn check_list(control: &str, changes: &[(&str, &str)], sheet: &str, golden: &str) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/machines/ribbon-line");
    let list = rows(at_defaults(macroline::controls::find(control).unwrap()), changes, sheet);
    expect_file![folder.join(control).join(golden)].assert_eq(&list);
}

#[test]
fn ladder_of_the_e60_equals_figure_1_of_the_paper() {
    check_list("mitsubishi-e60", &[], "ladder", "ladder.txt");
}

#[test]
fn ladder_of_the_e60_with_final_speed_matches_its_golden() {
    let changes = [("knob-step", "5"), ("override-form", "final-speed"), ("wait", "fin")];
    check_list("mitsubishi-e60", &changes, "ladder", "ladder-final-speed.txt");
}

#[test]
fn interface_of_the_980tdc_matches_its_golden() {
    check_list("gsk-980tdc", &[], "interface", "interface.txt");
}

#[test]
fn ladder_of_the_980tdc_matches_its_golden() {
    check_list("gsk-980tdc", &[("knob-step", "10")], "ladder", "ladder.txt");
}

#[test]
fn interface_of_the_k2000t_matches_its_golden() {
    check_list("knd-k2000t", &[("wait", "fin")], "interface", "interface.txt");
}

#[test]
fn ladder_of_the_k2000t_matches_its_golden() {
    check_list("knd-k2000t", &[], "ladder", "ladder.txt");
}
