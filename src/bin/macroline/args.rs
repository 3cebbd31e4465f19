//! The arguments of the command line. Each doc comment is a text of its help, and a key of the catalogs of other languages.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use macroline::project::chance;
use macroline::project::requests::run_request::BUDGET;
use macroline::text::units::Lengths;

/// Sizes special CNC machines, writes their macro programs and runs that very text.
#[derive(Parser)]
#[command(name = "macroline", version)]
pub(crate) struct CommandLine {
    /// Units of lengths in texts and reports; programs, JSON and CSV have mm
    #[arg(long, global = true, value_enum, default_value_t)]
    pub(crate) lengths: LengthUnits,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Machines, controls and which goes with which
    List {
        /// Prints JSON, for other software
        #[arg(long)]
        json: bool,
    },
    /// Prints the catalogue of parts as CSV: take rows, change them, add them to a project
    Parts {
        /// Table of your own, CSV or JSON, to check and print instead of the catalogue
        table: Option<PathBuf>,
        /// Those that go with a control
        #[arg(long, value_name = "ID")]
        control: Option<String>,
        /// Prints this project with the parts of the table added, instead of a table
        #[arg(long, value_name = "PROJECT", requires = "table", conflicts_with_all = ["control", "json"])]
        add_to: Option<PathBuf>,
        /// JSON instead of CSV
        #[arg(long)]
        json: bool,
    },
    /// Prints an example of a machine as a project, JSON
    New {
        /// Machine, for instance ribbon-line
        machine: String,
        /// Control; without it the machine's first
        #[arg(long, value_name = "ID")]
        control: Option<String>,
        /// Example, see `list`; without it the machine's first, in which no verdict fails
        #[arg(long, value_name = "NAME")]
        example: Option<String>,
    },
    /// Results with verdicts, and findings
    Design {
        /// Project file
        project: PathBuf,
        /// Prints JSON, for other software
        #[arg(long)]
        json: bool,
    },
    /// Motors, operating envelope, limits and bill of materials, from runs of the program
    Size {
        /// Project file
        project: PathBuf,
        /// Draws so many machines with their assumed facts within a tenth, and tells how often every verdict holds
        #[arg(long, value_name = "N", default_value_t = 0)]
        draws: u32,
        /// Seed of the draws
        #[arg(long, value_name = "N", default_value_t = chance::SEED)]
        seed: u64,
        /// Prints JSON, for other software
        #[arg(long)]
        json: bool,
    },
    /// Variants of a machine side by side: entries, results and controls that differ
    Compare {
        /// Project files, two or more; or one that keeps variants: its present settings beside those
        #[arg(required = true)]
        projects: Vec<PathBuf>,
        /// Prints JSON, for other software
        #[arg(long)]
        json: bool,
    },
    /// Writes the files the control takes, parameter sheet and report; nothing when there is an error
    Export {
        /// Project file
        project: PathBuf,
        /// Folder, made where it is missing
        #[arg(long)]
        out: PathBuf,
        /// Date in the title block of the report, as its reader writes dates; without it the field stays empty
        #[arg(long, default_value = "")]
        date: String,
        /// Prints summary and report as PDF too, by a browser: Chromium, Chrome or Edge
        #[arg(long)]
        pdf: bool,
        /// Browser for the PDF; without it the first that is installed
        #[arg(long, value_name = "PROGRAM", requires = "pdf")]
        browser: Option<PathBuf>,
        /// Paper of the PDF
        #[arg(long, value_enum, default_value_t, requires = "pdf")]
        paper: Paper,
    },
    /// Draws the machine at a moment of its run, as SVG
    Draw {
        /// Project file
        project: PathBuf,
        /// Seconds from the start of the run; without it the machine before its start
        #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
        at: f64,
        /// Dark instead of light
        #[arg(long)]
        dark: bool,
        /// Picture file
        #[arg(long)]
        out: PathBuf,
    },
    /// Diagnostics of programs or of a project, nothing run
    Check {
        /// Program files with --control, or one project file
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Control that bare programs are for
        #[arg(long)]
        control: Option<String>,
        /// Settles an open point of the control, see `list`; repeat as needed
        #[arg(long = "switch", value_name = "ID=VALUE")]
        switch: Vec<String>,
        /// Leaves out a warning by its id, for instance lint.unreachable; repeat as needed
        #[arg(long, value_name = "ID")]
        silence: Vec<String>,
        /// Same as `--format json`
        #[arg(long)]
        json: bool,
        /// How the diagnostics are printed
        #[arg(long, value_enum, default_value_t, conflicts_with = "json")]
        format: Format,
    },
    /// Meaning of an alarm, code, variable, parameter, field or term, from the help of the page
    Explain {
        /// Number or word, for instance P62, G96, '#107' or slack; or an id of the help, for instance field.pitch
        word: String,
        /// Project file: its machine and control come first
        project: Option<PathBuf>,
        /// Control that comes first
        #[arg(long, value_name = "ID", conflicts_with = "project")]
        control: Option<String>,
        /// Prints JSON, for other software
        #[arg(long)]
        json: bool,
    },
    /// Language server on standard input and output, for editors; see docs/editors.md
    Lsp {
        /// Project whose control, settings and names of variables count for all programs
        #[arg(conflicts_with = "control")]
        project: Option<PathBuf>,
        /// Control of all programs; without it that of the editor's settings or of the folder
        #[arg(long, value_name = "ID")]
        control: Option<String>,
        /// Settles an open point of the control, see `list`; repeat as needed
        #[arg(long = "switch", value_name = "ID=VALUE")]
        switch: Vec<String>,
        /// Leaves out a warning by its id, for instance lint.unreachable; repeat as needed
        #[arg(long, value_name = "ID")]
        silence: Vec<String>,
    },
    /// Runs a project or programs and prints the canonical log
    Run {
        #[command(flatten)]
        args: RunArgs,
        /// Answers M00, M01 and messages of the program by cycle start
        #[arg(long = "continue")]
        goes_on: bool,
        /// Leaves the log out
        #[arg(long)]
        no_canon: bool,
        /// One JSON object instead of the log
        #[arg(long)]
        json: bool,
    },
    /// Runs a project or programs block by block: commands from standard input, “help” lists them
    Step(RunArgs),
}

