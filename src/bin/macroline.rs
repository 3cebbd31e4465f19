//! The command line: the same door as the page, for engineers and for tests.
//!
//! Exit status: 0, 1 when there is an error diagnostic, 2 for wrong usage. Diagnostics go to standard error as text, or into the JSON.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    native::main()
}

/// The browser has the page instead.
#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
mod native {
    #![allow(clippy::print_stdout, reason = "printing is what a command line is for")]

    use std::io::{self, BufWriter, IsTerminal, Write};
    use std::path::{Path, PathBuf};
    use std::process::ExitCode;
    use std::rc::Rc;

    use clap::{Parser, Subcommand};
    use serde_json::{Value as Json, json};

    use macroline::controls::{self, Control, Dialect, Switches};
    use macroline::interp;
    use macroline::motion::{Budget, Panel, Retention};
    use macroline::nc::{self, File, Files};
    use macroline::project::check::review;
    use macroline::project::console::{Console, Outcome};
    use macroline::project::render::{Teller, summary};
    use macroline::project::run::{self, Run, RunOptions, Setting};
    use macroline::project::suppress::silence;
    use macroline::project::{Project, list, saved};
    use macroline::text::catalog;
    use macroline::text::{Diagnostic, Severity};

    /// Sizes special CNC machines, writes their macro programs and runs that very text.
    #[derive(Parser)]
    #[command(name = "macroline", version)]
    struct Line {
        #[command(subcommand)]
        command: Command,
    }

    #[derive(Subcommand)]
    enum Command {
        /// Machines, controls and which goes with which
        List {
            /// For programs
            #[arg(long)]
            json: bool,
        },
        /// Prints a default project as JSON
        New {
            /// Machine, for instance ribbon-line
            machine: String,
            /// Control; without it the machine's first
            #[arg(long)]
            control: Option<String>,
        },
        /// Results with verdicts, and what is wrong
        Design {
            /// Project file
            project: PathBuf,
            /// For programs
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
            /// For programs
            #[arg(long)]
            json: bool,
        },
        /// Runs a project or programs and prints the canonical log
        Run {
            #[command(flatten)]
            args: RunArgs,
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
    struct RunArgs {
        /// One project file, or program files with --control
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Control that bare programs are for
        #[arg(long)]
        control: Option<String>,
        /// Program to start, for instance O9101
        #[arg(long)]
        start: Option<String>,
        /// Sets a variable before the start, for instance '#107=8'; repeat as needed
        #[arg(long = "set", value_name = "VAR=VALUE")]
        set: Vec<String>,
        /// Settles an open point of the control, see `list`; repeat as needed
        #[arg(long = "switch", value_name = "ID=VALUE")]
        switch: Vec<String>,
        /// The operator's hand: JSON array of events
        #[arg(long)]
        panel: Option<PathBuf>,
        /// Project whose plant runs bare programs, instead of the control's bench
        #[arg(long)]
        plant: Option<PathBuf>,
        /// Ends the run after so many blocks
        #[arg(long, default_value_t = 10_000_000)]
        blocks: u64,
        /// Ends the run after so many seconds of machine time
        #[arg(long, default_value_t = 3600.0)]
        seconds: f64,
        /// Leaves out a warning by its id, for instance lint.unreachable; repeat as needed
        #[arg(long, value_name = "ID")]
        silence: Vec<String>,
    }

    /// Why a command did not get as far as diagnostics.
    enum Failure {
        /// Wrong usage: exit 2.
        Usage(String),
        /// Errors have been told: exit 1.
        Told,
        /// The reader of our output has gone away.
        Output(io::Error),
    }

    impl From<io::Error> for Failure {
        fn from(error: io::Error) -> Failure {
            Failure::Output(error)
        }
    }

    pub(super) fn main() -> ExitCode {
        let done = match Line::parse().command {
            Command::List { json } => print(if json { pretty(&list::json()) } else { list::text() }),
            Command::New { machine, control } => new(&machine, control.as_deref()),
            Command::Design { project, json } => design(&project, json),
            Command::Export { project, out } => export(&project, &out),
            Command::Check { files, control, switch, silence, json } => {
                check(&files, control.as_deref(), &switch, &silence, json)
            }
            Command::Run { args, no_canon, json } => run(&args, !no_canon, json),
            Command::Step(args) => step(&args),
        };
        match done {
            Ok(()) => ExitCode::SUCCESS,
            Err(Failure::Told) => ExitCode::from(1),
            Err(Failure::Usage(message)) => {
                eprintln!("macroline: {message}");
                ExitCode::from(2)
            }
            Err(Failure::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
            Err(Failure::Output(error)) => {
                eprintln!("macroline: {error}");
                ExitCode::from(2)
            }
        }
    }

    fn print(text: String) -> Result<(), Failure> {
        Ok(io::stdout().write_all(text.as_bytes())?)
    }

    fn pretty(json: &Json) -> String {
        format!("{json:#}\n")
    }

    /// Errors have been seen: exit 1.
    fn verdict(diagnostics: &[Diagnostic]) -> Result<(), Failure> {
        if diagnostics.iter().any(|d| d.severity == Severity::Error) { Err(Failure::Told) } else { Ok(()) }
    }

    fn tell(files: &Files, diagnostics: &[Diagnostic]) {
        if diagnostics.is_empty() {
            return;
        }
        let teller = Teller::new(files);
        for diagnostic in diagnostics {
            eprintln!("{}", teller.text(diagnostic));
        }
        eprintln!("{}", summary(diagnostics));
    }

    fn read(path: &Path) -> Result<String, Failure> {
        let bytes = std::fs::read(path).map_err(|error| Failure::Usage(format!("{}: {error}", path.display())))?;
        Ok(String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()))
    }

    fn project(path: &Path) -> Result<(Project, Vec<Diagnostic>), Failure> {
        let loaded = Project::from_json(&read(path)?);
        match loaded.project {
            Some(project) => Ok((project, loaded.diagnostics)),
            None => {
                tell(&Files::default(), &loaded.diagnostics);
                Err(Failure::Told)
            }
        }
    }

    fn control(id: &str) -> Result<&'static Control, Failure> {
        controls::find(id).ok_or_else(|| {
            let known = controls::ALL.iter().map(|c| c.id).collect::<Vec<_>>().join(", ");
            Failure::Usage(format!("no control “{id}”; there are: {known}"))
        })
    }

