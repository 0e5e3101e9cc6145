//! What a build was made from, as the page tells it: no time and no machine, so that the same sources give the same files.

use super::release::sha256;
use super::site::VERSION;
use crate::command::{output_of, program};
use crate::{Failure, place};

/// Version, commit and inputs.
pub struct Stamp {
    /// The commit, and whether files differ from it; "unknown" where there is no repository.
    pub commit: String,
    /// The compiler.
    pub compiler: String,
    /// The lock file and the wasm by the first digits of their hashes.
    pub lock: String,
    pub wasm: String,
}

impl Stamp {
    /// Asks git and the compiler.
    pub fn read(wasm: &[u8]) -> Result<Self, Failure> {
        let said = |name: &str, arguments: &[&str]| {
            output_of(&mut program(name, arguments)).map(|text| text.trim().to_owned())
        };
        let commit = match (said("git", &["rev-parse", "--short=12", "HEAD"]), changes()) {
            (Ok(commit), Ok(changes)) if changes.is_empty() => commit,
            (Ok(commit), _) => format!("{commit}-dirty"),
            _ => "unknown".to_owned(),
        };
        let lock = place::root().join("Cargo.lock");
        let lock = std::fs::read(&lock).map_err(Failure::file(&lock))?;
        let compiler = said("rustc", &["--version"])?;
        let compiler = compiler.split(" (").next().unwrap_or_default().to_owned();
        Ok(Self { commit, compiler, lock: short(&lock), wasm: short(wasm) })
    }

    /// Puts it into a document, in the place of what stands there in double braces.
    pub fn put_into(&self, document: &str) -> String {
        let values = [
            ("{{version}}", VERSION),
            ("{{commit}}", &self.commit),
            ("{{compiler}}", &self.compiler),
            ("{{lock}}", &self.lock),
            ("{{wasm}}", &self.wasm),
        ];
        values.iter().fold(document.to_owned(), |text, (name, value)| text.replace(name, value))
    }
}

/// The files that differ from the commit, as git lists them; files that it does not know count too.
pub fn changes() -> Result<String, Failure> {
    output_of(&mut program("git", &["status", "--porcelain"])).map(|text| text.trim().to_owned())
}

fn short(bytes: &[u8]) -> String {
    sha256(bytes)[..12].to_owned()
}
