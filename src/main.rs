//! Browser app: reports a panic in the console and shows the page.

use macroline::ui::App;

fn main() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
    // The same module also runs in workers (style/worker_boot.js), which have no page to show.
    if web_sys::window().is_some() {
        leptos::mount::mount_to_body(App);
    }
}
