//! `cargo xtask test`: everything that must hold before a change lands, the quick things first.

mod count;

use crate::command::{Options, cargo, not_started, program, run, succeeded};
use crate::serve::{Prefix, Server};
use crate::{Failure, build, place, supply, tools};
use count::Count;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::ScopedJoinHandle;
use std::time::Instant;

/// The page must work from any path: the browser sees it under this one.
const SUB_PATH: &str = "/some/where/";

/// The step that needs the wasm, and all after it.
const BUILD: &str = "build, and the size of the wasm";

const WEBKIT: &str = "the whole journey in WebKit";

/// Runs the steps, stops at the first that fails, and ends with a line of counts.
pub fn check(options: &Options) -> Result<(), Failure> {
    let mut run = Run { count: Count::default(), only: options.value("--only").map(str::to_owned) };
    let quick = options.flag("--quick");
    // The wasm is optimised as a whole, by one core: the other has what needs no wasm meanwhile.
    let outcome = std::thread::scope(|scope| {
        let wasm = if run.wants(BUILD) {
            // Before two ask for it at once.
            tools::ensure_wasm_target()?;
            Some(scope.spawn(build::compile))
        } else {
            None
        };
        before_wasm(&mut run, quick)?;
        run.step(BUILD, |_| wasm.map_or(Ok(()), |thread| joined(BUILD, thread)?).and_then(|()| built()))?;
        with_wasm(&mut run, quick)
    });
    if let Err(failure) = &outcome {
        println!("stopped: {failure}");
        // A step that is no test, such as a lint: its failure is one all the same.
        run.count.failed = run.count.failed.max(1);
    }
    println!("{}", run.count);
    outcome.map_err(|_| Failure::Told)
}

/// What a thread came to that cannot have panicked but by a fault of its own.
fn joined<T>(step: &str, thread: ScopedJoinHandle<'_, T>) -> Result<T, Failure> {
    thread.join().map_err(|_| Failure::invalid(step, "the thread that does it panicked"))
}

/// Builds around the wasm that has been compiled.
fn built() -> Result<(), Failure> {
    let out = place::root().join("dist");
    build::make(&build::Wanted { out: &out, figures: &[], keep_wasm: true }).map(|built| built.report())
}

