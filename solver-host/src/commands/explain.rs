//! `mintime solve --explain`: the paper's section IV in numbers, for one maneuver.

use mintime::solver::Extremal;
use mintime::solver::paper::Condition;

/// Step by step: switching times, final state residual, the linear conditions on the costate, their least-squares
/// solution, and the residual of the boundary value problem. Dimensionless unless a unit stands there.
pub(crate) fn explain(extremal: &Extremal) -> String {
    let explained = extremal.explain();
    let numbers = |c: &[f64]| c.iter().map(|v| format!("{v:+.9}")).collect::<Vec<_>>().join("  ");
    let mut lines = vec![
        "Equation numbers: Ritz, Hehn, Lupashin, D'Andrea, \"Quadrocopter Performance Benchmarking Using Optimal Control\"."
            .to_owned(),
        format!(
            "T = {:.9} s. Dimensionless by (3): time in 1/{} s, length in {:.6} m.",
            extremal.duration_s(),
            extremal.limits.rate_max_radps,
            extremal.limits.scale().length_m
        ),
        String::new(),
        "Switching times (23), and singular arcs of section IV-B:".to_owned(),
    ];
    let mut t = 0.0;
    for segment in &extremal.segments {
        let rate = super::answer::rate_word(segment.inputs.rate);
        let thrust = super::answer::thrust_word(segment.inputs.thrust);
        lines.push(format!("  {t:.9} s  u_R {rate:<9} u_T {thrust}  for {:.9} s", segment.duration));
        t += segment.duration;
    }
    lines.extend([
        String::new(),
        format!("Final state residual (24), (33), with W = 1:   P_res = {:.3e}", explained.p_res),
        String::new(),
        "Conditions on c = (c1, c2, c3, c4), (27)-(29), (36), (37), as A c = r (30):".to_owned(),
    ]);
    for row in &explained.rows {
        let what = match row.condition {
            Condition::RateSwitch => "Phi_R = 0 (27), (36)",
            Condition::RateIntegral => "integral of Phi_R' (28)",
            Condition::ThrustSwitch => "Phi_T = 0 (29)",
            Condition::ArcEdge => "Phi_R' = 0 (37)",
        };
        lines.push(format!("  {:.6} s  {what:<24} [{}] c = {:+.9}", row.time_s, numbers(&row.a), row.r));
    }
    lines.push(String::new());
    lines.push(match explained.c_least_squares {
        Some(c) => format!("Least-squares solution (31):   c* = [{}]", numbers(&c)),
        None => "Least-squares solution (31):   none, the conditions do not determine c".to_owned(),
    });
    lines.extend([
        format!("  residual with it                         {:.3e}", explained.c_res_least_squares),
        format!("The extremal's own costate:    c  = [{}]", numbers(&extremal.costate.to_array())),
        format!("  condition residual (34)          C_res = {:.3e}", explained.c_res),
        String::new(),
        format!(
            "Residual of the boundary value problem (32), integrated independently:   {:.3e}",
            explained.bvp_residual
        ),
    ]);
    lines.join("\n")
}
