//! The project's own helper: builds the page, serves it, tests it, measures it.

mod bench;
mod build;
mod check;
mod command;
mod failure;
mod place;
mod release;
mod screens;
mod serve;
mod supply;
mod tools;

use failure::Failure;
use std::process::ExitCode;

const HELP: &str = "\
cargo xtask build [--out FOLDER]        make the static page and the module (default: dist/)
                  [--figure 11a,T]      ... and these figures as files of their own, gear-bifurcations-11a.html
                  [--keep-wasm]         ... around the wasm of the last build: quick, for work on the page alone
cargo xtask serve [--port N]            build, then serve dist/ on 127.0.0.1 (8080 or the next free port)
                  [--prefix /a/b/]      ... under this path, as a host with sub-folders would
                  [--no-build]          ... without building first
cargo xtask test  [--quick]             all checks and tests; quick: no wasm lints, no documentation, no browser
                  [--only WORD]         ... only the steps with this word in their name, such as Chromium or Node
cargo xtask fuzz  [--cases N]           100,000 made-up cases of every call of the module, in Node: hours
                  [--calls branch,...]  ... of these calls; also --seed N, --limit SECONDS, --small, --one NUMBER
cargo xtask bench                       measure natively, in Node, in the browsers; writes docs/benchmarks.md
                  [--numbers | --page | --openings]  ... only that part of it: the calls, the page, the single file in three engines
cargo xtask goldens                     draw the figures anew into tests/goldens/
cargo xtask accuracy                    every reference number beside ours, into docs/accuracy.md
cargo xtask numbers                     the native answers that every engine is held to, into tests/engines/numbers.json
cargo xtask dependencies                what is not ours, why and under which terms, into docs/dependencies.md
cargo xtask release [--out FOLDER]      site, single file, npm package, supplement and checksums of a clean tree (default: release/)
cargo xtask reproduce                   two builds from nothing, which must be the same to the bit
cargo xtask screens [--no-build]        pictures of the whole page into docs/screens/, of a new build or of dist/";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Told) => ExitCode::FAILURE,
        Err(failure) => {
            eprintln!("xtask: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), Failure> {
    let Some((task, rest)) = arguments.split_first() else {
        println!("{HELP}");
        return Ok(());
    };
    match task.as_str() {
        "build" => {
            let options = command::Options::read(rest, &["--out", "--figure"], &["--keep-wasm"])?;
            let out =
                options.value("--out").map_or_else(|| place::root().join("dist"), std::path::PathBuf::from);
            let figures: Vec<&str> =
                options.value("--figure").into_iter().flat_map(|ids| ids.split(',')).collect();
            let keep_wasm = options.flag("--keep-wasm");
            build::make(&build::Wanted { out: &out, figures: &figures, keep_wasm })
                .map(|built| built.report())
        }
        "serve" => {
            let options = command::Options::read(rest, &["--port", "--prefix"], &["--no-build"])?;
            serve::serve(&options)
        }
        "test" => check::check(&command::Options::read(rest, &["--only"], &["--quick"])?),
        "fuzz" => fuzz(rest),
        "soak" => check::soak(&command::Options::read(rest, &["--minutes"], &[])?),
        "bench" => command::Options::read(rest, &[], &["--numbers", "--page", "--openings"])
            .and_then(|options| bench::bench(&options)),
        "goldens" => {
            command::Options::read(rest, &[], &[])?;
            let test = ["test", "--quiet", "--test", "goldens"];
            command::run(command::cargo(&test).env("GOLDENS", "renew"))
        }
        "accuracy" => {
            command::Options::read(rest, &[], &[])?;
            let test = ["test", "--quiet", "--test", "accuracy"];
            command::run(command::cargo(&test).env("ACCURACY", "renew"))
        }
        "numbers" => {
            command::Options::read(rest, &[], &[])?;
            let test = ["test", "--quiet", "--test", "engines"];
            command::run(command::cargo(&test).env("ENGINES", "renew"))
        }
        "release" => {
            let options = command::Options::read(rest, &["--out"], &[])?;
            let out = options
                .value("--out")
                .map_or_else(|| place::root().join("release"), std::path::PathBuf::from);
            release::release(&out)
        }
        "reproduce" => command::Options::read(rest, &[], &[]).and_then(|_| release::reproduce()),
        "dependencies" => command::Options::read(rest, &[], &[]).and_then(|_| supply::renew()),
        "screens" => screens::screens(&command::Options::read(rest, &[], &["--no-build"])?),
        "help" | "--help" | "-h" => {
            println!("{HELP}");
            Ok(())
        }
        other => Err(Failure::Usage { given: other.to_owned(), help: HELP }),
    }
}

/// Hands everything on to the fuzz itself, which knows its options.
fn fuzz(rest: &[String]) -> Result<(), Failure> {
    build::build(&place::root().join("dist"))?.report();
    command::run(command::program("node", &["tests/node/fuzz/run.mjs"]).args(rest))
}
