//! Report and summary as PDF, printed by an installed browser: on the same paper size that the page uses.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{fs, io, thread};

use macroline::msg;
use macroline::project::export::{REPORT, SUMMARY};
use macroline::text::catalog::sentence;
use tempfile::TempDir;

use crate::args::Paper;
use crate::language::failed;

/// Names of the documents that are printed, and of their prints.
pub(crate) const PRINTS: [(&str, &str); 2] = [(SUMMARY, "summary.pdf"), (REPORT, "report.pdf")];

/// Names of a document and its print in the folder of the browser.
const DOCUMENT: &str = "document.html";
/// See [`DOCUMENT`].
const PRINT: &str = "document.pdf";

/// Browsers that print without a window, as they are called on Linux, macOS and Windows.
const BROWSERS: [&str; 10] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
];

/// Time limit for the browser. A report takes about two seconds; a browser that hangs would otherwise block for ever.
const PATIENCE: Duration = Duration::from_secs(120);

/// Prints an HTML document without links to other files. `browser` is a program; without it the first one installed.
pub(crate) fn print(html: &[u8], paper: Paper, browser: Option<&Path>) -> Result<Vec<u8>, String> {
    let folder = tempfile::tempdir().map_err(|error| failed(&std::env::temp_dir(), &error))?;
    let (document, printed) = (folder.path().join(DOCUMENT), folder.path().join(PRINT));
    // Browsers have no option for the paper without a window; the report leaves it to the printer.
    let sized = [html, page_rule(paper).as_bytes()].concat();
    fs::write(&document, sized).map_err(|error| failed(&document, &error))?;
    let (name, mut printing) = start(&folder, browser)?;
    let status = end(&mut printing).map_err(|error| failed(Path::new(&name), &error))?;
    fs::read(&printed)
        .map_err(|_| sentence(&msg!("cli.browser-failed", browser = name.to_string_lossy().into_owned(), status)))
}

/// The rule of a style sheet for the paper.
fn page_rule(paper: Paper) -> &'static str {
    match paper {
        Paper::A4 => "<style>@page { size: A4 }</style>",
        Paper::Letter => "<style>@page { size: letter }</style>",
    }
}

/// Starts the browser, or the first that is installed; returns its name too.
fn start(folder: &TempDir, browser: Option<&Path>) -> Result<(OsString, Child), String> {
    let names: Vec<&OsStr> = match browser {
        Some(path) => vec![path.as_os_str()],
        None => BROWSERS.iter().map(OsStr::new).collect(),
    };
    for name in names {
        match command(name, folder.path()).spawn() {
            Ok(child) => return Ok((name.to_owned(), child)),
            Err(error) if browser.is_none() && error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(failed(Path::new(name), &error)),
        }
    }
    Err(sentence(&msg!("cli.no-browser")))
}

/// The command that prints the document of a folder into it. The browser keeps its profile there too, so that an open one is left alone.
fn command(browser: &OsStr, folder: &Path) -> Command {
    let option = |name: &str, path: &str| {
        let mut option = OsString::from(name);
        option.push(folder.join(path));
        option
    };
    let mut command = Command::new(browser);
    command
        .args(["--headless", "--disable-gpu", "--no-first-run", "--no-pdf-header-footer"])
        // Bookmarks of the sections; a browser that does not know the option passes over it.
        .arg("--generate-pdf-document-outline")
        // The document is macroline's own and runs no script; the sandbox fails where containers run browsers as root.
        .arg("--no-sandbox")
        .arg(option("--user-data-dir=", "profile"))
        .arg(option("--print-to-pdf=", PRINT))
        .arg(folder.join(DOCUMENT))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command
}

/// Waits for the end; ends a browser that takes too long. Returns its status.
fn end(child: &mut Child) -> io::Result<String> {
    let since = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status.to_string());
        }
        if since.elapsed() > PATIENCE {
            child.kill()?;
            return Ok(child.wait()?.to_string());
        }
        thread::sleep(Duration::from_millis(20));
    }
}
