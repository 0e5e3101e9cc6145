//! Running other programs, and reading our own command line.

use crate::Failure;
use std::process::{Command, ExitStatus};

/// A program with its arguments, to be run in the project's root.
pub fn program(name: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(name);
    command.args(arguments).current_dir(crate::place::root());
    command
}

/// Cargo, the one that runs us, so that a chosen toolchain stays chosen.
pub fn cargo(arguments: &[&str]) -> Command {
    let name = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    program(&name, arguments)
}

/// Runs a program whose output the reader sees as it comes.
pub fn run(command: &mut Command) -> Result<(), Failure> {
    let status = command.status().map_err(|source| not_started(command, &source))?;
    succeeded(command, status)
}

/// Runs a program and returns what it wrote to its standard output.
pub fn output_of(command: &mut Command) -> Result<String, Failure> {
    let output = command.output().map_err(|source| not_started(command, &source))?;
    succeeded(command, output.status)?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The failure of a program that ended badly.
pub fn succeeded(command: &Command, status: ExitStatus) -> Result<(), Failure> {
    if status.success() {
        Ok(())
    } else {
        Err(Failure::Command { command: line(command), status: status.to_string() })
    }
}

/// The failure of a program that could not be started at all.
pub fn not_started(command: &Command, source: &std::io::Error) -> Failure {
    Failure::Command { command: line(command), status: source.to_string() }
}

/// The command line as one would type it.
fn line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
}

/// The options of a task: `--name value`, `--name=value`, or a bare `--flag`.
#[derive(Debug)]
pub struct Options {
    values: Vec<(String, String)>,
    flags: Vec<String>,
}

impl Options {
    /// Reads the words after the task's name; a word that is neither in `valued` nor in `flags` is refused.
    pub fn read(words: &[String], valued: &[&str], flags: &[&str]) -> Result<Self, Failure> {
        let mut options = Self { values: Vec::new(), flags: Vec::new() };
        let mut words = words.iter();
        while let Some(word) = words.next() {
            let refuse = || Failure::Usage { given: word.clone(), help: crate::HELP };
            let (name, value) = match word.split_once('=') {
                Some((name, value)) => (name, Some(value.to_owned())),
                None => (word.as_str(), None),
            };
            if valued.contains(&name) {
                let value = value.or_else(|| words.next().cloned()).ok_or_else(refuse)?;
                options.values.push((name.to_owned(), value));
            } else if flags.contains(&name) && value.is_none() {
                options.flags.push(name.to_owned());
            } else {
                return Err(refuse());
            }
        }
        Ok(options)
    }

    /// The value given for an option; the last one counts.
    pub fn value(&self, name: &str) -> Option<&str> {
        self.values.iter().rev().find(|(given, _)| given == name).map(|(_, value)| value.as_str())
    }

    /// Whether a flag was given.
    pub fn flag(&self, name: &str) -> bool {
        self.flags.iter().any(|given| given == name)
    }
}

#[cfg(test)]
mod tests {
    use super::Options;

    fn read(words: &[&str]) -> Result<Options, crate::Failure> {
        let words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
        Options::read(&words, &["--port"], &["--quick"])
    }

    #[test]
    fn options_are_read_in_both_forms() {
        assert_eq!(read(&["--port", "90"]).unwrap().value("--port"), Some("90"));
        assert_eq!(read(&["--port=90", "--port=91"]).unwrap().value("--port"), Some("91"));
        assert!(read(&["--quick"]).unwrap().flag("--quick"));
        assert!(!read(&[]).unwrap().flag("--quick"));
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        for words in [&["--prot", "90"][..], &["--port"], &["--quick=yes"], &["90"]] {
            assert!(read(words).is_err(), "{words:?}");
        }
    }
}
