//! Speed of the binary `macroline run`, its log read from a pipe; beside it planning, and the memory of a long run.
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;
#[allow(dead_code, reason = "each bench takes a part of it")]
mod work;

use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Blocks of the flat program.
const COUNT: u64 = 500_000;
/// Blocks of the long run.
const LONG: u64 = 10_000_000;

/// A file with a program in it.
fn program(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// Runs `macroline run`, reads what it prints through a pipe, and shows the process to `watch` with every piece.
fn run(path: &Path, more: &[&str], mut watch: impl FnMut(u32, usize)) {
    let mut line = Command::new(env!("CARGO_BIN_EXE_macroline"));
    line.arg("run").arg(path).args(["--control", "mitsubishi-e60", "--seconds", "1e9"]).args(more);
    let mut child = line.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let id = child.id();
    let mut log = BufReader::new(child.stdout.take().unwrap());
    let (mut piece, mut lines) = (vec![0; 1 << 16], 0);
    loop {
        let length = log.read(&mut piece).unwrap();
        if length == 0 {
            break;
        }
        lines += piece[..length].iter().filter(|&&byte| byte == b'\n').count();
        watch(id, lines);
    }
    assert!(child.wait().unwrap().success());
}

/// The most memory that a process has had, in KB; 0 where the system does not report it.
fn peak(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse().ok()).unwrap_or(0)
}

#[allow(clippy::print_stdout, reason = "its figures are for people")]
fn main() {
    let flat = program("flat.nc", &work::flat(COUNT).0[0].text);
    let planned = || run(&flat, &["--no-canon"], |_, _| {});
    summary::line("macroline run, flat blocks, log printed", COUNT, "blocks", Some(1e6), || run(&flat, &[], |_, _| {}));
    summary::line("macroline run, flat blocks, planned only", COUNT, "blocks", None, planned);

    let endless = program("endless.nc", "%\nO1\nG91G01F119391.393\nDO1\nX8.Y62.832\n#100=#100+1\nEND1\n%\n");
    let mut memory = Vec::new();
    run(&endless, &["--blocks", &LONG.to_string()], |process, lines| {
        if lines as u64 >= LONG / 30 * memory.len() as u64 {
            memory.push(peak(process));
        }
    });
    let early = memory.get(1).copied().unwrap_or(0);
    let late = memory.last().copied().unwrap_or(0);
    println!(
        "summary: macroline run, {LONG} blocks, log printed: {early} KB of memory at a tenth, {late} KB at the end"
    );
}
