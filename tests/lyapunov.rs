//! Lyapunov exponents of a published problem, by the numerics that the gears go through.

use gear_bifurcations::numerics::lyapunov::Framed;
use gear_bifurcations::numerics::ode::taylor::{Boundary, Options, Series, TaylorField};

/// Duffing's oscillator x'' + 0.2 x' - x + x^3 = 0.3 cos t with its variational equations: x, x', then the derivative of
/// both by the start, by rows.
struct Duffing;

impl TaylorField<6> for Duffing {
    type Piece = ();

    fn piece(&self, _time: f64, _state: &[f64; 6]) {}

    fn boundaries(&self, _piece: ()) -> [Option<Boundary>; 2] {
        [None, None]
    }

    fn series<const LEN: usize>(&self, _piece: (), time: f64, state: &[f64; 6], series: &mut Series<6, LEN>) {
        series[0] = *state;
        let mut square = [0.0; LEN];
        let (sine, cosine) = time.sin_cos();
        let (mut forcing, mut other) = (0.3 * cosine, -0.3 * sine);
        for n in 0..LEN - 1 {
            let row = series[n];
            square[n] = (0..=n).map(|j| series[j][0] * series[n - j][0]).sum();
            let products: [f64; 4] =
                std::array::from_fn(|column| (0..=n).map(|j| square[n - j] * series[j][column]).sum());
            let rate = 1.0 / (n + 1) as f64;
            let next = &mut series[n + 1];
            next[0] = row[1] * rate;
            next[1] = (-0.2 * row[1] + row[0] - products[0] + forcing) * rate;
            for column in 2..4 {
                next[column] = row[column + 2] * rate;
                next[column + 2] = (-0.2 * row[column + 2] + row[column] - 3.0 * products[column]) * rate;
            }
            (forcing, other) = (other * rate, -forcing * rate);
        }
    }
}

#[test]
fn the_exponents_of_duffings_oscillator_add_up_to_its_damping_and_the_largest_is_the_published_one() {
    let period = std::f64::consts::TAU;
    let options = Options { tolerance: 1e-12, ..Options::default() };
    let mut framed = Framed::<2, 6>::new(0.0, &[0.5, 0.1]);
    let (transient, periods) = (100, 30_000);
    let mut sums = [0.0; 2];
    for count in 0..transient + periods {
        framed.time = 0.0;
        let growth = framed.advance::<_, 17>(&Duffing, period, options, &mut |_| true).expect("integrates");
        if count >= transient {
            for (sum, growth) in sums.iter_mut().zip(growth) {
                *sum += growth / (period * f64::from(periods));
            }
        }
    }
    assert!((sums[0] + sums[1] + 0.2).abs() < 1e-9, "{sums:?}");
    assert!((sums[0] - 0.159).abs() < 2e-3, "{sums:?}");
}
