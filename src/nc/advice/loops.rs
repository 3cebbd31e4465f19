//! Checks of loops: DO and END paired, not crossing, not nested too deep.

use super::programs::Check;
use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Block, Stmt};
use crate::nc::parse::reader::FINDINGS;
use crate::text::{DiagnosticKind, Fix, Message, Place, Span};

/// Maximum blocks searched for the end of a loop.
const SEARCHED: usize = 10_000;

/// Loop number in a block that does not parse.
const ANY: u16 = 0;

/// A loop without its END so far.
struct OpenLoop<'a> {
    label: u16,
    /// Block of its DO.
    head: &'a Block,
}

/// Whether an open loop ends in these blocks, before another loop of the same number begins.
fn ends_in(blocks: &[Block], label: u16) -> bool {
    let found = blocks.iter().take(SEARCHED).find_map(|block| match block.stmt {
        Stmt::End { label: other } if other == label => Some(true),
        Stmt::While { label: other, .. } if other == label => Some(false),
        _ => None,
    });
    found == Some(true)
}

/// Whether the block does not parse, so that its error is already reported.
fn is_unread(block: &Block) -> bool {
    matches!(block.stmt, Stmt::Bad(_))
}

impl<'a> Check<'a> {
    /// Checks all loops of the program.
    pub(super) fn loops(&mut self) {
        let mut open: Vec<OpenLoop> = Vec::new();
        for (at, block) in self.blocks.iter().enumerate() {
            let stmt = if is_unread(block) { self.unread_loop(block) } else { block.stmt };
            let goes_on = match stmt {
                Stmt::While { label, .. } => self.begin_loop(&mut open, OpenLoop { label, head: block }),
                Stmt::End { label } => {
                    self.end_loop(&mut open, label, block, self.blocks.get(at + 1..).unwrap_or_default())
                }
                _ => true,
            };
            if !goes_on {
                return;
            }
        }
        for inner in open {
            self.no_end_of_loop(&inner);
        }
    }

    /// Reports an alarm of a loop, which a run through the loop raises too.
    fn report_loop(&mut self, alarm: Alarm, span: Span, message: Message) {
        self.report(alarm, span, message);
        if let Some(finding) = self.found.last_mut() {
            finding.kind = DiagnosticKind::UnpairedLoop;
        }
    }

    /// Opens a loop; returns false to end the check because loops are nested too deep.
    fn begin_loop(&mut self, open: &mut Vec<OpenLoop<'a>>, inner: OpenLoop<'a>) -> bool {
        let (label, head, deepest) = (inner.label, inner.head, self.control.syntax.do_depth as usize);
        let span = self.keyword_span(head, "DO");
        if open.len() == deepest {
            if !is_unread(head) {
                self.report_loop(Alarm::DoNesting, span, msg!("nc.do-nesting", most = deepest as u32));
            }
            return false;
        }
        if label != ANY && open.iter().any(|outer| outer.label == label) {
            self.report_loop(Alarm::DoPair, span, msg!("nc.do-within-itself", number = u32::from(label)));
        }
        open.push(inner);
        true
    }

    /// Ends a loop at `block`, before the blocks `rest`; returns false to end the check because of too many findings.
    fn end_loop(&mut self, open: &mut Vec<OpenLoop<'a>>, label: u16, block: &'a Block, rest: &[Block]) -> bool {
        match open.iter().rposition(|outer| outer.label == label || label == ANY || outer.label == ANY) {
            Some(at) if at + 1 == open.len() => drop(open.pop()),
            Some(at) => self.crossing_end(open, at, (label, block), rest),
            None if self.found.len() > 2 * FINDINGS => return false,
            None if is_unread(block) => {}
            None => self.end_without_do(open, (label, block), rest),
        }
        true
    }

    /// Handles an END that closes `open[at]` from within inner loops: inner loops that end later cross it, others have no END.
    fn crossing_end(&mut self, open: &mut Vec<OpenLoop<'a>>, at: usize, (label, block): (u16, &Block), rest: &[Block]) {
        for inner in open.split_off(at + 1) {
            if ends_in(rest, inner.label) {
                open.push(inner);
            } else {
                self.no_end_of_loop(&inner);
            }
        }
        let inner = open.get(at + 1..).and_then(<[_]>::last).map(|inner| u32::from(inner.label));
        if let Some(inner) = inner.filter(|_| !is_unread(block)) {
            let span = self.keyword_span(block, "END");
            self.report_loop(Alarm::DoPair, span, msg!("nc.do-crossing", number = u32::from(label), inner));
        }
        open.remove(at);
    }

    /// Handles an END without its DO. If the innermost loop has no END, the fix gives this one its number.
    fn end_without_do(&mut self, open: &mut Vec<OpenLoop<'a>>, (label, block): (u16, &Block), rest: &[Block]) {
        let span = self.keyword_span(block, "END");
        self.report_loop(Alarm::MissingDo, span, msg!("nc.end-without-do", number = u32::from(label)));
        let meant = open.pop_if(|inner| inner.label != ANY && !ends_in(rest, inner.label));
        if let (Some(inner), Some(finding)) = (meant, self.found.last_mut()) {
            let (place, end) = (Place { file: self.program.file, span }, format!("END{}", inner.label));
            finding.fixes.push(Fix { title: msg!("nc.fix.write", text = end.as_str()), edits: vec![(place, end)] });
        }
    }

    /// Reports a loop without an END, unless its DO is in a block that does not parse.
    fn no_end_of_loop(&mut self, inner: &OpenLoop) {
        if !is_unread(inner.head) {
            let span = self.keyword_span(inner.head, "DO");
            self.report_loop(Alarm::MissingEnd, span, msg!("nc.do-without-end", number = u32::from(inner.label)));
        }
    }

    /// The loop statement in the text of a block that does not parse; otherwise the block's own statement.
    fn unread_loop(&self, block: &Block) -> Stmt {
        let text = block.span.of(self.text).to_ascii_uppercase();
        let text = text.split('(').next().unwrap_or("");
        // Number behind the keyword; `ANY` if missing or out of range.
        let label = |keyword: &str| {
            let behind = text.get(text.rfind(keyword)? + keyword.len()..).unwrap_or("").trim_start();
            let digits = behind.bytes().take_while(u8::is_ascii_digit).count();
            let label: Option<u16> = behind.get(..digits).and_then(|digits| digits.parse().ok());
            Some(label.filter(|&label| (1..=self.control.syntax.do_max).contains(&label.into())).unwrap_or(ANY))
        };
        let head = label("DO").or_else(|| text.contains("WHILE").then_some(ANY));
        // `ENDWHILE` and `ENDDO` are ends of loops.
        let end = text.contains("ENDW") || text.contains("ENDD");
        match (head.filter(|_| !end), label("END")) {
            (Some(label), _) => Stmt::While { cond: None, label },
            (None, Some(label)) => Stmt::End { label },
            (None, None) => block.stmt,
        }
    }
}
