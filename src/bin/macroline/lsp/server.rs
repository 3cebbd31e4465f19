//! The course of a session: start, messages of the client, end. Total on any messages.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{
    DidChangeConfiguration, DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, DidSaveTextDocument,
    Exit, Initialized, Notification as _, PublishDiagnostics, ShowMessage,
};
use lsp_types::request::{
    CodeActionRequest, Completion, DocumentHighlightRequest, DocumentSymbolRequest, GotoDefinition, HoverRequest,
    Initialize, References, Request as _, Shutdown, WorkspaceConfiguration,
};
use lsp_types::{
    CodeActionKind, CodeActionOptions, CodeActionParams, CodeActionProviderCapability, CompletionOptions,
    ConfigurationItem, ConfigurationParams, DidChangeConfigurationParams, DidChangeTextDocumentParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams, DocumentSymbolResponse,
    GotoDefinitionResponse, HoverProviderCapability, InitializeParams, InitializeResult, MessageType, OneOf, Position,
    PublishDiagnosticsParams, ReferenceParams, ServerCapabilities, ServerInfo, ShowMessageParams,
    TextDocumentPositionParams, TextDocumentSyncCapability, TextDocumentSyncKind, TextDocumentSyncOptions, Url,
};
use macroline::controls;
use macroline::msg;
use macroline::text::catalog::sentence;
use macroline::text::{FileId, listed};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::documents::{OpenDocuments, Programs};
use super::findings::{FIX_ALL, remark};
use super::setup::ControlSetup;
use crate::language::speak_as_client;
use crate::output::Failure;

/// Name of the settings in an editor, and of the server.
const NAME: &str = "macroline";

/// Phase of a session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SessionPhase {
    /// The client has not sent `initialize` yet.
    Begins,
    /// Requests are answered.
    Serves,
    /// The client is about to end.
    ShutDown,
    /// Nothing more is read.
    Ended {
        /// Whether the client sent `shutdown` before `exit`, as the protocol requires.
        after_shutdown: bool,
    },
}

/// An error of a request: its code and a sentence.
type Refusal = (ErrorCode, String);

/// One session with a client.
pub(super) struct Server {
    phase: SessionPhase,
    documents: OpenDocuments,
    /// The control is fixed by the command line, so the editor's settings are ignored.
    fixed: bool,
    /// The client shows related information beside a diagnostic.
    related: bool,
    /// The client answers a request for its settings.
    asks_settings: bool,
    /// Number of the last request to the client.
    last: i32,
    /// Messages to the client.
    out: Vec<Message>,
}

impl Server {
    /// A session with the control that the command line names.
    pub(super) fn new(asked: Option<ControlSetup>) -> Server {
        let fixed = asked.is_some();
        let mut documents = OpenDocuments::default();
        documents.ask(asked);
        Server {
            phase: SessionPhase::Begins,
            documents,
            fixed,
            related: false,
            asks_settings: false,
            last: 0,
            out: Vec::new(),
        }
    }

    /// Phase of the session.
    pub(super) fn phase(&self) -> SessionPhase {
        self.phase
    }

    /// Messages for the client since the last call, with the diagnostics of the changed files.
    pub(super) fn sends(&mut self) -> Vec<Message> {
        for address in self.documents.changed() {
            self.publish(&address);
        }
        core::mem::take(&mut self.out)
    }

    /// Takes a message of the client.
    pub(super) fn take(&mut self, message: Message) {
        match message {
            Message::Request(request) => {
                let id = request.id.clone();
                let response = match self.answer(request) {
                    Ok(result) => Response::new_ok(id, result),
                    Err((code, why)) => Response::new_err(id, code as i32, why),
                };
                self.out.push(response.into());
            }
            Message::Notification(notification) => self.note(notification),
            Message::Response(response) => self.answered(response),
        }
    }

