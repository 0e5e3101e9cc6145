//! `cargo xtask bench`: how fast the same jobs are natively, in Node and in Chromium; how the page opens and answers.

use crate::command::{Options, cargo, output_of, program};
use crate::serve::{Prefix, Server};
use crate::{Failure, build, place, tools};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Lines of a measurement: what, and how long, in microseconds.
type Measured = Vec<(String, f64)>;

/// The job of which the first call in a fresh engine counts too, and the most that it may take, in microseconds.
const FIRST: (&str, f64) = ("stability chart 200 x 200 to 1e-6", 25e3);
const FIRST_CALLS: usize = 5;

/// The document, and its parts, each of which can be renewed alone.
const DOCUMENT: &str = "docs/benchmarks.md";
const NUMBERS: &str = "Numbers";
const PAGE: &str = "The page";
const OPENINGS: &str = "The single file";

/// Measures, prints and records in docs/benchmarks.md: the numbers, the page, the single file in three engines, or all.
pub fn bench(options: &Options) -> Result<(), Failure> {
    // As it was found: what is measured here keeps it busy itself.
    let machine = machine();
    let dist = place::root().join("dist");
    let built = build::build(&dist)?;
    built.report();
    tools::ensure_node_packages()?;
    let chromium = tools::ensure_chromium()?;
    let address = Server::bind(dist.clone(), Prefix::root(), Some(0))?.in_background();
    let browser = |script: &str| {
        let mut command = program("node", &[script]);
        command.env("CHROMIUM", &chromium).env("GEAR_ADDRESS", &address).env("GEAR_DIST", &dist);
        command
    };
    let [numbers, page, openings] = ["--numbers", "--page", "--openings"].map(|part| options.flag(part));
    let all = !(numbers || page || openings);
    if numbers || all {
        record(NUMBERS, &numbers_measured(&machine, &chromium, browser("benches/browser.js"))?)?;
    }
    if page || all {
        println!("the page in Chromium");
        let mut lines = output_of(&mut browser("benches/page.js"))?;
        lines.push_str(&output_of(
            program("node", &["benches/lighthouse.js"]).env("CHROMIUM", &chromium).env("GEAR_DIST", &dist),
        )?);
        let versions = [output_of(&mut program(&chromium.to_string_lossy(), &["--version"]))?];
        record(
            PAGE,
            &page_report(&machine, &versions, &lines, [built.gzipped, built.first_visit, built.single])?,
        )?;
    }
    if openings || all {
        record(OPENINGS, &openings_report(&machine, &openings_measured(chromium)?))?;
    }
    Ok(())
}

/// From opening the single file to its first figure, in each engine.
fn openings_measured(chromium: PathBuf) -> Result<Measured, Failure> {
    let engines = [
        ("chromium", "CHROMIUM", chromium),
        ("firefox", "FIREFOX", tools::ensure_firefox()?),
        ("webkit", "WEBKIT_DRIVER", tools::ensure_webkit()?),
    ];
    let mut measured = Measured::new();
    for (engine, variable, path) in engines {
        println!("the single file in {engine}");
        let mut node = program("node", &["benches/openings.js"]);
        measured.extend(read(&output_of(node.env("ENGINE", engine).env(variable, path))?)?);
    }
    Ok(measured)
}

/// How soon the single file shows a figure, as a part of the document.
fn openings_report(machine: &str, measured: &Measured) -> String {
    let mut text = format!(
        "Opened from the disk, 1440 by 900 CSS pixels, until its first figure is drawn, and until a \
         picture of it, still or live, stands there; by `benches/openings.js`. The aim is 300 ms.\n\n\
         Machine: {machine}.\n\n| in | time |\n|---|---:|\n"
    );
    for (browser, time) in measured {
        let _ = writeln!(text, "| {browser} | {} |", microseconds(*time));
    }
    text
}

/// Prints a part of the document and puts it there.
fn record(heading: &str, text: &str) -> Result<(), Failure> {
    print!("\n{text}");
    let path = place::root().join(DOCUMENT);
    let document = std::fs::read_to_string(&path).map_err(Failure::file(&path))?;
    std::fs::write(&path, renewed(&document, heading, text)).map_err(Failure::file(&path))
}

