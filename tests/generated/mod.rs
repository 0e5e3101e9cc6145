//! Numbers that look random and are the same every time, and polynomials with known roots.
#![allow(dead_code, reason = "each test file uses its part")]

/// The generator xorshift64* (S. Vigna, ACM Trans. Math. Softw. 42 (2016) 30).
#[derive(Clone)]
pub struct Generator(u64);

impl Generator {
    /// One sequence for each seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From 0 to `limit` - 1.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    /// `count` numbers between `low` and `high` in rising order, each at least `apart` from the next.
    pub fn parted(&mut self, count: usize, apart: f64, (low, high): (f64, f64)) -> Vec<f64> {
        loop {
            let mut numbers: Vec<f64> = (0..count).map(|_| low + (high - low) * self.unit()).collect();
            numbers.sort_by(f64::total_cmp);
            if numbers.windows(2).all(|pair| pair[1] - pair[0] >= apart) {
                return numbers;
            }
        }
    }
}

/// The polynomial in `s` whose roots in `s / length` are these real ones and these complex pairs (real part and
/// imaginary part), with leading coefficient 1 in `s / length`.
pub fn with_roots<const LEN: usize>(real: &[f64], pairs: &[(f64, f64)], length: f64) -> [f64; LEN] {
    let mut polynomial = [0.0; LEN];
    polynomial[0] = 1.0;
    let mut multiply = |factor: [f64; 3]| {
        for n in (0..LEN).rev() {
            let lower = |by: usize| if n >= by { polynomial[n - by] } else { 0.0 };
            polynomial[n] = factor[0] * lower(0) + factor[1] * lower(1) + factor[2] * lower(2);
        }
    };
    for root in real {
        multiply([-root, 1.0, 0.0]);
    }
    for (re, im) in pairs {
        multiply([re * re + im * im, -2.0 * re, 1.0]);
    }
    let mut power = 1.0;
    for coefficient in &mut polynomial {
        *coefficient /= power;
        power *= length;
    }
    polynomial
}
