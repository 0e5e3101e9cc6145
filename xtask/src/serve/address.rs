//! From what a browser asks for to a file, and never to one outside the folder.

use std::path::{Path, PathBuf};

/// The path under which the folder appears: begins and ends with a slash.
#[derive(Clone, Debug, PartialEq)]
pub struct Prefix(String);

impl Prefix {
    /// The root of the server.
    pub fn root() -> Self {
        Self("/".to_owned())
    }

    /// From what was typed; slashes at the ends may be left out. Plain names only, so that no decoding is needed.
    pub fn new(given: &str) -> Option<Self> {
        let inner = given.trim_matches('/');
        let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        let good = |part: &str| !part.is_empty() && !part.starts_with('.') && part.chars().all(plain);
        if inner.is_empty() {
            return Some(Self::root());
        }
        inner.split('/').all(good).then(|| Self(format!("/{inner}/")))
    }

    /// As it stands in an address.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// A folder and the path under which it appears.
pub struct Site {
    /// The folder on disk.
    pub folder: PathBuf,
    /// Its path in addresses.
    pub prefix: Prefix,
}

/// What an address stands for.
#[derive(Debug, PartialEq)]
pub enum Found {
    /// This file.
    File(PathBuf),
    /// Another address.
    Elsewhere(String),
    /// Nothing.
    Nothing,
    /// An address that no honest browser sends.
    Refused,
}

impl Site {
    /// Looks up the target of a request, e.g. `/www/main.js?x=1`.
    pub fn look_up(&self, target: &str) -> Found {
        let path = target.split(['?', '#']).next().unwrap_or_default();
        if !path.starts_with('/') {
            return Found::Refused;
        }
        let prefix = self.prefix.as_str();
        let Some(rest) = path.strip_prefix(prefix) else {
            // Only the doors lead inside: anything else not found shows an address that is not relative.
            let door = path == "/" || path == "/index.html" || format!("{path}/") == prefix;
            return if door { Found::Elsewhere(prefix.to_owned()) } else { Found::Nothing };
        };
        let Some(relative) = safe(rest) else {
            return Found::Refused;
        };
        let file = self.folder.join(&relative);
        if file.is_dir() {
            if !path.ends_with('/') {
                return Found::Elsewhere(format!("{path}/"));
            }
            return self.inside(&file.join("index.html"));
        }
        self.inside(&file)
    }

