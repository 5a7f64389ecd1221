use super::*;
use crate::splats::sigmoid;

/// Numbers 0..1 from a seed (SplitMix64, Steele, Lea and Flood 2014).
fn random(seed: u64) -> impl FnMut() -> f32 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 40) as f32 / (1u64 << 24) as f32
    }
}

/// Values that every attribute's range holds.
pub fn scene(count: usize, degree: usize) -> Splats {
    let mut next = random(7);
    let mut within = |low: f32, high: f32| low + (high - low) * next();
    let mut out = Splats::default();
    for _ in 0..count {
        out.positions.push([0; 3].map(|_| within(-9.0, 9.0)));
        out.log_scales.push([0; 3].map(|_| within(-9.9, 5.9)));
        out.rotations.push(crate::splats::unit([0; 4].map(|_| within(-1.0, 1.0))).unwrap_or([1.0, 0.0, 0.0, 0.0]));
        out.logit_opacities.push(within(-5.5, 5.5));
        let mut sh = [[0.0; 3]; 16];
        sh[0] = [0; 3].map(|_| within(-3.3, 3.3));
        sh[1..BASES[degree]].iter_mut().for_each(|rgb| *rgb = [0; 3].map(|_| within(-0.9, 0.9)));
        out.sh.push(sh);
    }
    out
}

const VERSIONS: [Version; 3] = [Version::V2, Version::V3, Version::V4];

