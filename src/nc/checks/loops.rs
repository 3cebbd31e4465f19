//! Checks of loops: DO and END paired, not crossing, not nested too deep.

use super::context::Check;
use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Block, Stmt};
use crate::nc::unread::{ANY_LOOP, loop_statement};
use crate::text::{DiagnosticKind, Fix, Message, Place, Span};

/// Maximum blocks searched for the end of a loop.
const SEARCHED: usize = 10_000;

/// A loop without its END so far.
struct OpenLoop {
    label: u16,
    /// The DO.
    head: Span,
    /// The error of the block of its DO, if it does not parse.
    unread: Option<Span>,
}

/// An END, which may be in a block that does not parse.
struct EndOfLoop {
    label: u16,
    span: Span,
    unread: bool,
}

/// Whether an open loop ends in these blocks, before another loop of the same number begins.
fn ends_in(blocks: &[Block], label: u16) -> bool {
    let found = blocks.iter().take(SEARCHED).find_map(|block| match block.stmt {
        Stmt::End { label: other, .. } if other == label => Some(true),
        Stmt::While { label: other, .. } if other == label => Some(false),
        _ => None,
    });
    found == Some(true)
}

impl Check<'_> {
    /// Checks all loops of the program.
    pub(super) fn loops(&mut self) {
        let mut open: Vec<OpenLoop> = Vec::new();
        for (at, block) in self.blocks.iter().enumerate() {
            let (stmt, unread) = match block.stmt {
                Stmt::Bad(bad) => {
                    let stmt = loop_statement(block.span.of(self.text), self.control).unwrap_or(block.stmt);
                    (stmt, Some(bad.finding))
                }
                stmt => (stmt, None),
            };
            let goes_on = match stmt {
                Stmt::While { label, keyword, .. } => {
                    self.begin_loop(&mut open, OpenLoop { label, head: keyword.span(block), unread })
                }
                Stmt::End { label, keyword } => {
                    let end = EndOfLoop { label, span: keyword.span(block), unread: unread.is_some() };
                    self.end_loop(&mut open, &end, self.blocks.get(at + 1..).unwrap_or_default())
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
    fn begin_loop(&mut self, open: &mut Vec<OpenLoop>, inner: OpenLoop) -> bool {
        let (label, head, deepest) = (inner.label, inner.head, self.control.syntax.do_depth as usize);
        if open.len() == deepest {
            if inner.unread.is_none() {
                self.report_loop(Alarm::DoNesting, head, msg!("nc.do-nesting", most = deepest as u32));
            }
            return false;
        }
        if label != ANY_LOOP && open.iter().any(|outer| outer.label == label) {
            self.report_loop(Alarm::DoPair, head, msg!("nc.do-within-itself", number = u32::from(label)));
        }
        open.push(inner);
        true
    }

    /// Ends a loop at `end`, before the blocks `rest`; returns false to end the check because of too many findings.
    fn end_loop(&mut self, open: &mut Vec<OpenLoop>, end: &EndOfLoop, rest: &[Block]) -> bool {
        let any = |outer: &OpenLoop| end.label == ANY_LOOP || outer.label == ANY_LOOP;
        match open.iter().rposition(|outer| outer.label == end.label || any(outer)) {
            Some(at) if at + 1 == open.len() => {
                if let Some(inner) = open.pop() {
                    self.insert_do(&inner, end.label);
                }
            }
            Some(at) => self.crossing_end(open, at, end, rest),
            None if self.is_full() => return false,
            None if end.unread => {}
            None => self.end_without_do(open, end, rest),
        }
        true
    }

    /// Handles an END that closes `open[at]` from within inner loops: inner loops that end later cross it, others have no END.
    fn crossing_end(&mut self, open: &mut Vec<OpenLoop>, at: usize, end: &EndOfLoop, rest: &[Block]) {
        for inner in open.split_off(at + 1) {
            if ends_in(rest, inner.label) {
                open.push(inner);
            } else {
                self.no_end_of_loop(&inner);
            }
        }
        let inner = open.get(at + 1..).and_then(<[_]>::last).map(|inner| u32::from(inner.label));
        if let Some(inner) = inner.filter(|_| !end.unread) {
            self.report_loop(Alarm::DoPair, end.span, msg!("nc.do-crossing", number = u32::from(end.label), inner));
        }
        let outer = open.remove(at);
        self.insert_do(&outer, end.label);
    }

    /// Adds the fix for a WHILE without its DO: the number of its END.
    fn insert_do(&mut self, outer: &OpenLoop, label: u16) {
        let place = outer.unread.filter(|_| label != ANY_LOOP).map(|span| Place { file: self.program.file, span });
        let finding = place.and_then(|place| self.without_do.get(&place)).and_then(|at| self.found.get_mut(*at));
        if let Some((finding, place)) = finding.zip(place) {
            let (at, text) = (Place { span: Span::at(place.span.end), ..place }, format!("DO{label}"));
            finding.fixes.push(Fix { title: msg!("nc.fix.insert", text = text.as_str()), edits: vec![(at, text)] });
        }
    }

    /// Handles an END without its DO. If the innermost loop has no END, the fix gives this one its number.
    fn end_without_do(&mut self, open: &mut Vec<OpenLoop>, end: &EndOfLoop, rest: &[Block]) {
        self.report_loop(Alarm::MissingDo, end.span, msg!("nc.end-without-do", number = u32::from(end.label)));
        let meant = open.pop_if(|inner| inner.label != ANY_LOOP && !ends_in(rest, inner.label));
        if let (Some(inner), Some(finding)) = (meant, self.found.last_mut()) {
            let (place, end) = (Place { file: self.program.file, span: end.span }, format!("END{}", inner.label));
            finding.fixes.push(Fix { title: msg!("nc.fix.write", text = end.as_str()), edits: vec![(place, end)] });
        }
    }

    /// Reports a loop without an END, unless its DO is in a block that does not parse.
    fn no_end_of_loop(&mut self, inner: &OpenLoop) {
        if inner.unread.is_none() {
            self.report_loop(Alarm::MissingEnd, inner.head, msg!("nc.do-without-end", number = u32::from(inner.label)));
        }
    }
}
