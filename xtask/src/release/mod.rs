//! `cargo xtask release`: everything that goes out, from a clean tree; and `cargo xtask reproduce`: two builds from nothing that must
//! be the same to the bit.

mod zip;

use crate::build::release::sha256;
use crate::build::stamp;
use crate::command::{output_of, program, run};
use crate::{Failure, build, place, tools};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

const SINGLE: &str = "gear-bifurcations.html";

/// Makes the site, the single file, the npm package, the supplement and the checksums in `out`.
pub fn release(out: &Path) -> Result<(), Failure> {
    // npm would take a relative path for the name of a package.
    let out = &std::path::absolute(out).map_err(Failure::file(out))?;
    let changes = stamp::changes()?;
    if !changes.is_empty() {
        return Err(Failure::invalid(
            "the tree",
            format!("a release is made from a commit, and this differs from it:\n{changes}"),
        ));
    }
    tools::ensure_node_packages()?;
    if out.exists() {
        if !out.join("SHA256SUMS").is_file() {
            return Err(Failure::invalid(
                out.display().to_string(),
                "it is there and no release of ours: choose another folder",
            ));
        }
        std::fs::remove_dir_all(out).map_err(Failure::file(out))?;
    }
    let site = out.join("site");
    build::build(&site)?.report();
    copy(&site.join(SINGLE), &out.join(SINGLE))?;
    let (package, target) = (site.join("package"), out.display().to_string());
    let package = package.display().to_string();
    run(&mut program(
        "npm",
        &["pack", &package, "--silent", "--ignore-scripts", "--pack-destination", &target],
    ))?;
    let supplement = out.join("supplement.zip");
    let content = zip::packed(&supplement_files(&site)?);
    std::fs::write(&supplement, content).map_err(Failure::file(&supplement))?;
    let sums = listed(&sums_of(out)?);
    let list = out.join("SHA256SUMS");
    std::fs::write(&list, &sums).map_err(Failure::file(&list))?;
    println!("released into {}:", out.display());
    for name in std::fs::read_dir(out).map_err(Failure::file(out))?.filter_map(Result::ok) {
        println!("  {}", name.file_name().to_string_lossy());
    }
    Ok(())
}

/// Builds twice from nothing, each time with a target folder of its own, and compares every file.
pub fn reproduce() -> Result<(), Failure> {
    let scratch = place::scratch().join("reproduce");
    if scratch.exists() {
        std::fs::remove_dir_all(&scratch).map_err(Failure::file(&scratch))?;
    }
    let mut sums = Vec::new();
    for number in ["first", "second"] {
        let (target, out) = (scratch.join(number).join("target"), scratch.join(number).join("dist"));
        let ourselves = std::env::current_exe().map_err(Failure::file(Path::new("xtask")))?;
        let mut command = Command::new(ourselves);
        command
            .args(["build", "--out"])
            .arg(&out)
            .env("CARGO_TARGET_DIR", &target)
            .current_dir(place::root());
        run(&mut command)?;
        sums.push(sums_of(&out)?);
    }
    let differing: Vec<&str> = sums[0]
        .iter()
        .filter(|(name, sum)| sums[1].get(*name) != Some(sum))
        .map(|(name, _)| name.as_str())
        .collect();
    if sums[0].len() != sums[1].len() || !differing.is_empty() {
        return Err(Failure::invalid(
            "two builds of the same sources",
            format!("they differ in {}", differing.join(", ")),
        ));
    }
    let together = sha256(listed(&sums[0]).as_bytes());
    println!("two builds from nothing are the same in all {} files; together: {together}", sums[0].len());
    Ok(())
}

/// What a journal is given: the single file, what it is, the drawings, the data, and how to cite it.
fn supplement_files(site: &Path) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let read = |path: PathBuf| std::fs::read(&path).map_err(Failure::file(&path));
    let mut files = vec![
        ("README.txt".to_owned(), README.as_bytes().to_vec()),
        (SINGLE.to_owned(), read(site.join(SINGLE))?),
        ("CITATION.cff".to_owned(), read(place::root().join("CITATION.cff"))?),
    ];
    for name in place::files_below(&site.join("figures"))? {
        files.push((format!("figures/{name}"), read(site.join("figures").join(&name))?));
    }
    let data = place::scratch().join("supplement");
    if data.exists() {
        std::fs::remove_dir_all(&data).map_err(Failure::file(&data))?;
    }
    std::fs::create_dir_all(&data).map_err(Failure::file(&data))?;
    let module = site.join("gear-bifurcations.js");
    output_of(program("node", &["xtask/data.js"]).arg(module).arg(&data))?;
    for name in place::files_below(&data)? {
        files.push((format!("data/{name}"), read(data.join(&name))?));
    }
    Ok(files)
}

const README: &str = "\
Pitchfork and Hopf bifurcations of a gear pair: interactive supplement

gear-bifurcations.html  The whole page. Save it, open it by a double click: it needs no network and asks for nothing.
                        Chromium 105, Firefox 113, Safari 16.4 or newer.
figures/                Each figure as a drawing (SVG).
data/                   Each figure's data as it is drawn (CSV). The first lines, after #, name the figure, its parameters,
                        the method and the estimates of the error. One row a point; a gap parts the pieces of a curve.
                        A field has a row for each pair of a column and a row; figure E ends with its table.
CITATION.cff            How to cite it.

The paper: doi:10.1007/s11071-021-07110-x. Licence: MIT or Apache-2.0.
";

/// The hash of every file below a folder, by its name.
fn sums_of(folder: &Path) -> Result<BTreeMap<String, String>, Failure> {
    let names = place::files_below(folder)?.into_iter();
    names
        .map(|name| {
            let path = folder.join(&name);
            let content = std::fs::read(&path).map_err(Failure::file(&path))?;
            Ok((name, sha256(&content)))
        })
        .collect()
}

/// As `sha256sum --check` reads it.
fn listed(sums: &BTreeMap<String, String>) -> String {
    sums.iter().flat_map(|(name, sum)| [sum.as_str(), "  ", name.as_str(), "\n"]).collect()
}

fn copy(from: &Path, to: &Path) -> Result<(), Failure> {
    std::fs::copy(from, to).map(|_| ()).map_err(Failure::file(to))
}
