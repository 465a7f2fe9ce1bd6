//! Small dense linear systems.

/// Gaussian elimination with partial pivoting on an N by N system with its right-hand side in the last of M = N + 1
/// columns. `None` where it is singular to rounding.
pub(crate) fn gauss<const N: usize, const M: usize>(m: &mut [[f64; M]; N]) -> Option<[f64; N]> {
    let scale = m.iter().flat_map(|row| &row[..N]).fold(0.0_f64, |s, v| s.max(v.abs()));
    for k in 0..N {
        let pivot = (k..N).max_by(|&a, &b| m[a][k].abs().total_cmp(&m[b][k].abs()))?;
        m.swap(k, pivot);
        let top = m[k];
        if top[k].is_nan() || top[k].abs() <= SINGULAR * scale {
            return None;
        }
        for row in m.iter_mut().skip(k + 1) {
            let factor = row[k] / top[k];
            for j in k..M {
                row[j] -= factor * top[j];
            }
        }
    }
    let mut x = [0.0; N];
    for k in (0..N).rev() {
        let sum: f64 = (k + 1..N).map(|j| m[k][j] * x[j]).sum();
        x[k] = (m[k][N] - sum) / m[k][k];
    }
    Some(x)
}

/// A pivot this small relative to the largest entry is zero.
const SINGULAR: f64 = 1e-14;
