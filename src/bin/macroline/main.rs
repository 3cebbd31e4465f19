//! The command line, for engineers and for tests; it uses the same interface of `project` as the page.
//!
//! Exit status: 0, 1 when there is an error, 2 for wrong usage. Diagnostics go to standard error as text, or into the JSON.

#[cfg(not(target_arch = "wasm32"))]
mod output;

#[cfg(not(target_arch = "wasm32"))]
mod input;

#[cfg(not(target_arch = "wasm32"))]
mod args;

#[cfg(not(target_arch = "wasm32"))]
mod language;

#[cfg(not(target_arch = "wasm32"))]
mod export;

#[cfg(not(target_arch = "wasm32"))]
mod pdf;

#[cfg(not(target_arch = "wasm32"))]
mod run;

#[cfg(not(target_arch = "wasm32"))]
mod lsp;

#[cfg(not(target_arch = "wasm32"))]
mod commands;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    commands::main()
}

/// The browser has the page instead.
#[cfg(target_arch = "wasm32")]
fn main() {}
