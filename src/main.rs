//! Browser app: reports a panic and shows the page, or works for it in a worker.

use macroline::ui;

fn main() {
    std::panic::set_hook(Box::new(|panic| {
        web_sys::console::error_1(&panic.to_string().into());
        ui::broken(&panic.to_string());
    }));
    // The same module also runs in workers (style/worker_boot.js), which have no page to show.
    if web_sys::window().is_some() {
        leptos::mount::mount_to_body(ui::App);
    } else {
        ui::work();
    }
}
