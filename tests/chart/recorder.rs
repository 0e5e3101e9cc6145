//! A surface that remembers what is drawn on it, series by series.

use std::convert::Infallible;

use gear_bifurcations::chart::Surface;
use gear_bifurcations::chart::surface::{Cloud, Image, Lettering};
use gear_bifurcations::chart::text::Run;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind};

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

/// One call of the backend, in CSS pixels.
#[derive(Clone, Debug, PartialEq)]
pub enum Call {
    Path { points: Vec<[f64; 2]>, width: f64, rgb: (u8, u8, u8) },
    Polygon { corners: Vec<[f64; 2]> },
    Rectangle { corners: [[f64; 2]; 2] },
    Circle { center: [f64; 2] },
    Image { columns: usize, pixels: Vec<u8>, corners: [[f64; 2]; 2] },
    Cloud { points: Vec<[f64; 2]>, diameter: f64 },
    Letters { runs: Vec<Run>, at: [f64; 2], upwards: bool },
}

pub struct Recorder {
    size: (f64, f64),
    units: i32,
    series: Option<String>,
    /// Every call, with the series it belongs to.
    pub calls: Vec<(Option<String>, Call)>,
}

impl Recorder {
    pub fn new(width: f64, height: f64, units: i32) -> Self {
        Self { size: (width, height), units, series: None, calls: Vec::new() }
    }

    fn pixel(&self, (x, y): BackendCoord) -> [f64; 2] {
        [f64::from(x) / f64::from(self.units), f64::from(y) / f64::from(self.units)]
    }

    fn note(&mut self, call: Call) {
        self.calls.push((self.series.clone(), call));
    }
}

impl DrawingBackend for Recorder {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let units = f64::from(self.units);
        ((self.size.0 * units) as u32, (self.size.1 * units) as u32)
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Outcome {
        panic!("nothing is drawn pixel by pixel");
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, _: &S, _: bool) -> Outcome {
        let corners = [self.pixel(a), self.pixel(b)];
        self.note(Call::Rectangle { corners });
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        let points = path.into_iter().map(|point| self.pixel(point)).collect();
        let width = f64::from(style.stroke_width()) / f64::from(self.units);
        self.note(Call::Path { points, width, rgb: style.color().rgb });
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, _: u32, _: &S, _: bool) -> Outcome {
        let center = self.pixel(center);
        self.note(Call::Circle { center });
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        _: &S,
    ) -> Outcome {
        let corners = path.into_iter().map(|point| self.pixel(point)).collect();
        self.note(Call::Polygon { corners });
        Ok(())
    }
}

impl Surface for Recorder {
    fn units_per_pixel(&self) -> i32 {
        self.units
    }

    fn lettering(&mut self, lettering: &Lettering<'_>) -> Outcome {
        let at = self.pixel(lettering.at);
        self.note(Call::Letters { runs: lettering.runs.to_vec(), at, upwards: lettering.upwards });
        Ok(())
    }

    fn cloud(&mut self, cloud: &Cloud<'_>) -> Outcome {
        let points = cloud.points.iter().map(|&point| self.pixel(point)).collect();
        self.note(Call::Cloud { points, diameter: f64::from(cloud.diameter) / f64::from(self.units) });
        Ok(())
    }

    fn image(&mut self, image: &Image<'_>, from: BackendCoord, to: BackendCoord) -> Outcome {
        let corners = [self.pixel(from), self.pixel(to)];
        self.note(Call::Image { columns: image.columns, pixels: image.pixels.to_vec(), corners });
        Ok(())
    }

    fn open(&mut self, name: &str, _: &str) {
        self.series = Some(name.to_owned());
    }

    fn close(&mut self) {
        self.series = None;
    }
}