    /// The result of a request.
    fn answer(&mut self, request: Request) -> Result<Json, Refusal> {
        let Request { method, params, .. } = request;
        match (self.phase, method.as_str()) {
            (SessionPhase::Begins, Initialize::METHOD) => return with(params, |params| self.begin(params)),
            (SessionPhase::Begins, _) => {
                return Err((ErrorCode::ServerNotInitialized, sentence(&msg!("lsp.not-begun"))));
            }
            (SessionPhase::Serves, Initialize::METHOD) | (SessionPhase::ShutDown | SessionPhase::Ended { .. }, _) => {
                return Err((ErrorCode::InvalidRequest, sentence(&msg!("lsp.not-now", method))));
            }
            (SessionPhase::Serves, Shutdown::METHOD) => {
                self.phase = SessionPhase::ShutDown;
                return Ok(Json::Null);
            }
            (SessionPhase::Serves, _) => {}
        }
        let related = self.related;
        match method.as_str() {
            HoverRequest::METHOD => with(params, |params: lsp_types::HoverParams| {
                self.at(&params.text_document_position_params, Programs::hover)
            }),
            Completion::METHOD => with(params, |params: lsp_types::CompletionParams| {
                self.at(&params.text_document_position, Programs::completion)
            }),
            GotoDefinition::METHOD => with(params, |params: lsp_types::GotoDefinitionParams| {
                let found = self.at(&params.text_document_position_params, Programs::definition);
                found.map(GotoDefinitionResponse::Scalar)
            }),
            References::METHOD => with(params, |params: ReferenceParams| {
                let all = params.context.include_declaration;
                self.at(&params.text_document_position, |programs, file, at| programs.references(file, at, all))
            }),
            DocumentHighlightRequest::METHOD => with(params, |params: lsp_types::DocumentHighlightParams| {
                self.at(&params.text_document_position_params, Programs::highlights)
            }),
            DocumentSymbolRequest::METHOD => with(params, |params: lsp_types::DocumentSymbolParams| {
                let outline = self.in_file(&params.text_document.uri, Programs::outline);
                outline.map(DocumentSymbolResponse::Nested)
            }),
            CodeActionRequest::METHOD => with(params, |params: CodeActionParams| {
                let CodeActionParams { text_document, range, context, .. } = params;
                let mut found =
                    self.in_file(&text_document.uri, |programs, file| Some(programs.actions(file, range, related)));
                if let (Some(found), Some(only)) = (&mut found, context.only) {
                    found.retain(|action| is_wanted(action, &only));
                }
                found
            }),
            _ => Err((ErrorCode::MethodNotFound, sentence(&msg!("lsp.no-method", method)))),
        }
    }

    /// Something about a file.
    fn in_file<T>(&mut self, address: &Url, ask: impl FnOnce(&Programs, FileId) -> Option<T>) -> Option<T> {
        let programs = self.documents.programs(address)?;
        ask(programs, programs.file(address)?)
    }

    /// Answer about a position in a file.
    fn at<T>(
        &mut self,
        place: &TextDocumentPositionParams,
        ask: impl FnOnce(&Programs, FileId, Position) -> Option<T>,
    ) -> Option<T> {
        self.in_file(&place.text_document.uri, |programs, file| ask(programs, file, place.position))
    }

