//! Laws that hold for any text on any control. Shared with the fuzz targets: a law that is broken panics.

use std::rc::Rc;

use macroline::controls::{Address, Alarm, Control};
use macroline::interp::canon::AXES;
use macroline::interp::{Interp, MachineClock, StartProgram, Step, World, precheck};
use macroline::motion::{Budget, Panel, Retention};
use macroline::nc::{self, Block, Files, Parsed, Stmt};
use macroline::project::findings::check::review;
use macroline::project::findings::render::Renderer;
use macroline::project::run::{AtStop, RunOptions, of_programs, to_end};
use macroline::text::{Diagnostic, Fix, Place, Severity, Span};

use super::deck_eq::are_same;
use super::dice::Dice;

/// Reading, writing and mending.
pub(crate) fn reading(control: &'static Control, text: &str) {
    let files = Files::one("O1.nc", text);
    let parsed = Rc::new(nc::parse(&files, control));
    let deck = parsed.deck();
    let mut at = 0;
    for program in &deck.programs {
        assert_eq!(program.first, at, "programs hold their blocks side by side");
        at = program.end;
    }
    assert_eq!(at as usize, deck.blocks.len());
    let mut at = 0;
    for block in &deck.blocks {
        assert!(block.span.start >= at && !block.span.of(text).is_empty(), "blocks follow one another: {block:?}");
        at = block.span.end;
    }
    check_findings(&parsed, parsed.diagnostics(), text);
    check_findings(&parsed, &review(&parsed, None, &[]), text);
    let mut at = 0;
    for (span, _) in nc::tokens(text, control) {
        assert!(span.start >= at && !span.of(text).is_empty(), "pieces follow one another: {span:?}");
        at = span.end;
    }
    for block in &parsed.deck().blocks {
        let Stmt::Bad(bad) = block.stmt else { continue };
        // What the control reads and the simulation does not is a warning.
        let warned = || parsed.diagnostics().iter().any(|found| found.place.is_some_and(|at| at.span == bad.finding));
        assert!(parsed.has_errors() || bad.alarm == Alarm::NotSimulated && warned(), "{:?}", parsed.files());
    }
    written(&parsed);
}

/// Findings have places in the text, sentences without gaps, and fixes that fit.
fn check_findings(parsed: &Parsed, findings: &[Diagnostic], text: &str) {
    let renderer = Renderer::new(parsed.files());
    for finding in findings {
        let place = finding.place.expect("a finding about a program has a place");
        assert!(text.get(place.span.start as usize..place.span.end as usize).is_some(), "{finding:?}");
        assert!(!renderer.text(finding).contains('\u{0}'));
        for fix in &finding.fixes {
            let mended = nc::fix(parsed.files(), fix);
            assert_ne!(&mended, parsed.files(), "a fix changes something: {fix:?}");
            let again = nc::parse(&mended, parsed.control());
            corrected((parsed, finding), fix, &again);
        }
    }
}

/// A fix removes its finding, and leaves other lines, and the comments of blocks that parse.
fn corrected((parsed, finding): (&Parsed, &Diagnostic), fix: &Fix, again: &Parsed) {
    let [old, new] = [parsed, again].map(|parsed| parsed.files().0[0].text.as_str());
    let shown = || format!("{fix:?} of {finding:?}\n{old}\n--- becomes ---\n{new}");
    // The place of a byte of the old text in the new one; after the edits that end there, if `after`.
    let moved = |at: u32, after: bool| {
        let before = fix.edits.iter().filter(|(place, _)| place.span.end < at || place.span.end == at && after);
        let longer = |(place, text): &(Place, String)| text.len() as i64 - i64::from(place.span.end - place.span.start);
        i64::from(at) + before.map(longer).sum::<i64>()
    };
    if let Some(Place { span, .. }) = finding.place {
        let starts = moved(span.start, false)..=moved(span.start, true);
        let same = |other: &&Diagnostic| {
            let place = other.place.map_or(Span::default(), |place| place.span);
            other.message == finding.message
                && starts.contains(&i64::from(place.start))
                && place.of(new) == span.of(old)
        };
        // A dropped sign may be followed by another one.
        let count =
            |parsed: &Parsed| parsed.diagnostics().iter().filter(|other| other.message == finding.message).count();
        let stays = again.diagnostics().iter().any(|other| same(&other)) && count(again) >= count(parsed);
        assert!(!stays, "the finding stays: {}", shown());
    }
    let whole = |span: Span| span.start == 0 && span.end as usize == old.len();
    let line = |span: Span| {
        let start = old[..span.start as usize].rfind('\n').map_or(0, |at| at + 1);
        let end = old[span.end as usize..].find('\n').map_or(old.len(), |at| span.end as usize + at);
        start as u32..=end as u32
    };
    let lines: Vec<_> = fix.edits.iter().map(|(place, _)| line(place.span)).collect();
    for block in parsed.deck().blocks.iter().filter(|block| !matches!(block.stmt, Stmt::Bad(_))) {
        if let Some(comment) = block.comment.map(|comment| parsed.text_span(comment)) {
            let meets = |span: Span| span.start < comment.end && comment.start < span.end && !whole(span);
            assert!(!fix.edits.iter().any(|(place, _)| meets(place.span)), "a comment changes: {}", shown());
        }
        if lines.iter().any(|line| line.contains(&block.span.start)) {
            continue;
        }
        let start = moved(block.span.start, true) as u32;
        let blocks = &again.deck().blocks;
        let same = blocks.binary_search_by_key(&start, |block| block.span.start).ok().map(|at| blocks[at]);
        assert!(!same.is_some_and(|block| matches!(block.stmt, Stmt::Bad(_))), "another line breaks: {}", shown());
    }
}