    /// Switches with some set anew, `ID=VALUE` each.
    fn switched(mut switches: Switches, settings: &[String], control: &Control) -> Result<Switches, Failure> {
        for setting in settings {
            let Some((id, value)) = setting.split_once('=') else {
                return Err(Failure::Usage(format!("--switch takes ID=VALUE, not “{setting}”")));
            };
            let Some(row) = control.switch(id) else {
                let known = control.switches.iter().map(|row| row.id()).collect::<Vec<_>>().join(", ");
                let message = format!("--switch: the {} has no switch “{id}”; there are: {known}", control.name);
                return Err(Failure::Usage(message));
            };
            if !row.takes(value) {
                let values = list::switch_values(row);
                return Err(Failure::Usage(format!("--switch: {id} cannot be “{value}”; it can be: {values}")));
            }
            switches.set(row, value);
        }
        Ok(switches)
    }

    fn new(machine: &str, control: Option<&str>) -> Result<(), Failure> {
        match Project::of(machine, control) {
            Some(project) => print(project.to_json()),
            None => Err(Failure::Usage(format!("no such machine and control:\n{}", list::text()))),
        }
    }

    fn design(path: &Path, json: bool) -> Result<(), Failure> {
        let (project, mut diagnostics) = project(path)?;
        let design = project.design();
        diagnostics.extend(design.diagnostics.iter().cloned());
        let files = Files::default();
        if json {
            let teller = Teller::new(&files);
            let told: Vec<Json> = diagnostics.iter().map(|d| teller.json(d)).collect();
            print(pretty(&json!({ "readouts": list::readouts_json(&design.readouts), "diagnostics": told })))?;
        } else {
            print(list::readouts_text(&design.readouts))?;
            tell(&files, &diagnostics);
        }
        verdict(&diagnostics)
    }

    fn export(path: &Path, out: &Path) -> Result<(), Failure> {
        let (project, mut diagnostics) = project(path)?;
        let export = project.export_with(&project.advice(&project.written()));
        diagnostics.extend(export.diagnostics);
        tell(&export.about, &diagnostics);
        verdict(&diagnostics)?;
        let fail = |path: &Path, error| Failure::Usage(format!("{}: {error}", path.display()));
        std::fs::create_dir_all(out).map_err(|error| fail(out, error))?;
        for file in &export.files {
            let path = out.join(&file.name);
            std::fs::write(&path, &file.text).map_err(|error| fail(&path, error))?;
            println!("{}", path.display());
        }
        Ok(())
    }

    fn programs(paths: &[PathBuf]) -> Result<Files, Failure> {
        let mut files = Vec::new();
        for path in paths {
            let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            files.push(File { name, text: read(path)? });
        }
        Ok(Files(files))
    }

