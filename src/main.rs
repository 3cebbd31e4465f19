//! Browser app: the module that the page opens with, without what few need.

fn main() {
    macroline::ui::open();
}
