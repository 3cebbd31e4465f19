//! Browser app: the whole module, which has the page from the moment on when somebody asks for what the first one lacks.

fn main() {
    macroline::ui::open();
}
