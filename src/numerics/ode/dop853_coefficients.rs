//! Coefficients of the explicit Runge-Kutta pair of order 8(5,3) of J. R. Dormand and P. J. Prince, with the
//! dense output of order 7 and the two error estimators of E. Hairer and G. Wanner.
//!
//! Source of the method: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
//! Springer 1993, sections II.5 and II.10. Source of the digits: the authors' Fortran code DOP853 (version of
//! April 25, 1996), all of them as printed there, more than double precision holds. The tests below do not trust
//! them: every order condition is checked.
//!
//! A list of weights is given as `(stage, weight)`, stages counted from 0, zeros left out.
#![allow(clippy::excessive_precision, reason = "the digits of the source")]

/// Weights of the stages in a sum, by stage.
pub(super) type Weights = &'static [(usize, f64)];

/// Number of stages of a step with its dense output.
pub(super) const STAGES: usize = 16;

/// The stage whose argument is the result of the step and whose slope is the first one of the next step: its row
/// of [`ROWS`] holds the weights of order 8.
pub(super) const RESULT: usize = 12;

/// Where in the step each stage lies: `c_i`.
pub(super) const NODES: [f64; STAGES] = [
    0.0,
    0.0526001519587677318785587544488,
    0.0789002279381515978178381316732,
    0.11835034190722739672675719751,
    0.28164965809277260327324280249,
    0.333333333333333333333333333333,
    0.25,
    0.307692307692307692307692307692,
    0.651282051282051282051282051282,
    0.6,
    0.857142857142857142857142857142,
    1.0,
    1.0,
    0.1,
    0.2,
    0.777777777777777777777777777778,
];

/// Weights of the earlier stages in the argument of each stage: `a_ij`.
pub(super) const ROWS: [Weights; STAGES] = [
    &[],
    &[(0, 0.0526001519587677318785587544488)],
    &[(0, 0.0197250569845378994544595329183), (1, 0.0591751709536136983633785987549)],
    &[(0, 0.0295875854768068491816892993775), (2, 0.0887627564304205475450678981324)],
    &[
        (0, 0.241365134159266685502369798665),
        (2, -0.884549479328286085344864962717),
        (3, 0.924834003261792003115737966543),
    ],
    &[
        (0, 0.037037037037037037037037037037),
        (3, 0.170828608729473871279604482173),
        (4, 0.125467687566822425016691814123),
    ],
    &[
        (0, 0.037109375),
        (3, 0.170252211019544039314978060272),
        (4, 0.0602165389804559606850219397283),
        (5, -0.017578125),
    ],
    &[
        (0, 0.0370920001185047927108779319836),
        (3, 0.170383925712239993810214054705),
        (4, 0.107262030446373284651809199168),
        (5, -0.0153194377486244017527936158236),
        (6, 0.00827378916381402288758473766002),
    ],
    &[
        (0, 0.624110958716075717114429577812),
        (3, -3.36089262944694129406857109825),
        (4, -0.868219346841726006818189891453),
        (5, 27.5920996994467083049415600797),
        (6, 20.1540675504778934086186788979),
        (7, -43.4898841810699588477366255144),
    ],
    &[
        (0, 0.477662536438264365890433908527),
        (3, -2.48811461997166764192642586468),
        (4, -0.590290826836842996371446475743),
        (5, 21.2300514481811942347288949897),
        (6, 15.2792336328824235832596922938),
        (7, -33.2882109689848629194453265587),
        (8, -0.0203312017085086261358222928593),
    ],
    &[
        (0, -0.93714243008598732571704021658),
        (3, 5.18637242884406370830023853209),
        (4, 1.09143734899672957818500254654),
        (5, -8.14978701074692612513997267357),
        (6, -18.5200656599969598641566180701),
        (7, 22.7394870993505042818970056734),
        (8, 2.49360555267965238987089396762),
        (9, -3.0467644718982195003823669022),
    ],
    &[
        (0, 2.27331014751653820792359768449),
        (3, -10.5344954667372501984066689879),
        (4, -2.00087205822486249909675718444),
        (5, -17.9589318631187989172765950534),
        (6, 27.9488845294199600508499808837),
        (7, -2.85899827713502369474065508674),
        (8, -8.87285693353062954433549289258),
        (9, 12.3605671757943030647266201528),
        (10, 0.643392746015763530355970484046),
    ],
    &[
        (0, 0.0542937341165687622380535766363),
        (5, 4.45031289275240888144113950566),
        (6, 1.89151789931450038304281599044),
        (7, -5.8012039600105847814672114227),
        (8, 0.31116436695781989440891606237),
        (9, -0.152160949662516078556178806805),
        (10, 0.201365400804030348374776537501),
        (11, 0.0447106157277725905176885569043),
    ],
    &[
        (0, 0.0561675022830479523392909219681),
        (6, 0.253500210216624811088794765333),
        (7, -0.246239037470802489917441475441),
        (8, -0.124191423263816360469010140626),
        (9, 0.15329179827876569731206322685),
        (10, 0.00820105229563468988491666602057),
        (11, 0.00756789766054569976138603589584),
        (12, -0.008298),
    ],
    &[
        (0, 0.0318346481635021405060768473261),
        (5, 0.0283009096723667755288322961402),
        (6, 0.0535419883074385676223797384372),
        (7, -0.0549237485713909884646569340306),
        (10, -0.000108347328697249322858509316994),
        (11, 0.000382571090835658412954920192323),
        (12, -0.000340465008687404560802977114492),
        (13, 0.141312443674632500278074618366),
    ],
    &[
        (0, -0.428896301583791923408573538692),
        (5, -4.69762141536116384314449447206),
        (6, 7.68342119606259904184240953878),
        (7, 4.06898981839711007970213554331),
        (8, 0.356727187455281109270669543021),
        (12, -0.00139902416515901462129418009734),
        (13, 2.9475147891527723389556272149),
        (14, -9.15095847217987001081870187138),
    ],
];

