//! A plane of floats: masks, depths, weights.

/// Row-major, top row first.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    pub width: usize,
    pub height: usize,
    pub data: Vec<f32>,
}

impl Plane {
    pub fn new(width: usize, height: usize, value: f32) -> Self {
        Plane { width, height, data: vec![value; width * height] }
    }
    pub fn at(&self, x: usize, y: usize) -> f32 {
        self.data[y * self.width + x]
    }
}

/// Intersection over union of two masks, each on from ½. None where both are empty.
pub fn silhouette_iou(a: &[f32], b: &[f32]) -> Option<f64> {
    let (mut both, mut either) = (0u32, 0u32);
    for (x, y) in a.iter().zip(b).map(|(x, y)| (*x >= 0.5, *y >= 0.5)) {
        both += u32::from(x && y);
        either += u32::from(x || y);
    }
    (either > 0).then(|| f64::from(both) / f64::from(either))
}
