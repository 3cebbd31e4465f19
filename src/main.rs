//! The browser app: opens the page.

fn main() {
    macroline::ui::open();
}
