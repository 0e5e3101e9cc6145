//! The words by which marks and roles are known in JavaScript, both ways.

use crate::chart::drawing::{Mark, Role};

/// Every mark with its word.
const MARKS: [(Mark, &str); 7] = [
    (Mark::Curve, "curve"),
    (Mark::Filled, "filled"),
    (Mark::Cloud, "cloud"),
    (Mark::Marks, "marks"),
    (Mark::Band, "band"),
    (Mark::Text, "text"),
    (Mark::Field, "field"),
];

/// Every role with its word.
const ROLES: [(Role, &str); 29] = [
    (Role::Exact, "exact"),
    (Role::Paper, "paper"),
    (Role::Corrected, "corrected"),
    (Role::CorrectedSecond, "corrected-second"),
    (Role::Supercritical, "supercritical"),
    (Role::Subcritical, "subcritical"),
    (Role::Bifurcation, "bifurcation"),
    (Role::Saddle, "saddle"),
    (Role::UnstableSpiral, "unstable-spiral"),
    (Role::Attractor, "attractor"),
    (Role::Trajectory, "trajectory"),
    (Role::DeadZone, "dead-zone"),
    (Role::Reference, "reference"),
    (Role::OtherRegime, "other-regime"),
    (Role::Handle, "handle"),
    (Role::BodyFirst, "body-first"),
    (Role::BodySecond, "body-second"),
    (Role::Link, "link"),
    (Role::Event, "event"),
    (Role::IntervalStable, "interval-stable"),
    (Role::IntervalSaddle, "interval-saddle"),
    (Role::IntervalSpiral, "interval-spiral"),
    (Role::QuasiPeriodic, "quasi-periodic"),
    (Role::Fold, "fold"),
    (Role::TorusBifurcation, "torus-bifurcation"),
    (Role::AcrossManifold, "across-manifold"),
    (Role::Growth, "growth"),
    (Role::Basins, "basins"),
    (Role::Downward, "downward"),
];

/// The mark's word; empty for one that was forgotten in the table (the round trip of every figure is tested).
pub fn mark_word(mark: Mark) -> &'static str {
    MARKS.iter().find(|(known, _)| *known == mark).map_or("", |(_, word)| word)
}

/// The mark of that word.
pub fn mark(word: &str) -> Option<Mark> {
    MARKS.iter().find(|(_, known)| *known == word).map(|(mark, _)| *mark)
}

/// The role's word; empty for one that was forgotten in the table.
pub fn role_word(role: Role) -> &'static str {
    ROLES.iter().find(|(known, _)| *known == role).map_or("", |(_, word)| word)
}

/// The role of that word.
pub fn role(word: &str) -> Option<Role> {
    ROLES.iter().find(|(_, known)| *known == word).map(|(role, _)| *role)
}

/// The words of all marks, for an error.
pub fn mark_words() -> String {
    MARKS.map(|(_, word)| word).join(", ")
}

/// The words of all roles, for an error.
pub fn role_words() -> String {
    ROLES.map(|(_, word)| word).join(", ")
}