/// The document with another text under one of its headings; where there is no such heading, with one more.
fn renewed(document: &str, heading: &str, text: &str) -> String {
    let start = format!("\n## {heading}\n");
    let (before, after) = match document.split_once(&start) {
        Some((before, rest)) => (before, rest.find("\n## ").map_or("", |next| &rest[next..])),
        None => (document.trim_end_matches('\n'), ""),
    };
    let before = before.trim_end_matches('\n');
    format!("{before}\n{start}\n{}\n{after}", text.trim_matches('\n'))
}

/// The jobs natively, in Node and in Chromium, as a part of the document.
fn numbers_measured(machine: &str, chromium: &Path, mut browser: Command) -> Result<String, Failure> {
    println!("natively");
    let native = output_of(&mut cargo(&["bench", "--quiet", "--bench", "speed"]))?;
    let ceilings = ceilings(&native)?;
    let native = read(&native)?;
    let jobs: Vec<&str> = native.iter().map(|(job, _)| job.as_str()).collect();
    println!("in Node");
    let mut firsts = Vec::with_capacity(FIRST_CALLS);
    for _ in 0..FIRST_CALLS {
        firsts.extend(read(&output_of(program("node", &["benches/node.js", "--first"]).arg(FIRST.0))?)?);
    }
    firsts.sort_by(|one, other| one.1.total_cmp(&other.1));
    let node = read(&output_of(program("node", &["benches/node.js"]).args(&jobs))?)?;
    println!("in Chromium");
    let mut in_chromium = read(&output_of(browser.args(["--first", FIRST.0]).args(&jobs))?)?;
    let in_chromium_first = if in_chromium.is_empty() { f64::NAN } else { in_chromium.remove(0).1 };

    let versions = [
        output_of(&mut program("rustc", &["--version"]))?,
        format!("Node {}", output_of(&mut program("node", &["--version"]))?),
        output_of(&mut program(&chromium.to_string_lossy(), &["--version"]))?,
    ];
    let measurements = Measurements {
        jobs: [native, node, in_chromium],
        ceilings,
        first: [firsts[FIRST_CALLS / 2].1, in_chromium_first],
    };
    Ok(report(machine, &versions, &measurements))
}

/// All that is measured.
struct Measurements {
    /// The same jobs natively, in Node and in Chromium; a job of ours is followed by its baseline if it has one.
    jobs: [Measured; 3],
    /// The most that each may take in Chromium.
    ceilings: Vec<Option<f64>>,
    /// The first call of [`FIRST`] in Node and in Chromium.
    first: [f64; 2],
}

/// Reads lines of a name, a number and perhaps more, with tabs between.
fn read(text: &str) -> Result<Measured, Failure> {
    let parse = |line: &str| {
        let mut parts = line.split('\t');
        Some((parts.next()?.to_owned(), parts.next()?.trim().parse().ok()?))
    };
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    lines.map(|line| parse(line).ok_or_else(|| Failure::invalid("a measurement", line))).collect()
}

/// Reads the third part of such lines, where there is one.
fn ceilings(text: &str) -> Result<Vec<Option<f64>>, Failure> {
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let third = lines.map(|line| line.split('\t').nth(2).map(|part| (line, part.trim())));
    let parse = |(line, part): (&str, &str)| part.parse().map_err(|_| Failure::invalid("a ceiling", line));
    third.map(|found| found.map(parse).transpose()).collect()
}

/// The processor's name and the number of its cores that we may use.
fn machine() -> String {
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or("an unnamed processor", |(_, name)| name.trim());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {cores} cores, {}{}", std::env::consts::OS, load())
}

/// How many programs wanted the processor in the last minute, where the system says so: figures of a busy machine must be told
/// from those of a quiet one.
fn load() -> String {
    let said = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    said.split_whitespace().next().map_or_else(String::new, |load| format!(", load {load}"))
}

/// How a baseline's name begins.
const BASELINE: &str = "plain RK4";

/// Of a job named "..., 5 of 100" or "..., 4 of 200 points" the part that is done, as a divisor: 20, 50; of others 1.
fn whole_of(job: &str) -> f64 {
    let part = job.rsplit_once(", ").map_or("", |(_, part)| part);
    let mut words = part.split_whitespace();
    let numbers = (words.next(), words.next(), words.next());
    let (Some(done), Some("of"), Some(all)) = numbers else { return 1.0 };
    match (done.parse::<f64>(), all.parse::<f64>()) {
        (Ok(done), Ok(all)) if done > 0.0 => all / done,
        _ => 1.0,
    }
}