    /// The file, if it is there and no link leads out of the folder.
    fn inside(&self, file: &Path) -> Found {
        let (Ok(file), Ok(folder)) = (file.canonicalize(), self.folder.canonicalize()) else {
            return Found::Nothing;
        };
        if !file.starts_with(&folder) {
            return Found::Refused;
        }
        if file.is_file() { Found::File(file) } else { Found::Nothing }
    }
}

/// A path below the folder, or none if the address has parts that are hidden, lead upwards or are no plain names.
fn safe(path: &str) -> Option<PathBuf> {
    let mut safe = PathBuf::new();
    for part in path.split('/').filter(|part| !part.is_empty()) {
        let part = decoded(part)?;
        if part.starts_with('.') || part.contains(['/', '\\', ':', '\0']) {
            return None;
        }
        safe.push(part);
    }
    Some(safe)
}

/// A part of an address with its %xx replaced.
fn decoded(part: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(part.len());
    let mut rest = part.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let digit = |byte: Option<u8>| byte.and_then(|byte| char::from(byte).to_digit(16));
            let value = digit(rest.next())? * 16 + digit(rest.next())?;
            bytes.push(u8::try_from(value).ok()?);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

/// The media type a browser insists on, by the file's ending.
pub fn media_type(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()).unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "webp" => "image/webp",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "ts" | "txt" | "md" | "csv" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::{Found, Prefix, Site, media_type};
    use std::path::{Path, PathBuf};

    /// A folder with a page, a script, a name with a blank, a folder, and a secret beside it.
    fn site(name: &str, prefix: &str) -> (Site, PathBuf) {
        let around = std::env::temp_dir().join(format!("gear-serve-{}-{name}", std::process::id()));
        let folder = around.join("dist");
        std::fs::create_dir_all(folder.join("www")).unwrap();
        for file in ["index.html", "www/main.js", "www/a b.svg", ".hidden", "../secret.txt"] {
            std::fs::write(folder.join(file), file).unwrap();
        }
        let around = around.canonicalize().unwrap();
        (Site { folder, prefix: Prefix::new(prefix).unwrap() }, around)
    }

    #[test]
    fn files_are_found_and_queries_ignored() {
        let (site, around) = site("found", "/");
        let file = |name: &str| Found::File(around.join("dist").join(name));
        assert_eq!(site.look_up("/"), file("index.html"));
        assert_eq!(site.look_up("/index.html?x=1#y"), file("index.html"));
        assert_eq!(site.look_up("/www/main.js"), file("www/main.js"));
        assert_eq!(site.look_up("//www//main.js"), file("www/main.js"));
        assert_eq!(site.look_up("/www/a%20b.svg"), file("www/a b.svg"));
        assert_eq!(site.look_up("/www"), Found::Elsewhere("/www/".to_owned()));
        assert_eq!(site.look_up("/www/"), Found::Nothing);
        assert_eq!(site.look_up("/none.js"), Found::Nothing);
        std::fs::remove_dir_all(around).unwrap();
    }

    #[test]
    fn nothing_outside_the_folder_is_reached() {
        let (site, around) = site("outside", "/");
        for target in [
            "/../secret.txt",
            "/www/../../secret.txt",
            "/%2e%2e/secret.txt",
            "/..%2fsecret.txt",
            "/www/..%5c..%5csecret.txt",
            "/.hidden",
            "/%00",
            "/%zz",
            "/%2",
            "/%ff",
            "/C:/secret.txt",
            "secret.txt",
            "http://127.0.0.1/index.html",
            "",
        ] {
            assert_eq!(site.look_up(target), Found::Refused, "{target}");
        }
        std::fs::remove_dir_all(around).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_leads_out_is_refused() {
        let (site, around) = site("link", "/");
        std::os::unix::fs::symlink(around.join("secret.txt"), around.join("dist/link.txt")).unwrap();
        assert_eq!(site.look_up("/link.txt"), Found::Refused);
        std::fs::remove_dir_all(around).unwrap();
    }

    #[test]
    fn under_a_prefix_only_the_doors_lead_inside() {
        let (site, around) = site("prefix", "some/where");
        let inside = Found::Elsewhere("/some/where/".to_owned());
        assert_eq!(site.look_up("/some/where/www/main.js"), Found::File(around.join("dist/www/main.js")));
        assert_eq!(site.look_up("/some/where"), inside);
        assert_eq!(site.look_up("/"), inside);
        assert_eq!(site.look_up("/index.html"), inside);
        assert_eq!(site.look_up("/www/main.js"), Found::Nothing);
        assert_eq!(site.look_up("/some/whereabouts"), Found::Nothing);
        std::fs::remove_dir_all(around).unwrap();
    }

    #[test]
    fn prefixes_are_plain_names() {
        assert_eq!(Prefix::new("a/b").unwrap().as_str(), "/a/b/");
        assert_eq!(Prefix::new("/").unwrap().as_str(), "/");
        for bad in ["a//b", "/a/../b/", "a b", "a?b"] {
            assert_eq!(Prefix::new(bad), None, "{bad}");
        }
    }

    #[test]
    fn media_types_are_those_browsers_insist_on() {
        for (name, kind) in [
            ("a.wasm", "application/wasm"),
            ("a.b.js", "text/javascript; charset=utf-8"),
            ("a.svg", "image/svg+xml"),
            ("a.woff2", "font/woff2"),
            ("LICENSE", "application/octet-stream"),
        ] {
            assert_eq!(media_type(Path::new(name)), kind);
        }
    }
}
