//! Work on rows side by side. What comes out does not depend on the number of cores: every row is worked on alone.

use crate::Splats;

/// Rows that are not worth a thread of their own.
const LEAST: usize = 16_384;

/// Rows for each thread.
fn share(count: usize) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    count.div_ceil(cores).max(LEAST)
}

/// Calls `work` with the number of the first row and the bytes of some rows, until all have been had.
pub fn on_rows(bytes: &mut [u8], row: usize, work: impl Fn(usize, &mut [u8]) + Sync) {
    let share = share(bytes.len() / row.max(1));
    std::thread::scope(|scope| {
        for (i, rows) in bytes.chunks_mut(share * row.max(1)).enumerate() {
            let work = &work;
            scope.spawn(move || work(i * share, rows));
        }
    });
}

/// Some splats of a scene, and the number of the first.
pub struct Rows<'a> {
    pub first: usize,
    pub positions: &'a mut [[f32; 3]],
    pub log_scales: &'a mut [[f32; 3]],
    pub rotations: &'a mut [[f32; 4]],
    pub logit_opacities: &'a mut [f32],
    pub sh: &'a mut [[[f32; 3]; 16]],
}

/// A scene of so many splats, zeros that `work` fills.
pub fn splats(count: usize, work: impl Fn(Rows) + Sync) -> Splats {
    let mut out = Splats {
        positions: vec![[0.0; 3]; count],
        log_scales: vec![[0.0; 3]; count],
        rotations: vec![[0.0; 4]; count],
        logit_opacities: vec![0.0; count],
        sh: vec![[[0.0; 3]; 16]; count],
    };
    let share = share(count);
    let positions = out.positions.chunks_mut(share);
    let shapes = out.log_scales.chunks_mut(share).zip(out.rotations.chunks_mut(share));
    let looks = out.logit_opacities.chunks_mut(share).zip(out.sh.chunks_mut(share));
    std::thread::scope(|scope| {
        for (i, ((positions, shape), look)) in positions.zip(shapes).zip(looks).enumerate() {
            let ((log_scales, rotations), (logit_opacities, sh)) = (shape, look);
            let rows = Rows { first: i * share, positions, log_scales, rotations, logit_opacities, sh };
            let work = &work;
            scope.spawn(move || work(rows));
        }
    });
    out
}
