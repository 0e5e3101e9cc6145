//! `cargo xtask screens`: pictures of the page, for the README and for whoever reviews a change to it.

use crate::command::{program, run};
use crate::serve::{Prefix, Server};
use crate::{Failure, build, place, tools};

/// Builds, serves, and has Chromium take the pictures.
pub fn screens() -> Result<(), Failure> {
    let dist = place::root().join("dist");
    build::build(&dist)?.report();
    tools::ensure_node_packages()?;
    let chromium = tools::ensure_chromium()?;
    let folder = place::root().join("docs/screens");
    std::fs::create_dir_all(&folder).map_err(Failure::file(&folder))?;
    let address = Server::bind(dist, Prefix::root(), Some(0))?.in_background();
    run(program("node", &["xtask/screens.js"]).env("CHROMIUM", chromium).env("GEAR_ADDRESS", address))
}