    fn check(
        paths: &[PathBuf],
        id: Option<&str>,
        settings: &[String],
        silenced: &[String],
        json: bool,
    ) -> Result<(), Failure> {
        let mut silenced = known(silenced)?;
        let (files, mut diagnostics) = match id {
            Some(id) => {
                let control = control(id)?;
                let switches = switched(Switches::default(), settings, control)?;
                let parsed = Rc::new(nc::parse_with(&programs(paths)?, control, &switches));
                (parsed.files().clone(), review(&parsed, None, &[]))
            }
            None => {
                let (mut project, mut diagnostics) = project(only_project(paths)?)?;
                project.switches = switched(project.switches, settings, project.control)?;
                diagnostics.extend(project.design().diagnostics);
                let written = project.written();
                diagnostics.extend(project.advice(&written));
                diagnostics.extend(written.diagnostics);
                Diagnostic::in_order(&mut diagnostics);
                silenced.extend(project.silenced);
                (written.files, diagnostics)
            }
        };
        let count = silence(&mut diagnostics, &silenced);
        if json {
            let teller = Teller::new(&files);
            let told: Vec<Json> = diagnostics.iter().map(|d| teller.json(d)).collect();
            print(pretty(&json!({ "diagnostics": told })))?;
        } else {
            tell(&files, &diagnostics);
            if diagnostics.is_empty() {
                eprintln!("{}", summary(&diagnostics));
            }
            tell_silenced(count);
        }
        verdict(&diagnostics)
    }

    /// Ids of warnings that there are.
    fn known(ids: &[String]) -> Result<Vec<String>, Failure> {
        match ids.iter().find(|id| catalog::id(id).is_none()) {
            Some(id) => Err(Failure::Usage(format!(
                "--silence: there is no warning “{id}”; each shows its id in brackets, for instance lint.unreachable"
            ))),
            None => Ok(ids.to_vec()),
        }
    }

    fn tell_silenced(count: usize) {
        if count > 0 {
            eprintln!("{count} silenced");
        }
    }

    /// The project file among arguments that name no control.
    fn only_project(paths: &[PathBuf]) -> Result<&Path, Failure> {
        match paths {
            [path] if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) => Ok(path),
            _ => Err(Failure::Usage("bare program files need --control".to_owned())),
        }
    }

    /// Variables and inputs that can be set on this control.
    fn settable(settings: &[Setting], control: &Control, dialect: &Dialect) -> Result<(), Failure> {
        match settings.iter().find(|setting| setting.action(control, dialect).is_none()) {
            Some(setting) => {
                let name = &setting.name;
                Err(Failure::Usage(format!("--set: the control has no variable and no input “{name}” that can be set")))
            }
            None => Ok(()),
        }
    }

    /// What is run.
    struct Prepared {
        run: Run,
        /// The files that places are in.
        files: Files,
        /// What is to be said already.
        found: Vec<Diagnostic>,
        /// Ids of what is not.
        silenced: Vec<String>,
    }