fn before_wasm(check: &mut Run, quick: bool) -> Result<(), Failure> {
    check.step("formatting", |_| run(&mut cargo(&["fmt", "--all", "--check"])))?;
    check.step("sources and terms of what is not ours", |_| supply::check())?;
    check.step("lints", |_| {
        run(&mut cargo(&["clippy", "--quiet", "--workspace", "--all-targets", "--", "-D", "warnings"]))
    })?;
    check.step("native tests and those in the docs", |count| {
        counted(&mut cargo(&["test", "--quiet", "--workspace", "--no-fail-fast"]), count::cargo, count)
    })?;
    if !quick {
        check.step("documentation", |_| {
            run(cargo(&["doc", "--quiet", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings"))
        })?;
        check.step("lints of the wasm side", |_| {
            tools::ensure_wasm_target()?;
            // What the compiler makes of macros for the wasm itself serves here too, and is there by now.
            let target = ["--release", "--target", "wasm32-unknown-unknown"];
            run(cargo(&["clippy", "--quiet", "--lib"]).args(target).args(["--", "-D", "warnings"]))
        })?;
    }
    Ok(())
}

fn with_wasm(check: &mut Run, quick: bool) -> Result<(), Failure> {
    check.step("npm packages", |_| tools::ensure_node_packages())?;
    check.step("types of the JavaScript", |_| {
        run(&mut program("npx", &["--no-install", "tsc", "--checkJs", "--strict", "--project", "."]))
    })?;
    check.step("tests in Node", |count| {
        let mut files = tests_in("tests/node")?;
        // What takes longest begins first, or one core would wait for it at the end.
        files.sort_by_key(|name| !name.ends_with("/fuzz.test.mjs"));
        // Node leaves a core free by itself, which of two is half.
        let mut node = program("node", &["--test", "--test-reporter=spec", "--test-concurrency=2"]);
        counted(node.args(&files), count::node, count)
    })?;
    if !quick {
        check.step("tests in Chromium", browser)?;
        journeys(check)?;
    }
    Ok(())
}

/// What has been counted so far, and which steps are wanted.
struct Run {
    count: Count,
    only: Option<String>,
}

impl Run {
    fn wants(&self, name: &str) -> bool {
        self.only.as_ref().is_none_or(|word| name.contains(word))
    }

    /// Runs one step, saying its name before and its time after.
    fn step(
        &mut self,
        name: &str,
        work: impl FnOnce(&mut Count) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        if !self.wants(name) {
            return Ok(());
        }
        println!("== {name}");
        let start = Instant::now();
        let outcome = work(&mut self.count);
        let verdict = if outcome.is_ok() { "done" } else { "FAILED" };
        println!("== {name}: {verdict} in {:.1} s\n", start.elapsed().as_secs_f64());
        outcome
    }
}

/// Runs a command, shows what it prints, and counts the tests in it.
fn counted(command: &mut Command, reader: fn(&str) -> Count, count: &mut Count) -> Result<(), Failure> {
    let (seen, outcome) = heard(command, reader, |line| print!("{line}"));
    *count += seen;
    outcome
}

/// Runs a command, hands on each line that it prints, and counts the tests in it.
fn heard(
    command: &mut Command,
    reader: fn(&str) -> Count,
    mut say: impl FnMut(&str),
) -> (Count, Result<(), Failure>) {
    let mut count = Count::default();
    let mut child = match command.stdout(Stdio::piped()).spawn() {
        Ok(child) => child,
        Err(source) => return (count, Err(not_started(command, &source))),
    };
    if let Some(output) = child.stdout.take() {
        let mut output = BufReader::new(output);
        let mut line = Vec::new();
        // Lines of bytes: a test may print what is no UTF-8, and must not stop us.
        while output.read_until(b'\n', &mut line).is_ok_and(|length| length > 0) {
            let text = String::from_utf8_lossy(&line);
            say(&text);
            count += reader(&text);
            line.clear();
        }
    }
    let outcome = child
        .wait()
        .map_err(|source| not_started(command, &source))
        .and_then(|status| succeeded(command, status));
    (count, outcome)
}

/// The test files below a folder. They are named one by one: Node's own search changed between versions.
fn tests_in(folder: &str) -> Result<Vec<String>, Failure> {
    let mut names = place::files_below(&place::root().join(folder))?;
    names.retain(|name| name.ends_with(".test.js") || name.ends_with(".test.mjs"));
    if names.is_empty() {
        return Err(Failure::invalid(folder, "there is no test in it"));
    }
    Ok(names.into_iter().map(|name| format!("{folder}/{name}")).collect())
}

fn browser(count: &mut Count) -> Result<(), Failure> {
    let chromium = tools::ensure_chromium()?;
    let prefix = Prefix::new(SUB_PATH).ok_or_else(|| Failure::invalid(SUB_PATH, "no plain path"))?;
    let address = Server::bind(place::root().join("dist"), prefix, Some(0))?.in_background();
    let mut playwright = program("npx", &["--no-install", "playwright", "test"]);
    counted(playwright.env("CHROMIUM", chromium).env("GEAR_ADDRESS", address), count::playwright, count)
}

/// `cargo xtask soak`: random use of the page for a long while.
pub fn soak(options: &Options) -> Result<(), Failure> {
    let dist = place::root().join("dist");
    build::build(&dist)?.report();
    tools::ensure_node_packages()?;
    let chromium = tools::ensure_chromium()?;
    let prefix = Prefix::new(SUB_PATH).ok_or_else(|| Failure::invalid(SUB_PATH, "no plain path"))?;
    let address = Server::bind(dist, prefix, Some(0))?.in_background();
    let mut playwright = program("npx", &["--no-install", "playwright", "test", "/soak.spec", "--workers=1"]);
    let minutes = options.value("--minutes").unwrap_or("30");
    run(playwright.env("CHROMIUM", chromium).env("GEAR_ADDRESS", address).env("SOAK_MINUTES", minutes))
}

/// The whole journey in three engines. A browser alone leaves half of the machine idle: the slowest goes beside the others.
fn journeys(check: &mut Run) -> Result<(), Failure> {
    let webkit = if check.wants(WEBKIT) { Some(tools::ensure_webkit()?) } else { None };
    std::thread::scope(|scope| {
        let aside = webkit.map(|program| {
            scope.spawn(move || {
                let mut said = String::new();
                let heard = heard(&mut journey("webkit", "WEBKIT_DRIVER", &program), count::node, |line| {
                    said.push_str(line);
                });
                (said, heard)
            })
        });
        check.step("the whole journey in Chromium", |count| {
            counted(&mut journey("chromium", "CHROMIUM", &tools::ensure_chromium()?), count::node, count)
        })?;
        check.step("the whole journey in Firefox", |count| {
            counted(&mut journey("firefox", "FIREFOX", &tools::ensure_firefox()?), count::node, count)
        })?;
        check.step(WEBKIT, |count| {
            let Some(aside) = aside else { return Ok(()) };
            let (said, (seen, outcome)) = joined(WEBKIT, aside)?;
            print!("{said}");
            *count += seen;
            outcome
        })
    })
}

/// The journey of `tests/engines` in one engine, whose program is named by a variable.
fn journey(engine: &str, variable: &str, program_path: &Path) -> Command {
    let mut node = program("node", &["--test", "--test-reporter=spec", "tests/engines/journey.test.mjs"]);
    node.env("ENGINE", engine).env(variable, program_path);
    node
}
