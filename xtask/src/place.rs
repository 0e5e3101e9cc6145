//! Where things are.

use std::path::{Path, PathBuf};

/// The project's root: where the workspace's Cargo.toml is.
pub fn root() -> PathBuf {
    // Cargo tells where the package lies at run time; the path it was compiled at may have moved since.
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let package = PathBuf::from(package);
    package.parent().map_or_else(|| package.clone(), Path::to_path_buf)
}

/// Cargo's folder for what it builds.
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |given| root().join(given))
}

/// The folder under `target` in which the tasks keep what lies between a source and `dist/`.
pub fn scratch() -> PathBuf {
    target().join("xtask")
}

/// Every file below `folder`, as paths relative to it with `/` between the parts, in order of name.
pub fn files_below(folder: &Path) -> Result<Vec<String>, crate::Failure> {
    fn visit(folder: &Path, prefix: &str, found: &mut Vec<String>) -> Result<(), crate::Failure> {
        for entry in std::fs::read_dir(folder).map_err(crate::Failure::file(folder))? {
            let entry = entry.map_err(crate::Failure::file(folder))?;
            let path = entry.path();
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if path.is_dir() {
                visit(&path, &format!("{name}/"), found)?;
            } else {
                found.push(name);
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    if folder.is_dir() {
        visit(folder, "", &mut found)?;
    }
    found.sort();
    Ok(found)
}
