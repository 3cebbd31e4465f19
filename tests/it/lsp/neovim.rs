//! Neovim as a client: opens a program, reads the diagnostics, makes a fix and ends the server.

use std::path::Path;

use serde_json::Value as Json;

use super::client::folder;
use crate::command::{MACROLINE, in_english};

#[test]
fn neovim_shows_and_fixes_findings_of_the_server() {
    let folder = folder("neovim");
    let file = folder.join("O1.nc");
    std::fs::write(&file, "O1\n#100=1\nG00 X#100\nIF[#100>2]GOTO10\nGOTO10\nN10 M30\n%\n").unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/lsp/neovim.lua");
    let out = in_english("nvim")
        .args(["--headless", "-u", "NONE", "-i", "NONE", "-n", "-S"])
        .arg(&script)
        .env("MACROLINE", MACROLINE)
        .env("FILE", &file)
        .env("HOME", &folder)
        .env("XDG_STATE_HOME", &folder)
        .env("XDG_CACHE_HOME", &folder)
        .output()
        .expect("Neovim is missing: scripts/setup.sh editor");
    let printed = String::from_utf8_lossy(&out.stdout);
    let seen: Json = serde_json::from_str(printed.trim())
        .unwrap_or_else(|_| panic!("{printed}\n{}", String::from_utf8_lossy(&out.stderr)));
    assert_eq!(seen["before"][0]["line"], 3, "{seen}");
    assert_eq!(seen["before"][0]["source"], "macroline");
    assert!(seen["hover"].as_str().unwrap().starts_with("G0: "), "{seen}");
    assert!(seen["completion"].as_u64().unwrap() > 20, "{seen}");
    assert_eq!((&seen["definition"], &seen["outline"]), (&5.into(), &"O1".into()), "{seen}");
    assert_eq!(seen["references"], 3, "{seen}");
    assert_eq!(seen["mended"], "IF[#100 GT 2]GOTO10", "{seen}");
}
