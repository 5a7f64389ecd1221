//! COLMAP's camera models: which parameters each has, and where it puts a point.

/// In COLMAP's own order: the numbers of its binary files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lens {
    SimplePinhole,
    Pinhole,
    SimpleRadial,
    Radial,
    OpenCv,
    OpenCvFisheye,
    FullOpenCv,
    Fov,
    SimpleRadialFisheye,
    RadialFisheye,
    ThinPrismFisheye,
    RadTanThinPrismFisheye,
}

use Lens::*;

const TABLE: [(Lens, &str, &str); 12] = [
    (SimplePinhole, "SIMPLE_PINHOLE", "f cx cy"),
    (Pinhole, "PINHOLE", "fx fy cx cy"),
    (SimpleRadial, "SIMPLE_RADIAL", "f cx cy k"),
    (Radial, "RADIAL", "f cx cy k1 k2"),
    (OpenCv, "OPENCV", "fx fy cx cy k1 k2 p1 p2"),
    (OpenCvFisheye, "OPENCV_FISHEYE", "fx fy cx cy k1 k2 k3 k4"),
    (FullOpenCv, "FULL_OPENCV", "fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6"),
    (Fov, "FOV", "fx fy cx cy omega"),
    (SimpleRadialFisheye, "SIMPLE_RADIAL_FISHEYE", "f cx cy k"),
    (RadialFisheye, "RADIAL_FISHEYE", "f cx cy k1 k2"),
    (ThinPrismFisheye, "THIN_PRISM_FISHEYE", "fx fy cx cy k1 k2 p1 p2 k3 k4 sx1 sy1"),
    (RadTanThinPrismFisheye, "RAD_TAN_THIN_PRISM_FISHEYE", "fx fy cx cy k0 k1 k2 k3 k4 k5 p0 p1 s0 s1 s2 s3"),
];

impl Lens {
    pub const ALL: [Lens; 12] = [
        SimplePinhole,
        Pinhole,
        SimpleRadial,
        Radial,
        OpenCv,
        OpenCvFisheye,
        FullOpenCv,
        Fov,
        SimpleRadialFisheye,
        RadialFisheye,
        ThinPrismFisheye,
        RadTanThinPrismFisheye,
    ];

    pub fn of_number(number: i32) -> Option<Lens> {
        usize::try_from(number).ok().and_then(|n| TABLE.get(n)).map(|row| row.0)
    }

    pub fn of_name(name: &str) -> Option<Lens> {
        TABLE.iter().find(|row| row.1 == name).map(|row| row.0)
    }

    pub fn name(self) -> &'static str {
        TABLE[self as usize].1
    }

    /// Names of the parameters, in their order, with spaces between.
    pub fn parameters(self) -> &'static str {
        TABLE[self as usize].2
    }

    pub fn count(self) -> usize {
        self.parameters().split(' ').count()
    }

    pub fn has_one_focal_length(self) -> bool {
        self.parameters().starts_with("f ")
    }

    pub fn is_pinhole(self) -> bool {
        matches!(self, SimplePinhole | Pinhole)
    }

    /// Where the lens moves (x/z, y/z) to, before focal length and centre.
    pub fn distort(self, parameters: &[f64], [u, v]: [f64; 2]) -> [f64; 2] {
        let k = &parameters[if self.has_one_focal_length() { 3 } else { 4 }..];
        let r = u.hypot(v);
        let theta = r.atan();
        // Along the radius, by a factor; at the middle nothing moves.
        let scaled = |by: f64| [u * by, v * by];
        let bent = |angle: f64| if r > 1e-8 { scaled(angle / r) } else { [u, v] };
        match self {
            SimplePinhole | Pinhole => [u, v],
            SimpleRadial => scaled(1.0 + k[0] * r * r),
            Radial => scaled(1.0 + series(r * r, &k[..2])),
            OpenCv => tangential([u, v], 1.0 + series(r * r, &k[..2]), [k[2], k[3]]),
            FullOpenCv => {
                let above = 1.0 + series(r * r, &[k[0], k[1], k[4]]);
                tangential([u, v], above / (1.0 + series(r * r, &k[5..8])), [k[2], k[3]])
            }
            SimpleRadialFisheye => bent(theta * (1.0 + k[0] * theta * theta)),
            RadialFisheye => bent(theta * (1.0 + series(theta * theta, &k[..2]))),
            OpenCvFisheye => bent(theta * (1.0 + series(theta * theta, &k[..4]))),
            Fov => {
                let omega = k[0];
                if omega.abs() < 1e-6 {
                    return [u, v];
                }
                let wide = 2.0 * (omega / 2.0).tan();
                if r > 1e-8 { scaled((r * wide).atan() / (r * omega)) } else { scaled(wide / omega) }
            }
            ThinPrismFisheye => {
                let [x, y] = bent(theta);
                let square = x * x + y * y;
                let radial = 1.0 + series(square, &[k[0], k[1], k[4], k[5]]);
                let [a, b] = tangential([x, y], radial, [k[2], k[3]]);
                [a + k[6] * square, b + k[7] * square]
            }
            RadTanThinPrismFisheye => {
                let by = 1.0 + series(theta * theta, &k[..6]);
                let [x, y] = bent(theta).map(|c| c * by);
                let square = x * x + y * y;
                let [p, q] = [k[6], k[7]];
                let along = 2.0 * (x * p + y * q);
                [
                    x + along * x + square * p + square * (k[8] + square * k[9]),
                    y + along * y + square * q + square * (k[10] + square * k[11]),
                ]
            }
        }
    }
}

/// k₁ s + k₂ s² + …
fn series(s: f64, k: &[f64]) -> f64 {
    k.iter().rev().fold(0.0, |sum, k| (sum + k) * s)
}

/// Brown's model as OpenCV writes it.
fn tangential([x, y]: [f64; 2], radial: f64, [p1, p2]: [f64; 2]) -> [f64; 2] {
    let square = x * x + y * y;
    [
        x * radial + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
        y * radial + 2.0 * p2 * x * y + p1 * (square + 2.0 * y * y),
    ]
}