/// What the page was measured to do, as a part of the document.
fn page_report(
    machine: &str,
    versions: &[String],
    lines: &str,
    sizes: [usize; 3],
) -> Result<String, Failure> {
    let mut text = String::from(
        "Measured by `benches/page.js`: 1440 by 900 CSS pixels, without a graphics processor, served from the same machine; by\n\
         `benches/lighthouse.js`: as for a desktop, five times, compressed as hosts do it. The aims hold for a machine of two cores that\n\
         does nothing else; a load that is not small says that it did.\n\n",
    );
    let versions: Vec<&str> = versions.iter().map(|version| version.trim()).collect();
    let _ = writeln!(text, "Machine: {machine}. {}.\n", versions.join(", "));
    text.push_str("| what | measured | aim |\n|---|---:|---:|\n");
    for line in lines.lines().filter(|line| !line.trim().is_empty()) {
        let parts: Vec<&str> = line.split('\t').collect();
        let [what, found, aim] = parts[..] else {
            return Err(Failure::invalid("a measurement of the page", line));
        };
        let aim = if aim.is_empty() { "-" } else { aim };
        let _ = writeln!(text, "| {what} | {found} | {aim} |");
    }
    let [gzipped, first_visit, single] = sizes;
    let ceilings = [build::WASM_CEILING, build::FIRST_VISIT_CEILING, build::SINGLE_CEILING];
    let _ = writeln!(
        text,
        "\nThe wasm, gzipped: {gzipped} bytes; the build fails above {}. Everything that a first visit loads, gzipped: \
         {first_visit} bytes; the build fails above {}. The page in one file: {single} bytes, at most {}.",
        ceilings[0], ceilings[1], ceilings[2]
    );
    Ok(text)
}

/// The numbers, as a part of the document.
fn report(machine: &str, versions: &[String], measured: &Measurements) -> String {
    let mut text = String::from(
        "The jobs are those of `src/study/benchmark.rs`, each the median of 15 samples (of 3 where\n\
         one takes longer than 0.3 s), in one thread, warm. \"Plain RK4\" is the baseline in the same run: the classical Runge-Kutta method, scalar,\n\
         with a fixed step fine enough for the same error (a test there says so), compiled by the same compiler. Where it would take seconds it\n\
         does a part of the job, and its time is multiplied. The ceilings are for one worker in Chromium on a machine of two cores.\n\n",
    );
    let versions: Vec<&str> = versions.iter().map(|version| version.trim()).collect();
    let _ = writeln!(text, "Machine: {machine}. {}.\n", versions.join(", "));
    let heads = ["native", "in Node", "in Chromium"];
    let _ = writeln!(
        text,
        "| job | {} | ceiling |\n|---|---:|---:|---:|---:|---:|---:|---:|",
        heads.map(|head| format!("{head} | x RK4")).join(" | ")
    );
    let names: Vec<&str> = measured.jobs[0].iter().map(|(name, _)| name.as_str()).collect();
    for (index, name) in names.iter().enumerate().filter(|(_, name)| !name.starts_with(BASELINE)) {
        let baseline = names.get(index + 1).filter(|name| name.starts_with(BASELINE));
        let _ = write!(text, "| {name} |");
        for row in &measured.jobs {
            let time = row.get(index).map(|(_, time)| *time);
            let shown = time.map_or("?".to_owned(), microseconds);
            let plain = baseline.zip(row.get(index + 1)).map(|(name, (_, plain))| plain * whole_of(name));
            let times = plain.zip(time).map_or("-".to_owned(), |(plain, time)| ratio(plain / time));
            let _ = write!(text, " {shown} | {times} |");
        }
        let ceiling = measured.ceilings.get(index).copied().flatten();
        let _ = writeln!(text, " {} |", ceiling.map_or("-".to_owned(), microseconds));
    }
    let [node, chromium] = measured.first.map(microseconds);
    let _ = writeln!(
        text,
        "| {}, first call | - | - | {node} | - | {chromium} | - | {} |",
        FIRST.0,
        microseconds(FIRST.1)
    );
    text
}

/// How many times faster, with two digits at least.
fn ratio(times: f64) -> String {
    format!("{times:.*}", usize::from(times < 10.0))
}

