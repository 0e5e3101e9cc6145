//! docs/equations.md against the source: every number from (1) to (113) is there, and every item it names exists.

use std::fs;
use std::path::Path;

const TABLE: &str = include_str!("../docs/equations.md");

/// First and last number of each range, such as `(62)-(64)`, in a table's first column.
fn numbers(cell: &str) -> Vec<(u32, u32)> {
    cell.split(',')
        .filter_map(|part| {
            let mut found = part.split(['(', ')']).filter_map(|piece| piece.trim().parse().ok());
            let first = found.next()?;
            Some((first, found.next().unwrap_or(first)))
        })
        .collect()
}

#[test]
fn every_number_of_the_paper_is_in_the_table() {
    let mut seen = [false; 114];
    for row in TABLE.lines().filter(|line| line.starts_with("| (")) {
        let cell = row.split('|').nth(1).expect("a first column");
        for (first, last) in numbers(cell) {
            for number in first..=last {
                seen[number as usize] = true;
            }
        }
    }
    let missing: Vec<usize> = (1..=113).filter(|number| !seen[*number]).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn every_item_in_the_table_exists() {
    let mut count = 0;
    for path in TABLE.split('`').filter(|text| text.starts_with("theory::") || text.starts_with("model::")) {
        count += 1;
        let parts: Vec<&str> = path.split("::").collect();
        let file =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(parts[0]).join(format!("{}.rs", parts[1]));
        let source = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{path}: {error}"));
        for item in &parts[2..] {
            let declared = [
                format!("pub fn {item}("),
                format!("pub fn {item}<"),
                format!("pub struct {item} "),
                format!("pub enum {item} "),
            ];
            assert!(declared.iter().any(|text| source.contains(text)), "{path} is not in {}", file.display());
        }
    }
    assert!(count > 80, "{count}");
}
