//! The language of the command line's texts: known before clap reads the arguments, because clap's help and errors are texts too.
//!
//! clap writes its help and its errors in English. The catalog of another language has the English texts of the help as keys, and a
//! sentence for each kind of error.

use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory, Error, FromArgMatches};
use macroline::msg;
use macroline::text::catalog::{self, Language, sentence, words};
use macroline::text::{Message, clauses, headed, listed};

use crate::args::CommandLine;
use crate::output::{print_error, reason};

/// Name of the option.
const OPTION: &str = "language";

/// Parses the arguments in the language that they or the system choose. Prints help or an error in that language, and returns its exit status.
pub(crate) fn line() -> Result<CommandLine, ExitCode> {
    catalog::speak(chosen(std::env::args_os().skip(1)).unwrap_or_else(of_system).sentences());
    let mut command = translated(CommandLine::command().arg(option()));
    let read = command.try_get_matches_from_mut(std::env::args_os());
    read.and_then(|matches| CommandLine::from_arg_matches(&matches))
        .map_err(|error| refused(error.format(&mut command)))
}

/// The option that chooses the language.
fn option() -> Arg {
    Arg::new(OPTION)
        .long(OPTION)
        .global(true)
        .value_name("LANGUAGE")
        .value_parser(PossibleValuesParser::new(Language::ALL.map(Language::code)))
        .help("Language of texts; without it that of the system")
}

/// The language that arguments choose: `--language zh` or `--language=zh`.
fn chosen(arguments: impl Iterator<Item = OsString>) -> Option<Language> {
    let mut arguments = arguments.take_while(|argument| argument != "--");
    let code = loop {
        let argument = arguments.next()?;
        let Some(option) = argument.to_str().and_then(|text| text.strip_prefix("--")?.strip_prefix(OPTION)) else {
            continue;
        };
        if option.is_empty() {
            break arguments.next()?.to_string_lossy().into_owned();
        }
        if let Some(code) = option.strip_prefix('=') {
            break code.to_owned();
        }
    };
    Language::of_code(&code)
}

/// The language of the operating system; English if there is no catalog of it.
fn of_system() -> Language {
    of_locale(&sys_locale::get_locale().unwrap_or_default()).unwrap_or(Language::English)
}

/// The language of a locale, `zh-CN`, `zh_CN.UTF-8` or `zh-cn`, where there is a file of it.
fn of_locale(locale: &str) -> Option<Language> {
    locale.to_lowercase().split(['-', '_', '.']).next().and_then(Language::of_code)
}

/// Speaks the language of a client's locale, unless the command line has chosen one.
pub(crate) fn speak_as_client(locale: &str) {
    if let (None, Some(language)) = (chosen(std::env::args_os().skip(1)), of_locale(locale)) {
        catalog::speak(language.sentences());
    }
}

/// The command with its help in the language that is spoken.
fn translated(mut command: Command) -> Command {
    if catalog::spoken() == Language::English {
        return command;
    }
    // Adds clap's own options and `help` to each command.
    command.build();
    command_in_words(command)
}

/// Translation of a text of the help, by its English text.
fn help_words(english: impl ToString) -> &'static str {
    words(english.to_string().leak())
}

/// A usage without clap's heading.
fn without_heading(usage: &str) -> &str {
    usage.trim().trim_start_matches("Usage:").trim_start()
}

/// Translates the texts of a command, its arguments and its subcommands.
fn command_in_words(mut command: Command) -> Command {
    let usage = command.render_usage().to_string();
    let usage = ["[OPTIONS]", "<COMMAND>", "[COMMAND]"]
        .into_iter()
        .fold(without_heading(&usage).to_owned(), |usage, placeholder| usage.replace(placeholder, words(placeholder)));
    let command = command.mut_args(argument_in_words).mut_subcommands(command_in_words);
    let about = match command.get_name() {
        "help" => Some(words("Print this message or the help of the given subcommand(s)")),
        _ => command.get_about().map(help_words),
    };
    let command = about.into_iter().fold(command, Command::about);
    let mut template = "{about}".to_owned();
    let mut section = |heading: &str, between: &str, rows: &str| template += &format!("\n\n{heading}{between}{rows}");
    section(words("Usage:"), "", "{usage}");
    if command.has_subcommands() {
        section(words("Commands:"), "\n", "{subcommands}");
    }
    if command.get_positionals().next().is_some() {
        section(words("Arguments:"), "\n", "{positionals}");
    }
    section(words("Options:"), "\n", "{options}");
    command.override_usage(usage).help_template(template)
}

