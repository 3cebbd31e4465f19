//! What works for the page in a worker: a module of its own, loaded when the page first needs it.

fn main() {
    macroline::ui::work();
}