#[derive(clap::Args)]
pub(crate) struct RunArgs {
    /// One project file, or program files with --control
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Control that bare programs are for
    #[arg(long)]
    pub(crate) control: Option<String>,
    /// Program to start, for instance O9101
    #[arg(long)]
    pub(crate) start: Option<String>,
    /// Sets a variable before the start, for instance '#107=8'; repeat as needed
    #[arg(long = "set", value_name = "VAR=VALUE")]
    pub(crate) set: Vec<String>,
    /// Settles an open point of the control, see `list`; repeat as needed
    #[arg(long = "switch", value_name = "ID=VALUE")]
    pub(crate) switch: Vec<String>,
    /// Panel file: the operator's actions, a JSON array
    #[arg(long)]
    pub(crate) panel: Option<PathBuf>,
    /// Project whose plant runs bare programs, instead of the control's bench
    #[arg(long)]
    pub(crate) plant: Option<PathBuf>,
    /// Ends the run after so many blocks
    #[arg(long, default_value_t = BUDGET.blocks)]
    pub(crate) blocks: u64,
    /// Ends the run after so many seconds of machine time
    #[arg(long, default_value_t = BUDGET.seconds)]
    pub(crate) seconds: f64,
    /// Leaves out a warning by its id, for instance lint.unreachable; repeat as needed
    #[arg(long, value_name = "ID")]
    pub(crate) silence: Vec<String>,
}

/// Units of lengths for people.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum LengthUnits {
    /// Millimetres
    #[default]
    Mm,
    /// Inches, and feet for surface speeds
    Inch,
}

impl From<LengthUnits> for Lengths {
    fn from(units: LengthUnits) -> Lengths {
        match units {
            LengthUnits::Mm => Lengths::Millimetres,
            LengthUnits::Inch => Lengths::Inches,
        }
    }
}

/// Paper of the PDF.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Paper {
    /// 210 mm by 297 mm
    #[default]
    A4,
    /// 8.5 inches by 11 inches
    Letter,
}

/// How the diagnostics are printed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Text for people
    #[default]
    Text,
    /// An object with their list
    Json,
    /// SARIF 2.1.0, for code hosts and editors
    Sarif,
}

impl From<bool> for Format {
    fn from(json: bool) -> Format {
        if json { Format::Json } else { Format::Text }
    }
}
