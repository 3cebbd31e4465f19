//! Answers about a position in a program: meaning, completion proposals, definition, references, outline.

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionTextEdit, DocumentHighlight, DocumentHighlightKind,
    DocumentSymbol, Documentation, Hover, HoverContents, Location, MarkupContent, MarkupKind, Position, SymbolKind,
    TextEdit,
};
use macroline::nc::symbols::{OutlineItem, Role, Symbol, Symbols};
use macroline::project::completion::{self, ProposalKind};
use macroline::text::{FileId, LineIndex, Place, Span};

use super::convert::Lines;
use super::documents::Programs;

fn plain(value: String) -> MarkupContent {
    MarkupContent { kind: MarkupKind::PlainText, value }
}

impl Programs {
    /// The meaning of the word at a position.
    pub(super) fn hover(&self, file: FileId, position: Position) -> Option<Hover> {
        let (_, text) = self.get(file)?;
        let (lines, index) = (Lines::new(text), LineIndex::new(text));
        let byte = lines.byte(position);
        let line = index.line_of(byte);
        let start = index.start(line);
        let (span, meaning) = self.setup.words().at(index.line(text, line), byte - start)?;
        let range = lines.range(Span::new(start + span.start, start + span.end));
        Some(Hover { contents: HoverContents::Markup(plain(meaning.text())), range: Some(range) })
    }

    /// Completion proposals at a position. They depend on the typed prefix, so the client asks again.
    pub(super) fn completion(&self, file: FileId, position: Position) -> Option<CompletionList> {
        let (_, text) = self.get(file)?;
        let lines = Lines::new(text);
        let found = completion::at(&self.setup.words(), &self.parsed, file, lines.byte(position));
        let range = lines.range(found.replaces);
        // The client filters by the text that is replaced, whose leading zeros do not count.
        let replaced = found.replaces.of(text);
        let zeros = replaced.get(..replaced.len() - replaced.trim_start_matches('0').len()).unwrap_or("");
        let filter = |proposal: &completion::Proposal| match proposal.kind {
            ProposalKind::Block | ProposalKind::Program => format!("{zeros}{}", proposal.text),
            _ => proposal.text.clone(),
        };
        let item = |(at, proposal): (usize, completion::Proposal)| CompletionItem {
            label: proposal.text.clone(),
            kind: Some(match proposal.kind {
                ProposalKind::Code => CompletionItemKind::OPERATOR,
                ProposalKind::Variable => CompletionItemKind::VARIABLE,
                ProposalKind::Keyword => CompletionItemKind::KEYWORD,
                ProposalKind::Function => CompletionItemKind::FUNCTION,
                ProposalKind::Address => CompletionItemKind::FIELD,
                ProposalKind::Block => CompletionItemKind::REFERENCE,
                ProposalKind::Program => CompletionItemKind::MODULE,
            }),
            detail: Some(proposal.line()).filter(|text| !text.is_empty()),
            documentation: proposal.meaning.as_ref().map(|it| Documentation::MarkupContent(plain(it.text()))),
            sort_text: Some(format!("{at:05}")),
            filter_text: Some(filter(&proposal)),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit { range, new_text: proposal.text })),
            ..CompletionItem::default()
        };
        let items = found.proposals.into_iter().enumerate().map(item).collect();
        Some(CompletionList { is_incomplete: true, items })
    }

    fn location(&self, place: Place) -> Option<Location> {
        let (address, text) = self.get(place.file)?;
        Some(Location { uri: address.clone(), range: Lines::new(text).range(place.span) })
    }

    /// The symbol at a position, with all symbols.
    fn symbol(&self, file: FileId, position: Position) -> Option<(Symbols, Symbol)> {
        let (_, text) = self.get(file)?;
        let symbols = Symbols::new(&self.parsed);
        let symbol = symbols.at(file, Lines::new(text).byte(position))?.symbol;
        Some((symbols, symbol))
    }

    /// Place where the symbol at a position is defined.
    pub(super) fn definition(&self, file: FileId, position: Position) -> Option<Location> {
        let (symbols, symbol) = self.symbol(file, position)?;
        self.location(symbols.definition(symbol)?)
    }

    /// All places of the symbol at a position.
    pub(super) fn references(&self, file: FileId, position: Position, with_definition: bool) -> Option<Vec<Location>> {
        let (symbols, symbol) = self.symbol(file, position)?;
        let wanted = symbols.of(symbol).filter(|row| with_definition || row.role != Role::Definition);
        Some(wanted.filter_map(|row| self.location(row.place)).collect())
    }

    /// Occurrences of the symbol in one file, each as a read or a write.
    pub(super) fn highlights(&self, file: FileId, position: Position) -> Option<Vec<DocumentHighlight>> {
        let (symbols, symbol) = self.symbol(file, position)?;
        let lines = Lines::new(self.get(file)?.1);
        let here = symbols.of(symbol).filter(|row| row.place.file == file);
        let one = |row: &macroline::nc::symbols::Occurrence| DocumentHighlight {
            range: lines.range(row.place.span),
            kind: Some(match row.role {
                Role::Definition | Role::Write | Role::Argument => DocumentHighlightKind::WRITE,
                _ => DocumentHighlightKind::READ,
            }),
        };
        Some(here.map(one).collect())
    }

    /// The outline of a file.
    pub(super) fn outline(&self, file: FileId) -> Option<Vec<DocumentSymbol>> {
        let lines = Lines::new(self.get(file)?.1);
        let entries = Symbols::new(&self.parsed).outline(&self.parsed, file);
        Some(entries.into_iter().map(|entry| self.entry(entry, &lines)).collect())
    }

    #[allow(deprecated, reason = "the type has a field that the protocol gave up")]
    fn entry(&self, entry: OutlineItem, lines: &Lines) -> DocumentSymbol {
        let kind = match entry.symbol {
            Symbol::Program(_) => SymbolKind::MODULE,
            Symbol::Block(_) => SymbolKind::KEY,
            Symbol::Variable(_) | Symbol::Local { .. } => SymbolKind::VARIABLE,
        };
        let line = self.setup.words().line(&entry);
        let children = entry.children.into_iter().map(|child| self.entry(child, lines)).collect();
        DocumentSymbol {
            name: entry.name,
            detail: Some(line).filter(|text| !text.is_empty()),
            kind,
            tags: None,
            deprecated: None,
            range: lines.range(entry.whole),
            selection_range: lines.range(entry.span),
            children: Some(children),
        }
    }
}
