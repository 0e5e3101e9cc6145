//! From where a 3-D frame is seen, and how its numbers are written.

/// Direction from which the 3-D frames are seen (orthographic: the distance does not matter), and the reader's decimal sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Angle of the viewer about the vertical axis, from the first axis towards the second, radians; any finite number.
    pub azimuth: f64,
    /// Angle of the viewer above the horizontal plane, radians; kept within a quarter turn up and down.
    pub elevation: f64,
    /// The sign between the whole and the decimals of numbers along axes, a point or a comma.
    pub decimal: char,
}

impl Default for View {
    /// The first axis runs to the right, the second away from the reader: azimuth -60 degrees, elevation 24 degrees.
    fn default() -> Self {
        Self { azimuth: -std::f64::consts::FRAC_PI_3, elevation: 24.0_f64.to_radians(), decimal: '.' }
    }
}