/// Largest difference of two lists of vectors.
fn worst<const N: usize>(a: &[[f32; N]], b: &[[f32; N]]) -> f32 {
    assert_eq!(a.len(), b.len());
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// The rotation's matrix: a quaternion and its negative are one rotation.
fn matrix([w, x, y, z]: [f32; 4]) -> [f32; 9] {
    [
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        1.0 - 2.0 * (x * x + y * y),
    ]
}

#[test]
fn errors_stay_below_what_is_stated() {
    for version in VERSIONS {
        for (degree, &bases) in BASES.iter().enumerate() {
            let written = scene(5000, degree);
            let options = Options { version, ..Options::default() };
            let (read, info) = read(&write(&written, &options).unwrap(), Axes::RUB).unwrap();
            assert_eq!((info.version, info.degree), (version, degree));
            assert!(worst(&read.positions, &written.positions) <= 1.0 / 8192.0 + 1e-6);
            assert!(worst(&read.log_scales, &written.log_scales) <= 1.0 / 32.0 + 1e-5);
            let opacity = |s: &Splats| s.logit_opacities.iter().map(|&o| [sigmoid(o)]).collect::<Vec<_>>();
            assert!(worst(&opacity(&read), &opacity(&written)) <= 1.0 / 510.0 + 1e-5);
            let colors = |s: &Splats, bases: std::ops::Range<usize>| {
                s.sh.iter().flat_map(|sh| sh[bases.clone()].to_vec()).collect::<Vec<[f32; 3]>>()
            };
            let color = |bases: std::ops::Range<usize>| worst(&colors(&read, bases.clone()), &colors(&written, bases));
            assert!(color(0..1) <= 1.0 / 76.5 + 1e-5);
            assert!(color(1..4) <= 0.036, "{}", color(1..4));
            assert!(color(4..16) <= 0.067, "{}", color(4..16));
            assert!(color(bases..16) == 0.0);
            let turns = |s: &Splats| s.rotations.iter().map(|&q| matrix(q)).collect::<Vec<_>>();
            let limit = if version == Version::V2 { 0.2 } else { 0.009 };
            let turned = worst(&turns(&read), &turns(&written));
            assert!(turned < limit, "{version:?} {turned}");
            if version > Version::V2 {
                let mut off = 0.0f32;
                for (a, b) in read.rotations.iter().zip(&written.rotations) {
                    let same: f32 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                    off = off.max(a.iter().zip(b).map(|(a, b)| (a - b * same.signum()).abs()).fold(0.0, f32::max));
                }
                assert!(off < 0.0022, "{off}");
            }
        }
    }
}

#[test]
fn what_was_read_writes_the_same_again() {
    for version in VERSIONS {
        let options = Options { version, comment: "CLASSIFICATION: CUI".into(), ..Options::default() };
        let first = write(&scene(300, 3), &options).unwrap();
        let (splats, info) = read(&first, Axes::RUB).unwrap();
        assert_eq!(info.comment, "CLASSIFICATION: CUI");
        assert_eq!(comment(&first), "CLASSIFICATION: CUI");
        if version != Version::V2 {
            // Three bytes do not hold every rotation that they give.
            assert_eq!(read_again(&splats, &options), splats);
        }
        assert_eq!(first, write(&scene(300, 3), &options).unwrap());
    }
}

fn read_again(splats: &Splats, options: &Options) -> Splats {
    let mut out = read(&write(splats, options).unwrap(), Axes::RUB).unwrap().0;
    // The largest component follows from the others: once more through a square root.
    assert!(worst(&out.rotations, &splats.rotations) < 2e-3);
    out.rotations.clone_from(&splats.rotations);
    assert!(worst(&[out.sh[0][0]], &[splats.sh[0][0]]) < 1e-6);
    out
}

#[test]
fn axes_flip_shapes_and_harmonics() {
    // y and z turned round: half a turn about x, for which the rules of rotations must give the same.
    let flip = axes::Flip::between(Axes::RDF, Axes::RUB);
    assert_eq!(flip.position, [1.0, -1.0, -1.0]);
    assert_eq!(flip.rotation, [1.0, -1.0, -1.0]);
    // Odd in y and z each: basis functions at (x, −y, −z) are these signs times themselves at (x, y, z).
    let basis = |[x, y, z]: [f32; 3]| {
        [
            1.0,
            -y,
            z,
            -x,
            x * y,
            -y * z,
            2.0 * z * z - x * x - y * y,
            -x * z,
            x * x - y * y,
            -y * (3.0 * x * x - y * y),
            x * y * z,
            -y * (4.0 * z * z - x * x - y * y),
            z * (2.0 * z * z - 3.0 * x * x - 3.0 * y * y),
            -x * (4.0 * z * z - x * x - y * y),
            z * (x * x - y * y),
            -x * (x * x - 3.0 * y * y),
        ]
    };
    let all = [false, true].map(|right| [false, true].map(|up| [false, true].map(|back| Axes { right, up, back })));
    for from in all.into_iter().flatten().flatten() {
        let flip = axes::Flip::between(from, Axes::RUB);
        let at = [0.3, -0.7, 0.4];
        let there = std::array::from_fn(|i| at[i] * flip.position[i]);
        for (b, (here, there)) in basis(at).into_iter().zip(basis(there)).enumerate() {
            assert!((here * flip.sh[b] - there).abs() < 1e-6, "basis {b} from {from:?}");
        }
        // F R F is the matrix of the flipped quaternion.
        let q = scene(1, 0).rotations[0];
        let flipped = [q[0], q[1] * flip.rotation[0], q[2] * flip.rotation[1], q[3] * flip.rotation[2]];
        for (i, (a, b)) in matrix(q).into_iter().zip(matrix(flipped)).enumerate() {
            assert!((a * flip.position[i / 3] * flip.position[i % 3] - b).abs() < 1e-6);
        }
        let options = Options { axes: from, ..Options::default() };
        let back = read(&write(&scene(50, 3), &options).unwrap(), from).unwrap().0;
        assert!(worst(&back.positions, &scene(50, 3).positions) < 1e-3);
        for (a, b) in back.sh.iter().zip(&scene(50, 3).sh) {
            assert!(worst(&a[1..], &b[1..]) < 0.067);
        }
    }
}

#[test]
fn far_positions_keep_fewer_bits() {
    let mut far = scene(1, 0);
    for (reach, error) in [(2000.0, 1.0 / 8192.0), (3000.0, 1.0 / 4096.0), (1.0e6, 1.0)] {
        far.positions[0] = [reach, -reach, 0.3];
        let back = read(&write(&far, &Options::default()).unwrap(), Axes::RUB).unwrap().0;
        assert!(worst(&back.positions, &far.positions) <= error, "{reach}");
    }
    far.positions[0] = [5.0e6, 0.0, 0.0];
    assert!(write(&far, &Options::default()).unwrap_err().to_string().contains("4,194 km"));
}

#[test]
fn broken_files_are_refused() {
    let v4 =
        write(&scene(10, 1), &Options { version: Version::V4, comment: "x".into(), ..Options::default() }).unwrap();
    let v2 = write(&scene(10, 1), &Options { version: Version::V2, ..Options::default() }).unwrap();
    let with = |at: usize, value: u8| {
        let mut bad = v4.clone();
        bad[at] = value;
        bad
    };
    let table = [
        (Vec::new(), "a gzip stream or NGSP"),
        (b"ply\n".to_vec(), "a gzip stream or NGSP"),
        (with(4, 5), "version 5"),
        (with(4, 3), "version 4 outside gzip"),
        (with(11, 255), "would unfold"),
        (with(8, 11), "a stream of 99 bytes, found 90"),
        (with(12, 4), "degree 4"),
        (with(12, 0), "5 streams, found 6"),
        (with(13, 25), "24 fractional bits"),
        (with(19, 1), "a table of contents inside the file"),
        (with(16, 8), "a table of contents inside the file"),
        (with(44, 1), "a stream inside"),
        (v4[..v4.len() - 1].to_vec(), "a stream inside"),
        (v2[..v2.len() - 30].to_vec(), "gzip"),
    ];
    for (bytes, says) in table {
        let error = read(&bytes, Axes::RUB).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    for bytes in [&v2, &v4] {
        assert!((0..bytes.len()).all(|n| read(&bytes[..n], Axes::RUB).is_err()));
    }
    // Equal but for one in twenty: the streams unfold to fewer than 200 times the file, what they become to more.
    let few = scene(400_000 / 20, 0);
    let spread = |a: &[[f32; 3]]| a.iter().flat_map(|p| [*p].into_iter().chain([[0.0; 3]; 19])).collect::<Vec<_>>();
    let alike = Splats {
        positions: spread(&few.positions),
        log_scales: vec![[-3.0; 3]; 400_000],
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; 400_000],
        logit_opacities: vec![1.0; 400_000],
        sh: vec![[[0.0; 3]; 16]; 400_000],
    };
    for version in VERSIONS {
        let bytes = write(&alike, &Options { version, ..Options::default() }).unwrap();
        assert!(bytes.len() > 400_000 * 20 / 200, "{} bytes of {version:?}", bytes.len());
        let error = read(&bytes, Axes::RUB).unwrap_err().to_string();
        assert!(error.contains("400000 splats would unfold to 94400000 bytes"), "{error}");
    }
    let equal = |count: usize| Splats {
        positions: vec![[1.0, 2.0, 3.0]; count],
        log_scales: vec![[-3.0; 3]; count],
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; count],
        logit_opacities: vec![1.0; count],
        sh: vec![[[0.0; 3]; 16]; count],
    };
    assert!(read(&write(&equal(500_000), &Options::default()).unwrap(), Axes::RUB).is_err());
    assert_eq!(read(&write(&equal(50_000), &Options::default()).unwrap(), Axes::RUB).unwrap().0.sh.len(), 50_000);
    let mut bad = scene(2, 0);
    bad.log_scales[1][0] = f32::NAN;
    assert!(write(&bad, &Options::default()).unwrap_err().to_string().contains("splat 1 of 2"));
    let options = Options { comment: "two\nlines".into(), ..Options::default() };
    assert!(write(&scene(1, 0), &options).is_err());
}

