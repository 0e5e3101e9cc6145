//! The linear problem about the unloaded state, in symmetric coordinates, where half a period is enough.
//!
//! With the pure torsion `q = u - u_p + u_g`, `x = (sqrt(m_p) u_p, sqrt(m_g) u_g, q)` and
//! `b = (1/sqrt(m_p), -1/sqrt(m_g), 1)`, so that `u = b.x`, the linear part of (22) is
//!
//! ```text
//! x'' + C x' + K(t) x = 0,   C = diag(2 zeta_p/m_p, 2 zeta_g/m_g, 0) + 2 zeta b b^T,
//!                            K = diag(k_p/m_p, k_g/m_g, 0) + (1 + k0 cos Omega t) b b^T.
//! ```
//!
//! Both matrices are symmetric and the forcing is of rank one. With S = [[C, I], [I, 0]] the system's matrix obeys
//! A(t)^T = S A(t) S^-1, and the stiffness is even about T/2; hence the monodromy is M = S^-1 P^T S P with
//! P = Phi(T/2), for any damping and any supports.

use crate::model::equations::add_cosine;
use crate::model::parameters::Parameters;
use crate::numerics::ode::taylor::{Boundary, Series, TaylorField};

/// Six columns of six coordinates `(x, x')`, row after row.
pub const SIZE: usize = 36;

/// A 6 x 6 matrix by rows.
pub type Rows = [[f64; 6]; 6];

/// The linear problem in symmetric coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearPair {
    coupling: [f64; 3],
    support_damping: [f64; 3],
    support_stiffness: [f64; 3],
    mesh_damping: f64,
    pulsation: f64,
    frequency: f64,
}

impl LinearPair {
    /// The linear part of the model with these parameters; loads and cubic terms have no part in it.
    pub fn new(p: &Parameters) -> Self {
        Self {
            coupling: [1.0 / p.m_p.sqrt(), -1.0 / p.m_g.sqrt(), 1.0],
            support_damping: [2.0 * p.zeta_p / p.m_p, 2.0 * p.zeta_g / p.m_g, 0.0],
            support_stiffness: [p.k_p / p.m_p, p.k_g / p.m_g, 0.0],
            mesh_damping: 2.0 * p.zeta,
            pulsation: p.k0,
            frequency: p.omega,
        }
    }

    /// The vector b.
    pub fn coupling(&self) -> [f64; 3] {
        self.coupling
    }

    /// The supports' part of C, a diagonal.
    pub fn support_damping(&self) -> [f64; 3] {
        self.support_damping
    }

    /// The supports' part of K, a diagonal.
    pub fn support_stiffness(&self) -> [f64; 3] {
        self.support_stiffness
    }

    /// The factor 2 zeta of b b^T in C.
    pub fn mesh_damping(&self) -> f64 {
        self.mesh_damping
    }

    /// The damping matrix C, rows by rows.
    pub fn damping_matrix(&self) -> [[f64; 3]; 3] {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let own = if row == column { self.support_damping[row] } else { 0.0 };
                own + self.mesh_damping * self.coupling[row] * self.coupling[column]
            })
        })
    }

    /// The monodromy over a whole period from the matrix `half` over its first half: S^-1 P^T S P.
    pub fn monodromy_from_half(&self, half: &Rows) -> Rows {
        let damping = self.damping_matrix();
        // S P: the upper rows are C P_upper + P_lower, the lower ones P_upper.
        let mut s_p = [[0.0; 6]; 6];
        for row in 0..3 {
            for column in 0..6 {
                let mut sum = half[3 + row][column];
                for inner in 0..3 {
                    sum += damping[row][inner] * half[inner][column];
                }
                s_p[row][column] = sum;
                s_p[3 + row][column] = half[row][column];
            }
        }
        let mut product = [[0.0; 6]; 6];
        for row in 0..6 {
            for column in 0..6 {
                product[row][column] = (0..6).map(|inner| half[inner][row] * s_p[inner][column]).sum();
            }
        }
        // S^-1 = [[0, I], [I, -C]].
        let mut monodromy = [[0.0; 6]; 6];
        for row in 0..3 {
            for column in 0..6 {
                monodromy[row][column] = product[3 + row][column];
                let mut sum = product[row][column];
                for inner in 0..3 {
                    sum -= damping[row][inner] * product[3 + inner][column];
                }
                monodromy[3 + row][column] = sum;
            }
        }
        monodromy
    }
}

/// The identity, as the start of [`LinearPair`].
pub fn start() -> [f64; SIZE] {
    let mut all = [0.0; SIZE];
    for i in 0..6 {
        all[7 * i] = 1.0;
    }
    all
}

/// The state's 36 numbers as rows.
pub fn rows(all: &[f64; SIZE]) -> Rows {
    std::array::from_fn(|row| std::array::from_fn(|column| all[6 * row + column]))
}

impl TaylorField<SIZE> for LinearPair {
    type Piece = ();

    fn piece(&self, _time: f64, _state: &[f64; SIZE]) {}

    fn boundaries(&self, _piece: ()) -> [Option<Boundary>; 2] {
        [None, None]
    }

    fn series<const LEN: usize>(
        &self,
        _piece: (),
        time: f64,
        state: &[f64; SIZE],
        series: &mut Series<SIZE, LEN>,
    ) {
        let mut pulsation = [0.0; LEN];
        add_cosine(&mut pulsation, self.pulsation, self.frequency, time);
        let mut transmission = [[0.0; 6]; LEN];
        series[0] = *state;
        for n in 0..LEN - 1 {
            let row = series[n];
            for column in 0..6 {
                transmission[n][column] = (0..3).map(|i| self.coupling[i] * row[6 * i + column]).sum::<f64>();
            }
            let mut mesh = transmission[n];
            for j in 0..=n {
                for column in 0..6 {
                    mesh[column] += pulsation[n - j] * transmission[j][column];
                }
            }
            for column in 0..6 {
                let rate: f64 = (0..3).map(|i| self.coupling[i] * row[18 + 6 * i + column]).sum();
                mesh[column] += self.mesh_damping * rate;
            }
            let rate = 1.0 / (n + 1) as f64;
            let next = &mut series[n + 1];
            for i in 0..3 {
                for column in 0..6 {
                    let (position, velocity) = (row[6 * i + column], row[18 + 6 * i + column]);
                    next[6 * i + column] = velocity * rate;
                    next[18 + 6 * i + column] = -(self.support_damping[i] * velocity
                        + self.support_stiffness[i] * position
                        + self.coupling[i] * mesh[column])
                        * rate;
                }
            }
        }
    }
}
