//! Programs from elsewhere: found, brought where we may, and otherwise named.

use crate::command::{output_of, program, run};
use crate::{Failure, place};
use std::path::PathBuf;

const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// Where a program is on the search path.
pub fn find(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join(name)).find(|candidate| candidate.is_file())
}

/// Sees to it that the compiler can make wasm. Never touches the toolchain itself.
pub fn ensure_wasm_target() -> Result<(), Failure> {
    if find("rustup").is_none() {
        // A distribution's own compiler: it has the target if its library is there.
        let target =
            output_of(&mut program("rustc", &["--print", "target-libdir", "--target", WASM_TARGET]))?;
        if PathBuf::from(target.trim()).is_dir() {
            return Ok(());
        }
        return Err(Failure::Missing {
            tool: "the compiler's wasm32-unknown-unknown target",
            advice: "Install rustup (https://rustup.rs) and run `rustup target add wasm32-unknown-unknown`, \
                     or install your distribution's package of that target (Debian: libstd-rust-dev-wasm32).",
        });
    }
    let installed = output_of(&mut program("rustup", &["target", "list", "--installed"]))?;
    if installed.lines().any(|line| line.trim() == WASM_TARGET) {
        return Ok(());
    }
    println!("adding the target {WASM_TARGET}");
    run(&mut program("rustup", &["target", "add", WASM_TARGET]))
}

/// Where the release build for wasm lands.
pub fn wasm_artifact() -> PathBuf {
    place::target().join(WASM_TARGET).join("release").join("gear_bifurcations.wasm")
}

/// Oldest Node that runs the tests two at a time; the module runs in any 20.
const OLDEST_NODE: (u32, u32) = (20, 10);

/// Sees to it that Node and the npm packages of package-lock.json are there.
pub fn ensure_node_packages() -> Result<(), Failure> {
    let advice = "Install Node.js 20.10 or newer, npm with it (https://nodejs.org, or your distribution's nodejs and npm).";
    for tool in ["node", "npm"] {
        if find(tool).is_none() {
            return Err(Failure::Missing { tool, advice });
        }
    }
    let version = output_of(&mut program("node", &["--version"]))?;
    let mut numbers = version.trim().trim_start_matches('v').split('.').map(|part| part.parse::<u32>().ok());
    let found = numbers.next().flatten().zip(numbers.next().flatten());
    if found.is_none_or(|found| found < OLDEST_NODE) {
        return Err(Failure::Missing { tool: "a newer Node.js", advice });
    }
    if packages_are_current() {
        return Ok(());
    }
    run(&mut program("npm", &["ci", "--ignore-scripts", "--no-audit", "--no-fund"]))
}

/// Whether `node_modules` was installed after the lock file last changed.
fn packages_are_current() -> bool {
    let modified =
        |name: &str| std::fs::metadata(place::root().join(name)).and_then(|file| file.modified()).ok();
    match (modified("node_modules/.package-lock.json"), modified("package-lock.json")) {
        (Some(installed), Some(locked)) => installed >= locked,
        _ => false,
    }
}

/// Where Chromium is: the one named by the variable CHROMIUM, one on the search path, or Debian's, installed now.
pub fn ensure_chromium() -> Result<PathBuf, Failure> {
    if let Some(given) = std::env::var_os("CHROMIUM") {
        return Ok(PathBuf::from(given));
    }
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let present = || names.iter().find_map(|name| find(name));
    if let Some(chromium) = present() {
        return Ok(chromium);
    }
    let advice =
        "Install it (Debian, Ubuntu: `apt-get install chromium`), or name one in the variable CHROMIUM.";
    let missing = Failure::Missing { tool: "Chromium", advice };
    if !install("Chromium", &["chromium"])? {
        return Err(missing);
    }
    present().ok_or(missing)
}

/// Where Firefox is: the one named by the variable FIREFOX, one on the search path, or Debian's, installed now.
pub fn ensure_firefox() -> Result<PathBuf, Failure> {
    if let Some(given) = std::env::var_os("FIREFOX") {
        return Ok(PathBuf::from(given));
    }
    let present = || ["firefox-esr", "firefox"].iter().find_map(|name| find(name));
    if let Some(firefox) = present() {
        return Ok(firefox);
    }
    let advice = "Install it (Debian: `apt-get install firefox-esr`), or name one in the variable FIREFOX.";
    let missing = Failure::Missing { tool: "Firefox", advice };
    if !install("Firefox", &["firefox-esr"])? {
        return Err(missing);
    }
    present().ok_or(missing)
}

/// Where `WebKit`'s driver is: the one named by the variable `WEBKIT_DRIVER`, one on the search path, or Debian's, installed
/// now. It needs a screen: that of Xvfb comes with it.
pub fn ensure_webkit() -> Result<PathBuf, Failure> {
    let present = || {
        let driver =
            std::env::var_os("WEBKIT_DRIVER").map(PathBuf::from).or_else(|| find("WebKitWebDriver"))?;
        find("xvfb-run").and(find("xauth")).map(|_| driver)
    };
    if let Some(driver) = present() {
        return Ok(driver);
    }
    let advice = "Install it and a screen for it (Debian: `apt-get install webkit2gtk-driver xvfb xauth`); a driver of your own \
                  may be named in the variable WEBKIT_DRIVER, and its browser in MINI_BROWSER.";
    let missing = Failure::Missing { tool: "WebKitWebDriver with xvfb-run", advice };
    if !install("WebKit", &["webkit2gtk-driver", "xvfb", "xauth"])? {
        return Err(missing);
    }
    present().ok_or(missing)
}

/// Installs Debian packages where we may; `false` where we may not, or where there is no such system.
fn install(what: &str, packages: &[&str]) -> Result<bool, Failure> {
    let root = output_of(&mut program("id", &["-u"])).is_ok_and(|id| id.trim() == "0");
    if !root || find("apt-get").is_none() {
        return Ok(false);
    }
    println!("installing {what}");
    let quietly =
        |arguments: &[&str]| run(program("apt-get", arguments).env("DEBIAN_FRONTEND", "noninteractive"));
    quietly(&["update", "-q"])?;
    let mut arguments = vec!["install", "-q", "-y", "--no-install-recommends"];
    arguments.extend(packages);
    quietly(&arguments)?;
    Ok(true)
}
