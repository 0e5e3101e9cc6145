//! What a task can fail with. Each message says what to do about it.

use std::fmt;
use std::path::{Path, PathBuf};

/// Why a task stopped.
#[derive(Debug)]
pub enum Failure {
    /// The command line asks for something that does not exist.
    Usage {
        /// The word that was not understood.
        given: String,
        /// What would be.
        help: &'static str,
    },
    /// A program that is needed is not there and cannot be brought.
    Missing {
        /// Its name.
        tool: &'static str,
        /// What the reader should do.
        advice: &'static str,
    },
    /// A program ended with an error of its own, which it has already told.
    Command {
        /// The command line.
        command: String,
        /// How it ended.
        status: String,
    },
    /// A file could not be read or written.
    File {
        /// Which.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Something that was built is not as it must be.
    Invalid {
        /// What it is.
        subject: String,
        /// What is wrong with it.
        reason: String,
    },
    /// Something that has already been told, where it belongs.
    Told,
}

impl Failure {
    /// A closure for `map_err` that remembers which file it was.
    pub fn file(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path, source }
    }

    /// Something that is not as it must be.
    pub fn invalid(subject: impl Into<String>, reason: impl Into<String>) -> Self {
        Self::Invalid { subject: subject.into(), reason: reason.into() }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage { given, help } => write!(f, "\"{given}\" is not understood. What there is:\n{help}"),
            Self::Missing { tool, advice } => write!(f, "{tool} is needed and was not found. {advice}"),
            Self::Command { command, status } => write!(f, "`{command}` failed ({status})"),
            Self::File { path, source } => write!(f, "{}: {source}", path.display()),
            Self::Told => write!(f, "it failed as told above"),
            Self::Invalid { subject, reason } => write!(f, "{subject}: {reason}"),
        }
    }
}

impl std::error::Error for Failure {}
