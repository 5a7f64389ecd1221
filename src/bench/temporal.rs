//! TC, temporal coherence: frames of a slow, even flight of the camera.

use super::Picture;
use super::perception::psnr;

/// Whether all frames have one size.
pub fn same_size(frames: &[Picture]) -> bool {
    frames.windows(2).all(|f| (f[0].width, f[0].height) == (f[1].width, f[1].height))
}

/// Mean over pixels and channels of |I(t−1) − 2 I(t) + I(t+1)|, share of full scale, where `subject` is true in any of the
/// three; None for fewer than three frames and for frames of several sizes.
pub fn smoothness(frames: &[Picture], subject: &[Vec<bool>]) -> Option<f64> {
    if !same_size(frames) {
        return None;
    }
    let (mut sum, mut n) = (0.0, 0.0);
    for (f, s) in frames.windows(3).zip(subject.windows(3)) {
        for i in (0..f[0].pixels.len()).filter(|i| s.iter().any(|s| s[*i])) {
            let at = |t: usize, k: usize| f64::from(f[t].pixels[i][k]);
            sum += (0..3).map(|k| (at(0, k) - 2.0 * at(1, k) + at(2, k)).abs()).sum::<f64>() / 3.0;
            n += 1.0;
        }
    }
    (n > 0.0).then(|| sum / n)
}

/// Mean |L(t−1) − 2 L(t) + L(t+1)| of the subject's mean luma, share of full scale; None for fewer than three frames
/// that show it.
pub fn flicker(frames: &[Picture], subject: &[Vec<bool>]) -> Option<f64> {
    let mean = |(f, s): (&Picture, &Vec<bool>)| {
        let shown: Vec<f32> = f.luma().into_iter().zip(s).filter(|(_, s)| **s).map(|(l, _)| l).collect();
        (!shown.is_empty()).then(|| shown.iter().map(|l| f64::from(*l)).sum::<f64>() / shown.len() as f64)
    };
    let levels: Vec<f64> = frames.iter().zip(subject).map(mean).collect::<Option<_>>()?;
    let bends: Vec<f64> = levels.windows(3).map(|l| (l[0] - 2.0 * l[1] + l[2]).abs()).collect();
    (!bends.is_empty()).then(|| bends.iter().sum::<f64>() / bends.len() as f64)
}

/// PSNR, dB, of the frame at the return to a pose against the frame that left it.
pub fn loop_closure(first: &Picture, last: &Picture) -> f64 {
    psnr(&first.pixels, &last.pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(level: impl Fn(usize) -> f32) -> Vec<Picture> {
        (0..6).map(|t| Picture::new(4, 4, vec![[level(t); 3]; 16])).collect()
    }

    #[test]
    fn an_even_change_is_smooth_and_a_jump_is_not() {
        let subject = vec![vec![true; 16]; 6];
        let even = frames(|t| 0.1 * t as f32);
        assert!(smoothness(&even, &subject).unwrap() < 1e-6 && flicker(&even, &subject).unwrap() < 1e-6);
        let jumping = frames(|t| if t % 2 == 0 { 0.4 } else { 0.5 });
        assert!((smoothness(&jumping, &subject).unwrap() - 0.2).abs() < 1e-6);
        assert!((flicker(&jumping, &subject).unwrap() - 0.2).abs() < 1e-6);
        assert_eq!(smoothness(&even[..2], &subject[..2]), None);
        let mut smaller = even.clone();
        smaller[1] = Picture::new(2, 2, vec![[0.1; 3]; 4]);
        assert_eq!(smoothness(&smaller, &subject), None);
        assert_eq!(flicker(&even, &vec![vec![false; 16]; 6]), None);
        assert!((loop_closure(&jumping[0], &jumping[1]) - 20.0).abs() < 1e-4);
    }
}
