//! Law of the certain fixes: a program with one typing mistake, after them, still has an error or runs as it did without the mistake.

use macroline::controls::{self, Control, Switches};
use macroline::nc::{self, Files, fix_all};
use macroline::project::findings::check::{FixChoice, fixes};

use super::{fixtures, log_of, settings, start_on};

/// Typing mistakes: a character, and the one typed in its place; `None` leaves it out.
const MISTAKES: [(char, Option<char>); 8] = [
    ('0', Some('O')),
    ('O', Some('0')),
    ('1', Some('l')),
    ('.', Some(',')),
    ('=', None),
    ('[', Some('(')),
    ('X', None),
    ('M', Some('N')),
];

/// Places per program and mistake.
const PLACES: usize = 8;

/// The program with one mistake, at several of its places in turn.
fn mistyped(source: &str, (right, typed): (char, Option<char>)) -> Vec<String> {
    let places: Vec<usize> = source.match_indices(right).map(|(at, _)| at).collect();
    let step = places.len().div_ceil(PLACES).max(1);
    let with_mistake = |&at: &usize| {
        let typed = typed.map(String::from).unwrap_or_default();
        format!("{}{typed}{}", &source[..at], &source[at + right.len_utf8()..])
    };
    places.iter().step_by(step).map(with_mistake).collect()
}

/// The program after its certain fixes; `None` if there are none or an error is left.
fn mended(control: &'static Control, text: &str, set: &[(&str, &str)]) -> Option<String> {
    let switches = Switches(set.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
    let mut files = Files::one("test.nc", text);
    for round in 0..8 {
        let parsed = nc::parse_with(&files, control, &switches);
        let (next, count) = fix_all(&files, fixes(parsed.diagnostics(), FixChoice::Certain));
        if count == 0 {
            return (round > 0 && !parsed.has_errors()).then(|| files.0[0].text.clone());
        }
        files = next;
    }
    None
}

#[test]
fn certain_fix_of_a_typing_mistake_keeps_the_run() {
    let (mut wrong, mut kept) = (Vec::new(), 0);
    for control in controls::ALL {
        for (path, source) in fixtures(control, "ok") {
            let set = settings(&source);
            // Remarks name their places, which a fix may move.
            let run = |text: &str| -> Vec<String> {
                let log = log_of(text, &mut start_on(control, text, &set));
                log.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect()
            };
            let right = run(&source);
            for mistake in MISTAKES {
                for text in mistyped(&source, mistake) {
                    let Some(fixed) = mended(control, &text, &set) else { continue };
                    if fixed == source || run(&fixed) == right {
                        kept += 1;
                        continue;
                    }
                    let pairs = source.lines().zip(text.lines()).zip(fixed.lines());
                    let first = pairs.clone().find(|((right, _), fixed)| right != fixed);
                    wrong.push(format!("{} {}: {first:?}", control.id, path.file_name().unwrap().display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong, {kept} kept\n{}", wrong.len(), wrong.join("\n"));
    assert!(kept > 300, "{kept} programs are mended");
}