/// Weights of order 8 less those of the embedded formula of order 5: `er` of the Fortran code.
pub(super) const FIFTH_ORDER_ERROR: Weights = &[
    (0, 0.01312004499419488073250102996),
    (5, -1.225156446376204440720569753),
    (6, -0.4957589496572501915214079952),
    (7, 1.664377182454986536961530415),
    (8, -0.350328848749973681688648729),
    (9, 0.3341791187130174790297318841),
    (10, 0.08192320648511571246570742613),
    (11, -0.02235530786388629525884427845),
];

/// Weights of the embedded formula of order 3: `bhh` of the Fortran code. Its error is the difference from the
/// weights of order 8.
pub(super) const THIRD_ORDER: Weights = &[
    (0, 0.244094488188976377952755905512),
    (8, 0.733846688281611857341361741547),
    (11, 0.0220588235294117647058823529412),
];

/// Weights of the last four terms of the dense output: `d4` to `d7` of the Fortran code.
pub(super) const DENSE: [Weights; 4] = [
    &[
        (0, -8.4289382761090128651353491142),
        (5, 0.5667149535193777696253178359),
        (6, -3.0689499459498916912797304727),
        (7, 2.384667656512069828772814968),
        (8, 2.1170345824450282767155149946),
        (9, -0.8713915837779729920678990749),
        (10, 2.240437430260788275854177165),
        (11, 0.6315787787694688181557024929),
        (12, -0.0889903364513333108206981174),
        (13, 18.148505520854727256656404962),
        (14, -9.1946323924783554000451984436),
        (15, -4.4360363875948939664310572),
    ],
    &[
        (0, 10.427508642579134603413151009),
        (5, 242.28349177525818288430175319),
        (6, 165.20045171727028198505394887),
        (7, -374.54675472269020279518312152),
        (8, -22.113666853125306036270938578),
        (9, 7.7334326684722638389603898808),
        (10, -30.674084731089398182061213626),
        (11, -9.3321305264302278729567221706),
        (12, 15.697238121770843886131091075),
        (13, -31.139403219565177677282850411),
        (14, -9.3529243588444783865713862664),
        (15, 35.81684148639408375246589854),
    ],
    &[
        (0, 19.985053242002433820987653617),
        (5, -387.03730874935176555105901742),
        (6, -189.17813819516756882830838328),
        (7, 527.80815920542364900561016686),
        (8, -11.573902539959630126141871134),
        (9, 6.8812326946963000169666922661),
        (10, -1.000605096691083840318386098),
        (11, 0.7777137798053443209286926574),
        (12, -2.7782057523535084065932004339),
        (13, -60.196695231264120758267380846),
        (14, 84.320405506677161018159903784),
        (15, 11.99229113618278932803513003),
    ],
    &[
        (0, -25.693933462703749003312586129),
        (5, -154.18974869023643374053993627),
        (6, -231.52937917604549567536039109),
        (7, 357.6391179106141237828534991),
        (8, 93.405324183624310003907691704),
        (9, -37.458323136451633156875139351),
        (10, 104.09964950896230045147246184),
        (11, 29.840293426660503123344363579),
        (12, -43.533456590011143754432175058),
        (13, 96.3245539591882829483949506),
        (14, -39.177261675615439165231486172),
        (15, -149.72683625798562581422125276),
    ],
];

#[cfg(test)]
mod tests {
    use super::super::dense::{DenseStep, weighted_sum};
    use super::*;

    /// A rooted tree: the subtrees that hang from its root, as places in the list of all trees, in falling order.
    struct Tree {
        order: usize,
        branches: Vec<usize>,
    }

    /// Every rooted tree with up to `most` vertices, smaller ones first.
    fn trees(most: usize) -> Vec<Tree> {
        let mut trees = vec![Tree { order: 1, branches: Vec::new() }];
        for order in 2..=most {
            let mut grown = Vec::new();
            add_branches(&trees, order - 1, trees.len() - 1, &mut Vec::new(), &mut grown);
            trees.extend(grown.into_iter().map(|branches| Tree { order, branches }));
        }
        trees
    }