/// A duration with three digits and the unit that suits it.
fn microseconds(time: f64) -> String {
    let (value, unit) = if time < 1e3 {
        (time, "µs")
    } else if time < 1e6 {
        (time / 1e3, "ms")
    } else {
        (time / 1e6, "s")
    };
    let decimals = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.decimals$} {unit}")
}

#[cfg(test)]
mod tests {
    use super::{
        Measurements, ceilings, microseconds, openings_report, page_report, read, renewed, report, whole_of,
    };

    #[test]
    fn measurements_are_read_and_rubbish_is_not() {
        assert_eq!(
            read("a job\t1.5\n\nanother\t20\n").unwrap(),
            [("a job".to_owned(), 1.5), ("another".to_owned(), 20.0)]
        );
        assert!(read("a job 1.5\n").is_err());
        assert_eq!(ceilings("a\t1.5\t2e3\nb\t1\n").unwrap(), [Some(2000.0), None]);
        assert!(ceilings("a\t1.5\tsoon\n").is_err());
    }

    #[test]
    fn the_single_file_has_a_row_for_each_engine() {
        let text = openings_report("box", &vec![("Hare 3, just started".to_owned(), 310_000.0)]);
        assert!(text.ends_with("| in | time |\n|---|---:|\n| Hare 3, just started | 310 ms |\n"), "{text}");
    }

    #[test]
    fn durations_have_three_digits() {
        let shown: Vec<String> = [0.1234, 12.34, 123.4, 1234.0, 1.5e6].map(microseconds).to_vec();
        assert_eq!(shown, ["0.12 µs", "12.3 µs", "123 µs", "1.23 ms", "1.50 s"]);
    }

    #[test]
    fn the_report_sets_each_job_against_its_baseline() {
        let row = |ours, plain| {
            let names = ["a", "plain RK4: a, 5 of 100 points", "b"];
            names.map(str::to_owned).into_iter().zip([ours, plain, 7.0]).collect::<Vec<_>>()
        };
        let measured = Measurements {
            jobs: [row(2.0, 20.0), row(3.0, 33.0), row(4.0, 1.0)],
            ceilings: vec![Some(5.0), None, None],
            first: [8.0, 9.0],
        };
        let text = report("box", &["v".to_owned()], &measured);
        assert!(text.contains("| a | 2.00 µs | 200 | 3.00 µs | 220 | 4.00 µs | 5.0 | 5.00 µs |\n"), "{text}");
        assert!(text.contains("| b | 7.00 µs | - | 7.00 µs | - | 7.00 µs | - | - |\n"), "{text}");
        assert!(text.contains("first call | - | - | 8.00 µs | - | 9.00 µs | - | 25.0 ms |\n"), "{text}");
    }

    #[test]
    fn a_part_of_the_document_is_renewed_and_the_others_stay() {
        let document = "# B\n\nIntro.\n\n## Numbers\n\nold\n\n## The page\n\nkept\n";
        let now = renewed(document, "Numbers", "new\n");
        assert_eq!(now, "# B\n\nIntro.\n\n## Numbers\n\nnew\n\n## The page\n\nkept\n");
        assert_eq!(
            renewed(&now, "The page", "p"),
            "# B\n\nIntro.\n\n## Numbers\n\nnew\n\n## The page\n\np\n"
        );
        assert_eq!(renewed("# B\n", "Numbers", "n"), "# B\n\n## Numbers\n\nn\n");
    }

    #[test]
    fn what_the_page_does_stands_beside_what_it_should() {
        let text = page_report("box", &["v".to_owned()], "a\t1 ms\t2 ms\nb\t3\t\n", [7, 11, 13]).unwrap();
        assert!(text.contains("| a | 1 ms | 2 ms |\n| b | 3 | - |\n"), "{text}");
        assert!(page_report("box", &[], "a\t1\n", [1, 2, 3]).is_err());
    }

    #[test]
    fn the_part_that_a_baseline_does_is_read_off_its_name() {
        assert!((whole_of("plain RK4: 100 periods to 1e-10, 5 of 100") - 20.0).abs() < 1e-12);
        assert!((whole_of("plain RK4: a chart, 100 of 40000 points") - 400.0).abs() < 1e-12);
        assert!((whole_of("monodromy to 1e-10") - 1.0).abs() < 1e-12);
    }
}