/// Streams of several pieces are one gzip member, and hold what version 4 holds.
#[test]
fn pieces_join_to_one_stream() {
    use std::io::Read;
    let count = 50_000;
    let mut next = random(7);
    let mut scene = Splats::default();
    for _ in 0..count {
        scene.positions.push([0; 3].map(|_| next()));
        scene.log_scales.push([0; 3].map(|_| next() - 5.0));
        scene.rotations.push([1.0, next(), next(), next()]);
        scene.logit_opacities.push(next());
        scene.sh.push([[0; 3]; 16].map(|rgb| rgb.map(|_| 0.3 * next())));
    }
    let of = |version| Options { version, comment: "CUI".into(), ..Options::default() };
    let bytes = write(&scene, &of(Version::V3)).unwrap();
    let mut whole = Vec::new();
    let mut gzip = flate2::bufread::GzDecoder::new(bytes.as_slice());
    gzip.read_to_end(&mut whole).unwrap();
    assert!(whole.len() > 3 << 20, "{} bytes are several pieces", whole.len());
    assert_eq!(gzip.header().unwrap().comment(), Some(&b"CUI"[..]));
    assert!(gzip.into_inner().is_empty(), "nothing follows the member");
    let (back, info) = read(&bytes, Axes::RUB).unwrap();
    assert_eq!(info.comment, "CUI");
    let newest = write(&scene, &of(Version::V4)).unwrap();
    assert_eq!(back, read(&newest, Axes::RUB).unwrap().0);
    assert_eq!(write(&scene, &of(Version::V3)).unwrap(), bytes, "whichever core took which piece");
}
