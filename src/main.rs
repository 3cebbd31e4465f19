//! Browser app: reports a panic, takes the sentences and shows the page.

use macroline::ui;

fn main() {
    std::panic::set_hook(Box::new(|panic| {
        web_sys::console::error_1(&panic.to_string().into());
        ui::broken(&panic.to_string());
    }));
    ui::learn();
    leptos::mount::mount_to_body(ui::App);
}