    fn prepare(args: &RunArgs, keep: Retention) -> Result<Prepared, Failure> {
        if args.seconds.is_nan() || args.seconds < 0.0 {
            return Err(Failure::Usage("--seconds takes 0 or more".to_owned()));
        }
        let mut silenced = known(&args.silence)?;
        let mut found = Vec::new();
        let panel = match &args.panel {
            None => Panel::default(),
            Some(path) => {
                let (panel, diagnostics) = saved::panel_from_json(&read(path)?);
                found.extend(diagnostics);
                panel
            }
        };
        let settings = args.set.iter().map(|text| Setting::read(text)).collect::<Option<Vec<_>>>();
        let Some(settings) = settings else {
            return Err(Failure::Usage("--set takes a variable and a number, for instance --set '#107=8'".to_owned()));
        };
        let meant = |parsed: &nc::Parsed| match args.start.as_deref() {
            None => Ok(None),
            Some(name) => run::program_meant(name, parsed)
                .map(Some)
                .ok_or_else(|| Failure::Usage(format!("--start takes a program, for instance O9101, not “{name}”"))),
        };
        let limits = Budget { blocks: args.blocks, seconds: args.seconds };
        let begin = |start: Option<interp::StartProgram>| RunOptions { start, settings: &settings, limits, keep };
        let Some(id) = &args.control else {
            let (mut project, diagnostics) = project(only_project(&args.files)?)?;
            found.extend(diagnostics);
            project.switches = switched(project.switches, &args.switch, project.control)?;
            settable(&settings, project.control, &Dialect::resolve(project.control, &project.switches))?;
            for event in panel.events() {
                project.panel.add(event.clone());
            }
            found.extend(project.design().diagnostics);
            let written = project.written();
            found.extend(written.diagnostics.iter().cloned());
            found.extend(project.advice(&written));
            Diagnostic::in_order(&mut found);
            silenced.extend(project.silenced.iter().cloned());
            let run = run::of_project(&project, &written, &begin(meant(&written.parsed)?));
            return Ok(Prepared { run, files: written.files.clone(), found, silenced });
        };
        let control = control(id)?;
        let plant = match &args.plant {
            None => None,
            Some(path) => {
                let (project, diagnostics) = project(path)?;
                found.extend(diagnostics);
                silenced.extend(project.silenced.iter().cloned());
                Some(project)
            }
        };
        let switches = plant.as_ref().map_or_else(Switches::default, |project| project.switches.clone());
        let switches = switched(switches, &args.switch, control)?;
        let parsed = Rc::new(nc::parse_with(&programs(&args.files)?, control, &switches));
        settable(&settings, control, parsed.dialect())?;
        let start = meant(&parsed)?;
        let first = parsed.deck().programs.first().map(|program| program.number);
        let started = match start {
            Some(interp::StartProgram::Program(number)) => Some(number),
            Some(interp::StartProgram::Nth(at)) => {
                parsed.deck().programs.get(at as usize).map(|program| program.number)
            }
            _ => first,
        };
        let set = run::set_by_operator(&settings, &panel, control);
        found.extend(review(&parsed, started, &set));
        let files = parsed.files().clone();
        let run = run::of_programs(parsed, plant.as_ref(), panel, &begin(start));
        Ok(Prepared { run, files, found, silenced })
    }

    fn run(args: &RunArgs, wanted: bool, json: bool) -> Result<(), Failure> {
        let Prepared { run: mut planner, files, found: mut diagnostics, silenced, .. } = prepare(args, Retention::Log)?;
        let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
        let mut canon: Vec<Json> = Vec::new();
        let mut text = String::new();
        let outcome = run::to_end(&mut planner, |line| {
            if !wanted {
                return Ok(());
            }
            text.clear();
            // A text takes whatever is written.
            let _ = line.write(&mut text);
            if json {
                canon.push(json!(text));
                return Ok(());
            }
            text.push('\n');
            out.write_all(text.as_bytes())
        })?;
        diagnostics.extend(outcome.diagnostics.iter().cloned());
        run::once_each(&mut diagnostics);
        let count = silence(&mut diagnostics, &silenced);
        if json {
            let teller = Teller::new(&files);
            let mut object = outcome.json();
            object["diagnostics"] = diagnostics.iter().map(|d| teller.json(d)).collect();
            if wanted {
                object["canon"] = Json::Array(canon);
            }
            writeln!(out, "{object:#}")?;
        }
        out.flush()?;
        if !json {
            tell(&files, &diagnostics);
            tell_silenced(count);
            eprintln!("{}", outcome.text());
        }
        verdict(&diagnostics)
    }

    /// Wrong commands are told and end, after all others, in exit status 2.
    fn step(args: &RunArgs) -> Result<(), Failure> {
        let Prepared { run, files, found: mut diagnostics, silenced } = prepare(args, Retention::Both)?;
        let count = silence(&mut diagnostics, &silenced);
        tell(&files, &diagnostics);
        tell_silenced(count);
        let terminal = io::stdin().is_terminal();
        let mut console = Console::new(run, &files);
        let mut out = io::stdout().lock();
        let mut wrong = 0;
        let mut last = String::new();
        out.write_all(console.place().as_bytes())?;
        for line in prompted(terminal) {
            let line = line?;
            // Return alone is the step before once more, for whoever sits at a terminal.
            let line = if terminal && line.trim().is_empty() { last } else { line };
            let (said, answer) = console.line(&line);
            out.write_all(answer.as_bytes())?;
            out.flush()?;
            match said {
                Outcome::Quit => break,
                Outcome::Wrong => wrong += 1,
                Outcome::Done => {}
            }
            last = line;
        }
        diagnostics.extend(console.diagnostics().iter().cloned());
        if wrong > 0 && !terminal {
            return Err(Failure::Usage(format!("{wrong} of the commands could not be carried out")));
        }
        verdict(&diagnostics)
    }

    /// The lines of standard input, each asked for where a person types them.
    fn prompted(terminal: bool) -> impl Iterator<Item = io::Result<String>> {
        let mut lines = io::stdin().lines();
        std::iter::from_fn(move || {
            if terminal {
                eprint!("> ");
            }
            lines.next()
        })
    }
}
