//! Any model, damaged files, random bytes.

use super::foreign::foreign;
use super::{assert_equal, corners, frame, triangle, two_levels};
use crate::Mesh;
use crate::openflight::write::drawn;
use crate::openflight::{Level, Model, check, read, write};
use proptest::prelude::*;

fn any_level(textures: usize) -> impl Strategy<Value = Level> {
    // Few values, so that identical vertices and degenerate triangles happen.
    let coordinate = prop_oneof![Just(0.0), Just(-0.0), Just(1.0), -1e4..1e4f64];
    let vertex =
        (prop::array::uniform3(coordinate), prop::array::uniform3(-1.0..1f32), prop::array::uniform2(0.0..2f32));
    (prop::collection::vec(vertex, 3..30), 0..=textures, 0.0..1e3f64, 1e-3..1e3f64).prop_flat_map(
        move |(vertices, texture, near, size)| {
            let count = vertices.len() as u32;
            prop::collection::vec(prop::array::uniform3(0..count), 1..40).prop_map(move |triangles| Level {
                switch_in: near + size,
                switch_out: near,
                significant_size: size,
                texture: (texture < textures).then_some(texture),
                mesh: Mesh {
                    positions: vertices.iter().map(|v| v.0).collect(),
                    normals: vertices.iter().map(|v| v.1).collect(),
                    uvs: vertices.iter().map(|v| v.2).collect(),
                    triangles,
                },
                ..Level::default()
            })
        },
    )
}

fn any_model() -> impl Strategy<Value = Model> {
    let levels = prop::collection::vec(any_level(3), 1..4);
    (levels, "[ -~]{0,40}", prop::option::of((-90.0..90.0f64, -180.0..180.0f64)), prop::option::of("[ -~]{0,70}"))
        .prop_map(|(mut levels, name, origin, comment)| {
            levels.retain(|l| drawn(l).next().is_some());
            for (index, level) in levels.iter_mut().enumerate() {
                level.name = format!("level number {}", index + 1);
            }
            Model {
                name: format!("N{name}"),
                date: "2024".into(),
                origin,
                header_comment: comment.clone(),
                zone_comment: comment,
                textures: (0..3).map(|i| format!("t/{i}.rgb")).collect(),
                levels,
                points: vec![],
            }
        })
        .prop_filter("a level", |m| !m.levels.is_empty())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn any_model_reads_back_equal(model in any_model()) {
        let bytes = write(&model).unwrap();
        let back = read(&bytes).unwrap();
        prop_assert_eq!(frame(&back), frame(&model));
        for (b, m) in back.levels.iter().zip(&model.levels) {
            prop_assert_eq!(corners(b), corners(m));
        }
        // Once read, nothing changes any more.
        prop_assert_eq!(write(&back).unwrap().len(), bytes.len());
        let again = read(&write(&back).unwrap()).unwrap();
        assert_equal(&again, &back);
    }

    #[test]
    fn damaged_files_are_refused_or_read_but_never_panic(
        model in any_model(),
        foreign_file in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = if foreign_file { foreign() } else { write(&model).unwrap() };
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        let _ = check(&bytes);
        if let Ok(model) = read(&bytes) {
            for level in &model.levels {
                prop_assert_eq!(level.mesh.positions.len(), level.mesh.normals.len());
                let count = level.mesh.positions.len() as u32;
                prop_assert!(level.mesh.triangles.iter().flatten().all(|&v| v < count));
            }
        }
    }

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = (read(&bytes), check(&bytes));
        let header = write(&triangle()).unwrap();
        let after = [&header[..5056], &bytes].concat();
        let _ = (read(&after), check(&after));
    }
}

#[test]
fn every_cut_of_a_file_is_refused() {
    for bytes in [write(&two_levels()).unwrap(), foreign()] {
        // The last byte that matters is the last pop's.
        for end in (0..bytes.len()).step_by(7).chain([bytes.len() - 4, bytes.len() - 1]) {
            // Without any push there is no level to be left open.
            let whole_palettes = end >= 324 && read(&bytes[..end]).is_ok_and(|m| m.levels.is_empty());
            assert!(whole_palettes || read(&bytes[..end]).is_err(), "{end}");
        }
    }
}
