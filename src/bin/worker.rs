//! The worker beside the page: the same library, started when the page first asks for warnings, sheets, an export or a large file.

fn main() {
    macroline::ui::work();
}
