//! What the service worker keeps of a release: the files that the page needs, by the hashes of their contents.

use super::script;
use super::site::Site;
use crate::Failure;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;

/// The line of the service worker in whose place the list goes.
const EMPTY: &str = "const RELEASE = Object.freeze({});";

/// Paths that the page itself never asks for, or only while it has a network: files for other pages, still drawings,
/// the page in one file, declarations.
const NOT_KEPT: [&str; 10] = [
    "figures/",
    "gear-bifurcations.html",
    "figure.html",
    "embed.html",
    "gear-figure.js",
    "gear-host.js",
    "www/embed/frame.js",
    "package.json",
    "package/",
    "docs/examples/",
];

/// The service worker of this site.
pub fn service_worker(source: &str, site: &Site) -> Result<String, Failure> {
    if source.matches(EMPTY).count() != 1 {
        return Err(Failure::invalid(
            "the service worker",
            format!("`{EMPTY}` must stand in it exactly once"),
        ));
    }
    let mut list = String::from("const RELEASE = Object.freeze({\n");
    for (path, content) in site.files().filter(|(path, _)| is_kept(path)) {
        let _ = writeln!(list, "\"{path}\": \"{}\",", sha256(content));
    }
    list.push_str("});");
    Ok(script::bare(&source.replace(EMPTY, &list)))
}

fn is_kept(path: &str) -> bool {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    let wanted = ["html", "js", "wasm", "css", "woff2", "svg", "webmanifest"].contains(&ending);
    wanted && !NOT_KEPT.iter().any(|start| path.starts_with(start))
}

/// The SHA-256 of some bytes, in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::{EMPTY, service_worker, sha256};
    use crate::build::site::Site;

    #[test]
    fn the_service_worker_knows_the_files_of_its_release_and_no_others() {
        let mut site = Site::default();
        for name in [
            "index.html",
            "www/main.js",
            "figures/1.svg",
            "gear-bifurcations.d.ts",
            "figure.html",
            "www/style/icon-192.png",
        ] {
            site.add(name, "abc");
        }
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), abc);
        let text = service_worker(&format!("a();\n{EMPTY}\n"), &site).unwrap();
        assert_eq!(
            text,
            format!(
                "a();\nconst RELEASE = Object.freeze({{\n\"index.html\": \"{abc}\",\n\"www/main.js\": \"{abc}\",\n}});\n"
            )
        );
        assert!(service_worker("a();", &site).is_err());
    }
}
