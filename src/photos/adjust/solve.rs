//! Equations of many cameras, six numbers each.

/// Of one camera: shift, rotation vector.
pub type Six = [f64; 6];

/// Steps at most, and what is left of the residual when they end.
const STEPS: usize = 200;
const LEFT: f64 = 1e-4;

/// Hestenes and Stiefel 1952, preconditioned by `eased`.
pub fn conjugate_gradients(
    right: &[Six],
    times: impl Fn(&[Six]) -> Vec<Six>,
    eased: impl Fn(&[Six]) -> Vec<Six>,
) -> Vec<Six> {
    let dot = |a: &[Six], b: &[Six]| -> f64 { a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum() };
    let add = |a: &mut [Six], b: &[Six], by: f64| {
        a.as_flattened_mut().iter_mut().zip(b.as_flattened()).for_each(|(a, b)| *a += by * b);
    };
    let mut x = vec![[0.0; 6]; right.len()];
    let mut rest = right.to_vec();
    let mut easy = eased(&rest);
    let mut way = easy.clone();
    let mut size = dot(&rest, &easy);
    let enough = LEFT * LEFT * size;
    for _ in 0..STEPS {
        let along = times(&way);
        let bend = dot(&way, &along);
        if size.is_nan() || size <= enough || bend.is_nan() || bend <= 0.0 {
            break;
        }
        let far = size / bend;
        add(&mut x, &way, far);
        add(&mut rest, &along, -far);
        easy = eased(&rest);
        let next = dot(&rest, &easy);
        let share = next / size;
        way.as_flattened_mut().iter_mut().zip(easy.as_flattened()).for_each(|(w, e)| *w = e + share * *w);
        size = next;
    }
    x
}

/// L of L Lᵀ; `None` where it is not positive definite.
pub fn cholesky(m: &[Six; 6]) -> Option<[Six; 6]> {
    let mut l = [[0.0; 6]; 6];
    for i in 0..6 {
        for j in 0..=i {
            let sum = m[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            if i == j {
                if sum.is_nan() || sum <= 0.0 {
                    return None;
                }
                l[i][i] = sum.sqrt();
            } else {
                l[i][j] = sum / l[j][j];
            }
        }
    }
    Some(l)
}

pub fn solved(l: &[Six; 6], right: &Six) -> Six {
    let mut y = *right;
    for i in 0..6 {
        y[i] = (y[i] - (0..i).map(|k| l[i][k] * y[k]).sum::<f64>()) / l[i][i];
    }
    for i in (0..6).rev() {
        y[i] = (y[i] - (i + 1..6).map(|k| l[k][i] * y[k]).sum::<f64>()) / l[i][i];
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_solves() {
        let m: [Six; 6] = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { 7.0 + i as f64 } else { 1.0 / (1.0 + i as f64 + j as f64) })
        });
        let x: Six = [1.0, -2.0, 0.5, 3.0, -1.0, 0.25];
        let right: Six = std::array::from_fn(|i| (0..6).map(|j| m[i][j] * x[j]).sum());
        let found = solved(&cholesky(&m).unwrap(), &right);
        assert!(found.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        assert!(cholesky(&[[0.0; 6]; 6]).is_none());
    }
}