/// An argument with translated help, to which its default and its possible values are added.
fn argument_in_words(argument: Arg) -> Arg {
    let mut text = match argument.get_id().as_str() {
        "help" => words("Print help").to_owned(),
        "version" => words("Print version").to_owned(),
        _ => argument.get_help().map(help_words).unwrap_or_default().to_owned(),
    };
    if argument.get_action().takes_values() {
        let values = argument.get_possible_values();
        let value = |value: &clap::builder::PossibleValue| match value.get_help() {
            Some(help) => headed(value.get_name(), help_words(help)),
            None => value.get_name().to_owned(),
        };
        if !values.is_empty() {
            text += &sentence(&msg!("cli.possible-values", values = clauses(values.iter().map(value))));
        }
        let default: Vec<_> = argument.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
        if default.iter().any(|value| !value.is_empty()) {
            text += &sentence(&msg!("cli.default", values = listed(default)));
        }
    }
    argument.help(text.clone()).long_help(text).hide_default_value(true).hide_possible_values(true)
}

/// Prints the requested help, or the error of the arguments; returns the exit status.
fn refused(error: Error) -> ExitCode {
    let status = u8::try_from(error.exit_code()).unwrap_or(2);
    let is_help = matches!(
        error.kind(),
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    );
    // A closed output leaves only the exit status to report the error.
    let _ = if catalog::spoken() == Language::English || is_help {
        error.print().map_err(Into::into)
    } else {
        print_error(&error_text(&error))
    };
    ExitCode::from(status)
}

/// Error of clap in the chosen language: message, similar names, and the usage.
fn error_text(error: &Error) -> String {
    let mut lines = vec![sentence(&msg!("cli.error", reason = sentence(&error_message(error))))];
    let known = context(error, ContextKind::ValidValue);
    if !known.is_empty() {
        lines.push(format!("  {}", sentence(&msg!("cli.possible-values", values = known)).trim_start()));
    }
    let similar = [ContextKind::SuggestedArg, ContextKind::SuggestedSubcommand, ContextKind::SuggestedValue];
    for similar in similar.map(|kind| context(error, kind)).iter().filter(|similar| !similar.is_empty()) {
        lines.push(format!("\n  {}", sentence(&msg!("cli.similar", similar = similar.as_str()))));
    }
    let usage = context(error, ContextKind::Usage);
    if !usage.is_empty() {
        lines.push(format!("\n{}{}", words("Usage:"), without_heading(&usage)));
    }
    lines.push(format!("\n{}\n", words("For more information, try '--help'.")));
    lines.join("\n")
}

/// Part of an error's context; empty if it has none.
fn context(error: &Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::Strings(list)) => listed(list),
        Some(value) => value.to_string(),
        None => String::new(),
    }
}

/// Message for an error in the arguments.
fn error_message(error: &Error) -> Message {
    let context = |kind| context(error, kind);
    let (argument, value) = (context(ContextKind::InvalidArg), context(ContextKind::InvalidValue));
    match error.kind() {
        ErrorKind::ArgumentConflict if context(ContextKind::PriorArg) == argument => {
            msg!("cli.error.repeated", argument)
        }
        ErrorKind::ArgumentConflict => msg!("cli.error.conflict", argument, other = context(ContextKind::PriorArg)),
        ErrorKind::InvalidValue if value.is_empty() => msg!("cli.error.no-value", argument),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => msg!("cli.error.invalid-value", value, argument),
        ErrorKind::InvalidSubcommand => msg!("cli.error.no-command", command = context(ContextKind::InvalidSubcommand)),
        ErrorKind::MissingRequiredArgument => msg!("cli.error.missing", arguments = argument),
        ErrorKind::MissingSubcommand => {
            msg!("cli.error.missing-command", command = context(ContextKind::InvalidSubcommand))
        }
        ErrorKind::TooManyValues => msg!("cli.error.unexpected-value", value, argument),
        ErrorKind::UnknownArgument => msg!("cli.error.unexpected", argument),
        _ => msg!("cli.error.unreadable"),
    }
}

/// Names the path before an error of reading or writing it.
pub(crate) fn failed(path: &Path, error: &io::Error) -> String {
    headed(path.display().to_string(), reason(error))
}