    /// Adds to `grown` every way to hang `vertices` vertices under a root, by trees no later than `latest`.
    fn add_branches(
        trees: &[Tree],
        vertices: usize,
        latest: usize,
        under: &mut Vec<usize>,
        grown: &mut Vec<Vec<usize>>,
    ) {
        if vertices == 0 {
            grown.push(under.clone());
            return;
        }
        for branch in (0..=latest).rev().filter(|branch| trees[*branch].order <= vertices) {
            under.push(branch);
            add_branches(trees, vertices - trees[branch].order, branch, under, grown);
            under.pop();
        }
    }

    /// Each tree with its density gamma (II.2, definition 2.10) and what the stages make of it: the elementary
    /// weight of a formula with weights `b` is the sum of `b_i` times the i-th of these numbers.
    fn elementary(trees: &[Tree]) -> Vec<(usize, f64, [f64; STAGES])> {
        let mut known: Vec<(usize, f64, [f64; STAGES])> = Vec::new();
        for tree in trees {
            let mut density = tree.order as f64;
            let mut weights = [1.0; STAGES];
            for &branch in &tree.branches {
                let (_, branch_density, branch_weights) = known[branch];
                density *= branch_density;
                for (weight, row) in weights.iter_mut().zip(ROWS) {
                    *weight *= row.iter().map(|(stage, a)| a * branch_weights[*stage]).sum::<f64>();
                }
            }
            known.push((tree.order, density, weights));
        }
        known
    }

    fn apply(weights: Weights, to: &[f64; STAGES]) -> f64 {
        weights.iter().map(|(stage, weight)| weight * to[*stage]).sum()
    }

    /// Greatest residual of a formula's conditions of one order.
    fn residual(order: usize, of: impl Fn(f64, &[f64; STAGES]) -> f64) -> f64 {
        let trees = trees(order);
        elementary(&trees)
            .iter()
            .filter(|(vertices, ..)| *vertices == order)
            .fold(0.0, |most, (_, density, weights)| most.max(of(*density, weights).abs()))
    }

    #[test]
    fn there_are_as_many_trees_as_there_should_be() {
        // II.2, table 2.1.
        let trees = trees(9);
        let counts: Vec<usize> =
            (1..=9).map(|order| trees.iter().filter(|tree| tree.order == order).count()).collect();
        assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115, 286]);
    }

    #[test]
    fn rows_sum_to_the_nodes() {
        for (row, node) in ROWS.iter().zip(NODES) {
            assert!((apply(row, &[1.0; STAGES]) - node).abs() < 1e-14, "{row:?}");
        }
    }

    #[test]
    fn the_result_is_of_order_8_and_not_of_order_9() {
        let off = |density: f64, weights: &[f64; STAGES]| apply(ROWS[RESULT], weights) - 1.0 / density;
        for order in 1..=8 {
            assert!(residual(order, off) < 1e-14, "order {order}: {:e}", residual(order, off));
        }
        assert!(residual(9, off) > 1e-7);
    }

    #[test]
    fn the_estimators_are_of_order_5_and_3() {
        let fifth = |_: f64, weights: &[f64; STAGES]| apply(FIFTH_ORDER_ERROR, weights);
        for order in 1..=5 {
            assert!(residual(order, fifth) < 1e-14, "order {order}: {:e}", residual(order, fifth));
        }
        assert!(residual(6, fifth) > 1e-5);
        let third = |density: f64, weights: &[f64; STAGES]| apply(THIRD_ORDER, weights) - 1.0 / density;
        for order in 1..=3 {
            assert!(residual(order, third) < 1e-14, "order {order}: {:e}", residual(order, third));
        }
        assert!(residual(4, third) > 1e-4);
    }

    #[test]
    fn the_dense_output_is_of_order_7_all_over_the_step() {
        // Unit vectors in place of slopes: the step's own code then gives the weights of the stages.
        let mut slopes = [[0.0; STAGES]; STAGES];
        for (stage, slope) in slopes.iter_mut().enumerate() {
            slope[stage] = 1.0;
        }
        let result = weighted_sum(ROWS[RESULT], &slopes);
        let step = DenseStep::new((0.0, [0.0; STAGES]), (1.0, result), &slopes);
        for part in [0.05, 0.1, 0.25, 0.4, 0.5, 0.625, 0.8, 0.95] {
            let dense = step.value(part);
            let off = |order: usize| {
                residual(order, |density, weights| {
                    let weight: f64 = dense.iter().zip(weights).map(|(a, b)| a * b).sum();
                    weight - part.powf(order as f64) / density
                })
            };
            for order in 1..=7 {
                assert!(off(order) < 1e-13, "order {order} at {part}: {:e}", off(order));
            }
            assert!(off(8) > 1e-8, "order 8 at {part}: {:e}", off(8));
        }
    }
}