    /// Handles `initialize`: the abilities of the client, and of the server in the answer.
    fn begin(&mut self, params: InitializeParams) -> InitializeResult {
        self.phase = SessionPhase::Serves;
        params.locale.as_deref().iter().for_each(|locale| speak_as_client(locale));
        let shown = params.capabilities.text_document.and_then(|text| text.publish_diagnostics);
        self.related = shown.and_then(|shown| shown.related_information).unwrap_or(false);
        let workspace = params.capabilities.workspace;
        self.asks_settings = workspace.and_then(|workspace| workspace.configuration).unwrap_or(false);
        if let Some(options) = params.initialization_options {
            self.settings(&options);
        }
        let sync = TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::INCREMENTAL),
            save: Some(true.into()),
            ..TextDocumentSyncOptions::default()
        };
        let capabilities = ServerCapabilities {
            text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
            hover_provider: Some(HoverProviderCapability::Simple(true)),
            completion_provider: Some(CompletionOptions {
                trigger_characters: Some(vec!["#".to_owned()]),
                ..CompletionOptions::default()
            }),
            definition_provider: Some(OneOf::Left(true)),
            references_provider: Some(OneOf::Left(true)),
            document_highlight_provider: Some(OneOf::Left(true)),
            document_symbol_provider: Some(OneOf::Left(true)),
            code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
                code_action_kinds: Some(vec![CodeActionKind::QUICKFIX, FIX_ALL]),
                ..CodeActionOptions::default()
            })),
            ..ServerCapabilities::default()
        };
        let version = Some(env!("CARGO_PKG_VERSION").to_owned());
        InitializeResult { capabilities, server_info: Some(ServerInfo { name: NAME.to_owned(), version }) }
    }

    /// Handles a notification, which gets no answer. Unreadable parameters are ignored, as the protocol requires.
    fn note(&mut self, notification: Notification) {
        let Notification { method, params } = notification;
        match (method.as_str(), self.phase) {
            (Exit::METHOD, phase) => {
                self.phase = SessionPhase::Ended { after_shutdown: phase == SessionPhase::ShutDown }
            }
            (Initialized::METHOD, SessionPhase::Serves) => self.ask_settings(),
            (DidOpenTextDocument::METHOD, SessionPhase::Serves) => note(params, |params: DidOpenTextDocumentParams| {
                self.documents.open(params.text_document.uri, params.text_document.text);
            }),
            (DidChangeTextDocument::METHOD, SessionPhase::Serves) => {
                note(params, |params: DidChangeTextDocumentParams| {
                    self.documents.change(&params.text_document.uri, params.content_changes);
                })
            }
            (DidSaveTextDocument::METHOD, SessionPhase::Serves) => note(params, |params: DidSaveTextDocumentParams| {
                self.documents.saved(&params.text_document.uri);
            }),
            (DidCloseTextDocument::METHOD, SessionPhase::Serves) => {
                note(params, |params: DidCloseTextDocumentParams| {
                    self.documents.close(&params.text_document.uri);
                    self.show(params.text_document.uri, Vec::new());
                })
            }
            (DidChangeConfiguration::METHOD, SessionPhase::Serves) => {
                note(params, |params: DidChangeConfigurationParams| match params.settings.get(NAME) {
                    Some(settings) => self.settings(settings),
                    None => self.ask_settings(),
                })
            }
            _ => {}
        }
    }

    /// Asks the client for its settings, if it supports that request.
    fn ask_settings(&mut self) {
        if self.asks_settings {
            let item = ConfigurationItem { scope_uri: None, section: Some(NAME.to_owned()) };
            self.last = self.last.wrapping_add(1);
            let (method, params) =
                (WorkspaceConfiguration::METHOD.to_owned(), ConfigurationParams { items: vec![item] });
            self.out.push(Request::new(RequestId::from(self.last), method, params).into());
        }
    }

    /// The client answers a request: the last one for its settings counts.
    fn answered(&mut self, response: Response) {
        let settings = response.response_result.ok().and_then(|result| result.get(0).cloned());
        if let Some(settings) = settings.filter(|settings| settings.is_object() && response.id == self.last.into()) {
            self.settings(&settings);
        }
    }

    /// Takes the settings of the editor; unknown names are reported.
    fn settings(&mut self, settings: &Json) {
        if self.fixed {
            return;
        }
        match ControlSetup::of_settings(settings) {
            Ok(setup) => self.documents.ask(setup),
            Err(failure) => {
                let message = match failure {
                    Failure::Usage(text) | Failure::Outside(text) => text,
                    _ => sentence(&msg!("lsp.settings")),
                };
                let params = ShowMessageParams { typ: MessageType::ERROR, message };
                self.out.push(Notification::new(ShowMessage::METHOD.to_owned(), params).into());
            }
        }
    }

    /// Reads the programs beside a file and sends the diagnostics of each.
    fn publish(&mut self, address: &Url) {
        let related = self.related;
        for address in self.documents.beside(address) {
            let found = self.in_file(&address, |programs, file| Some(programs.diagnostics(file, related)));
            let known = || listed(controls::ALL.iter().map(|control| control.id));
            self.show(
                address,
                found.unwrap_or_else(|| vec![remark(sentence(&msg!("lsp.no-control", controls = known())))]),
            );
        }
    }

    /// Sends the diagnostics of a file.
    fn show(&mut self, uri: Url, diagnostics: Vec<lsp_types::Diagnostic>) {
        let params = PublishDiagnosticsParams { uri, diagnostics, version: None };
        self.out.push(Notification::new(PublishDiagnostics::METHOD.to_owned(), params).into());
    }
}

/// Whether an action is of a kind that the client wants; `source` has `source.fixAll`.
fn is_wanted(action: &lsp_types::CodeActionOrCommand, only: &[CodeActionKind]) -> bool {
    let lsp_types::CodeActionOrCommand::CodeAction(action) = action else { return false };
    let Some(kind) = &action.kind else { return false };
    only.iter().any(|wanted| {
        let rest = kind.as_str().strip_prefix(wanted.as_str());
        rest.is_some_and(|rest| wanted.as_str().is_empty() || rest.is_empty() || rest.starts_with('.'))
    })
}

/// The result of `answer` for parsed parameters, or the reason why they cannot be parsed.
fn with<P: DeserializeOwned, R: Serialize>(params: Json, ask: impl FnOnce(P) -> R) -> Result<Json, Refusal> {
    let refused = |error: serde_json::Error| {
        (ErrorCode::InvalidParams, sentence(&msg!("lsp.parameters", reason = error.to_string())))
    };
    let params = serde_json::from_value(params).map_err(refused)?;
    serde_json::to_value(ask(params)).map_err(refused)
}

/// Passes parameters to a function if they can be parsed.
fn note<P: DeserializeOwned>(params: Json, take: impl FnOnce(P)) {
    if let Ok(params) = serde_json::from_value(params) {
        take(params);
    }
}
