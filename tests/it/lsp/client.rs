//! A client of the language server for tests, which handles one message at a time.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Stdio};

use serde_json::{Value as Json, json};

use crate::command;

/// A session with the server.
pub(super) struct Client {
    child: Child,
    output: BufReader<ChildStdout>,
    last: i64,
    /// Messages that were read while another was waited for.
    waiting: Vec<Json>,
}

/// A folder of its own for one test.
pub(super) fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("lsp").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// The address of a file.
pub(super) fn address(path: &Path) -> String {
    format!("file://{}", path.display())
}

/// Parameters of a request about a position.
pub(super) fn position(uri: &str, line: u32, character: u32) -> Json {
    json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } })
}

impl Client {
    /// Starts the server with these arguments and introduces the client.
    pub(super) fn start(args: &[&str]) -> Client {
        let mut client = Client::before_start(args);
        client.introduce();
        client
    }

    /// Starts the server.
    pub(super) fn before_start(args: &[&str]) -> Client {
        let mut child =
            command::macroline().arg("lsp").args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        Client { child, output, last: 0, waiting: Vec::new() }
    }

    /// Introduces the client.
    pub(super) fn introduce(&mut self) {
        self.introduce_with(json!({}));
    }

    /// Initializes the session with further parameters.
    pub(super) fn introduce_with(&mut self, more: Json) {
        let mut about = json!({ "processId": null, "rootUri": null, "capabilities": {} });
        about.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        let found = self.ask("initialize", about);
        assert_eq!(found["serverInfo"]["name"], "macroline");
        self.tell("initialized", json!({}));
    }

    /// Sends bytes as they are.
    pub(super) fn send(&mut self, text: &str) {
        let input = self.child.stdin.as_mut().unwrap();
        input.write_all(text.as_bytes()).unwrap();
        input.flush().unwrap();
    }

    fn send_json(&mut self, message: &Json) {
        let text = message.to_string();
        self.send(&format!("Content-Length: {}\r\n\r\n{text}", text.len()));
    }

    /// Sends a notification.
    pub(super) fn tell(&mut self, method: &str, params: Json) {
        self.send_json(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The next message of the server.
    #[track_caller]
    pub(super) fn message(&mut self) -> Json {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "the server has ended");
            if let Some(digits) = line.strip_prefix("Content-Length: ") {
                length = digits.trim().parse().unwrap();
            }
            if line == "\r\n" {
                break;
            }
        }
        let mut bytes = vec![0; length];
        self.output.read_exact(&mut bytes).unwrap();
        serde_json::from_slice(&bytes).unwrap()
    }

    #[track_caller]
    fn wait(&mut self, is: impl Fn(&Json) -> bool) -> Json {
        if let Some(at) = self.waiting.iter().position(&is) {
            return self.waiting.remove(at);
        }
        loop {
            let message = self.message();
            if is(&message) {
                return message;
            }
            self.waiting.push(message);
        }
    }

    #[track_caller]
    fn request(&mut self, method: &str, params: Json) -> Json {
        self.last += 1;
        let id = self.last;
        self.send_json(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        self.wait(|message| message["id"] == id && message["method"].is_null())
    }

    /// The result of a request.
    #[track_caller]
    pub(super) fn ask(&mut self, method: &str, params: Json) -> Json {
        let answer = self.request(method, params);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// The code of the error of a request.
    #[track_caller]
    pub(super) fn refused(&mut self, method: &str, params: Json) -> i64 {
        let answer = self.request(method, params);
        answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("{method} is answered: {answer}"))
    }

    /// The result of a request about a position.
    #[track_caller]
    pub(super) fn at(&mut self, method: &str, uri: &str, line: u32, character: u32) -> Json {
        self.ask(method, position(uri, line, character))
    }

    /// The parameters of the next notification of a method.
    #[track_caller]
    pub(super) fn next(&mut self, method: &str) -> Json {
        self.wait(|message| message["method"] == method)["params"].clone()
    }

    /// The next diagnostics of a file.
    #[track_caller]
    pub(super) fn diagnostics(&mut self, uri: &str) -> Json {
        let is =
            |message: &Json| message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == uri;
        self.wait(is)["params"]["diagnostics"].clone()
    }

    /// Opens a file; its diagnostics.
    #[track_caller]
    pub(super) fn open(&mut self, uri: &str, text: &str) -> Json {
        let document = json!({ "uri": uri, "languageId": "nc", "version": 1, "text": text });
        self.waiting.clear();
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
        self.diagnostics(uri)
    }

    /// Changes a file; its diagnostics.
    #[track_caller]
    pub(super) fn change(&mut self, uri: &str, changes: &[Json]) -> Json {
        self.waiting.clear();
        let document = json!({ "uri": uri, "version": 2 });
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
        self.diagnostics(uri)
    }

    /// Closes a file; the server then removes its diagnostics.
    #[track_caller]
    pub(super) fn close(&mut self, uri: &str) {
        self.waiting.clear();
        self.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
        assert_eq!(self.diagnostics(uri), json!([]));
    }

    /// Ends the session as the protocol requires.
    #[track_caller]
    pub(super) fn end(mut self) {
        assert_eq!(self.ask("shutdown", Json::Null), Json::Null);
        self.tell("exit", Json::Null);
        assert_eq!(self.status(), 0);
    }

    /// The exit status of the server.
    pub(super) fn status(&mut self) -> i32 {
        self.child.wait().unwrap().code().unwrap()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