/// Emitting and parsing gives the lowered deck again; lowering twice is lowering once.
fn written(parsed: &Parsed) {
    let control = parsed.control();
    // A block that the simulation does not read has no words to write.
    if parsed.deck().blocks.iter().any(|block| matches!(block.stmt, Stmt::Bad(_))) {
        return;
    }
    let low = nc::lower(parsed.deck(), control);
    assert!(are_same(&nc::lower(&low, control), &low), "lowering twice is lowering once");
    let out = nc::emit(parsed.deck(), control);
    if parsed.has_errors() || out.files.0.len() != parsed.deck().programs.len() {
        return;
    }
    // Each program is a file of its own.
    let read = nc::parse(&out.files, control);
    let too_much = [Alarm::BracketDepth, Alarm::BlockTooLong].map(|alarm| control.alarm_number(alarm));
    let refused = read.diagnostics().iter().any(|d| d.alarm.is_some() && too_much.contains(&d.alarm.as_deref()));
    let anew: Vec<&str> = out.files.0.iter().map(|file| file.text.as_str()).collect();
    let old = &parsed.files().0[0].text;
    assert!(refused || are_same(read.deck(), &low), "{old}\nis written\n{}\n{:?}", anew.concat(), read.diagnostics());
}

/// A machine with arbitrary answers.
struct AnyWorld<'a>(Dice<'a>);

impl AnyWorld<'_> {
    fn number(&mut self) -> f64 {
        let whole = f64::from(self.0.byte()) - 100.0;
        match self.0.byte() {
            255 => f64::NAN,
            254 => f64::INFINITY,
            253 => -1e300,
            252 => 1e15,
            byte => whole + f64::from(byte) / 1000.0,
        }
    }
}

impl World for AnyWorld<'_> {
    fn input(&mut self, _: u32) -> f64 {
        self.number()
    }

    fn clock_ms(&mut self, _: MachineClock) -> f64 {
        self.number()
    }

    fn position(&mut self, axis: usize) -> f64 {
        assert!(axis < AXES);
        self.number()
    }

    fn block_skip(&mut self, _: u8) -> bool {
        self.0.rarely(40)
    }
}

/// Steps of the interpreter, and blocks of the planner, that a text gets.
const STEPS: u32 = 2000;
const BLOCKS: u64 = 300;

/// Law of running: the run ends or goes on block by block, and all commands are finite numbers.
pub(crate) fn running(control: &'static Control, text: &str, world: &[u8]) {
    let parsed = Rc::new(nc::parse(&Files::one("O1.nc", text), control));
    let mut interp = Interp::new(Rc::clone(&parsed), StartProgram::First);
    let names = interp.names();
    let mut machine = AnyWorld(Dice(world));
    // No run gets past an alarm of the precheck at a block without condition or skip.
    let mut doomed: Vec<Place> = Vec::new();
    for alarm in precheck(&parsed).into_iter().filter(|finding| finding.severity == Severity::Error) {
        let place = alarm.place.expect("an alarm of a block has a place");
        let around = |block: &&Block| block.span.start <= place.span.start && place.span.end <= block.span.end;
        let block = parsed.deck().blocks.iter().find(around).expect("it lies in a block");
        let skips = parsed.deck().words_of(block).iter().any(|word| word.letter == Address::Skip);
        let certain = matches!(block.stmt, Stmt::Words { .. } | Stmt::Assign { .. } | Stmt::Goto { .. });
        doomed.extend((certain && block.skip == 0 && !skips).then_some(Place { span: block.span, ..place }));
    }
    let (mut ended, mut syncs) = (false, 0);
    for _ in 0..STEPS {
        match interp.step(&mut machine) {
            Step::Command(canon, place) => {
                assert!(!doomed.contains(&place), "{} runs", parsed.text(place));
                let line = canon.line(names).to_string();
                assert!(!line.contains("NaN") && !line.contains("inf") && !line.contains('∞'), "{line}");
                syncs = 0;
            }
            Step::Sync(_) => {
                syncs += 1;
                assert!(syncs < 3, "a machine at rest is at rest");
            }
            Step::Logic(place) => {
                assert!(!doomed.contains(&place), "{} runs", parsed.text(place));
                syncs = 0;
            }
            Step::Ended(_) => {
                ended = true;
                break;
            }
        }
    }
    let counts = interp.blocks();
    assert!(ended || counts.nc + counts.macros > 0, "steps are blocks");
    let limits = Budget { blocks: BLOCKS, seconds: 100.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
    let mut run = of_programs(parsed, None, Panel::default(), &begin);
    let outcome = to_end(&mut run, AtStop::End, |line| {
        let line = line.to_string();
        assert!(!line.contains("NaN") && !line.contains("inf") && !line.contains('∞'), "{line}");
        Ok::<(), ()>(())
    });
    let outcome = outcome.expect("the log is taken");
    assert!(outcome.time.is_finite() && outcome.time <= 100.0 && outcome.blocks <= BLOCKS, "{}", outcome.text());
    assert!(outcome.axes.iter().all(|axis| axis.1.is_finite()), "{}", outcome.text());
    assert!(outcome.spindle.volts.is_finite() && outcome.spindle.turns.is_finite());
}
