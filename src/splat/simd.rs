//! Lanes of f32, their width chosen at run time: AVX-512 (16), AVX2 with FMA (8), or plain arrays (8).
//!
//! A kernel is written once against [`Simd`] and run by [`dispatch`], which picks the widest set that the processor
//! has. Sums over lanes are taken in a fixed order, so one machine gives the same bytes every time; machines with
//! different instruction sets may differ in the last bits.

/// A set of vector instructions. A value of the type is the proof that the processor has them.
pub trait Simd: Copy + Send + Sync {
    /// 8 or 16: always divides a tile's row.
    const LANES: usize;
    type F: Copy;
    type M: Copy;

    fn splat(self, x: f32) -> Self::F;
    /// The first `LANES` values.
    fn load(self, from: &[f32]) -> Self::F;
    fn store(self, value: Self::F, to: &mut [f32]);
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    fn div(self, a: Self::F, b: Self::F) -> Self::F;
    /// 1 / a for a normal, finite a; relative error below 1e-6. Cheaper than a division.
    fn reciprocal(self, a: Self::F) -> Self::F;
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    fn sqrt(self, a: Self::F) -> Self::F;
    /// a·b + c
    fn fma(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// c − a·b
    fn fnma(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// a ≥ b, false for NaN.
    fn ge(self, a: Self::F, b: Self::F) -> Self::M;
    /// a > b, false for NaN.
    fn gt(self, a: Self::F, b: Self::F) -> Self::M;
    fn and(self, a: Self::M, b: Self::M) -> Self::M;
    fn any(self, m: Self::M) -> bool;
    /// Where `m`: a, else b.
    fn select(self, m: Self::M, a: Self::F, b: Self::F) -> Self::F;
    /// 2^a for |a| ≤ 126, relative error below 2e-7; outside that any value.
    fn exp2(self, a: Self::F) -> Self::F;
    /// All lanes added, in a fixed order.
    fn sum(self, a: Self::F) -> f32;
    /// Without what is behind the point, for |a| < 2³¹; of others any value.
    fn whole(self, a: Self::F, to: &mut [i32]);
    /// `from[at[lane]]` of every lane: the first numbers of all, the second, third and fourth ones.
    fn gather(self, from: &[[f32; 4]], at: &[u32]) -> [Self::F; 4];
}

/// Work that [`dispatch`] runs with the processor's widest instructions. Mark `run` `#[inline(always)]`.
pub trait Kernel {
    type Output;
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// Runs `kernel` with the widest instructions here.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(simd) = x86::Avx512::detect() {
            return simd.vectorize(kernel);
        }
        if let Some(simd) = x86::Avx2::detect() {
            return simd.vectorize(kernel);
        }
    }
    kernel.run(Portable)
}

/// The same in eight lanes, for rows that are no longer.
pub fn dispatch_eight<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = x86::Avx2::detect() {
        return simd.vectorize(kernel);
    }
    kernel.run(Portable)
}

/// 2^f = 1 + f·P(f) on [−0.5, 0.5] (Cephes `exp2f`).
const EXP2: [f32; 6] = [1.535_336_2e-4, 1.339_887_4e-3, 9.618_437e-3, 5.550_332_5e-2, 2.402_264_8e-1, 6.931_472e-1];
/// 1.5 · 2^23: adding it rounds to an integer that then stands in the low mantissa bits.
const ROUND: f32 = 12_582_912.0;

/// Plain arrays, which the compiler maps to whatever the target has.
#[derive(Clone, Copy)]
pub struct Portable;

type Array = [f32; 8];

#[inline(always)]
fn map(a: Array, b: Array, f: impl Fn(f32, f32) -> f32) -> Array {
    let mut out = [0.0; 8];
    for i in 0..8 {
        out[i] = f(a[i], b[i]);
    }
    out
}

impl Simd for Portable {
    const LANES: usize = 8;
    type F = Array;
    type M = [bool; 8];

    #[inline(always)]
    fn splat(self, x: f32) -> Array {
        [x; 8]
    }
    #[inline(always)]
    fn load(self, from: &[f32]) -> Array {
        let mut out = [0.0; 8];
        out.copy_from_slice(&from[..8]);
        out
    }
    #[inline(always)]
    fn store(self, value: Array, to: &mut [f32]) {
        to[..8].copy_from_slice(&value);
    }
    #[inline(always)]
    fn add(self, a: Array, b: Array) -> Array {
        map(a, b, |x, y| x + y)
    }
    #[inline(always)]
    fn sub(self, a: Array, b: Array) -> Array {
        map(a, b, |x, y| x - y)
    }
    #[inline(always)]
    fn mul(self, a: Array, b: Array) -> Array {
        map(a, b, |x, y| x * y)
    }
    #[inline(always)]
    fn div(self, a: Array, b: Array) -> Array {
        map(a, b, |x, y| x / y)
    }
    #[inline(always)]
    fn reciprocal(self, a: Array) -> Array {
        map(a, a, |x, _| 1.0 / x)
    }
    #[inline(always)]
    fn min(self, a: Array, b: Array) -> Array {
        map(a, b, |x, y| if x < y { x } else { y })
    }
    #[inline(always)]
    fn sqrt(self, a: Array) -> Array {
        map(a, a, |x, _| x.sqrt())
    }
    // Not `mul_add`: without the instruction that is a slow library call.
    #[inline(always)]
    fn fma(self, a: Array, b: Array, c: Array) -> Array {
        self.add(self.mul(a, b), c)
    }
    #[inline(always)]
    fn fnma(self, a: Array, b: Array, c: Array) -> Array {
        self.sub(c, self.mul(a, b))
    }
    #[inline(always)]
    fn ge(self, a: Array, b: Array) -> [bool; 8] {
        std::array::from_fn(|i| a[i] >= b[i])
    }
    #[inline(always)]
    fn gt(self, a: Array, b: Array) -> [bool; 8] {
        std::array::from_fn(|i| a[i] > b[i])
    }
    #[inline(always)]
    fn and(self, a: [bool; 8], b: [bool; 8]) -> [bool; 8] {
        std::array::from_fn(|i| a[i] & b[i])
    }
    #[inline(always)]
    fn any(self, m: [bool; 8]) -> bool {
        m.iter().fold(false, |a, b| a | b)
    }
    #[inline(always)]
    fn select(self, m: [bool; 8], a: Array, b: Array) -> Array {
        std::array::from_fn(|i| if m[i] { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn exp2(self, a: Array) -> Array {
        map(a, a, |x, _| {
            let r = x + ROUND;
            let f = x - (r - ROUND);
            let mut p = EXP2[0];
            for c in &EXP2[1..] {
                p = p * f + c;
            }
            f32::from_bits((p * f + 1.0).to_bits().wrapping_add(r.to_bits() << 23))
        })
    }
    #[inline(always)]
    fn sum(self, a: Array) -> f32 {
        ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]))
    }
    #[inline(always)]
    fn whole(self, a: Array, to: &mut [i32]) {
        for (to, a) in to[..8].iter_mut().zip(a) {
            *to = a as i32;
        }
    }
    #[inline(always)]
    fn gather(self, from: &[[f32; 4]], at: &[u32]) -> [Array; 4] {
        let mut out = [[0.0; 8]; 4];
        for (lane, at) in at[..8].iter().enumerate() {
            for (out, value) in out.iter_mut().zip(from[*at as usize]) {
                out[lane] = value;
            }
        }
        out
    }
}

#[cfg(target_arch = "x86_64")]
pub mod x86 {
    use super::{EXP2, Kernel, ROUND, Simd};
    use std::arch::x86_64::*;

    /// Exists only where AVX2 and FMA do: `detect` is the only way to make one.
    #[derive(Clone, Copy)]
    pub struct Avx2(());

    impl Avx2 {
        #[inline]
        pub fn detect() -> Option<Self> {
            (is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")).then_some(Avx2(()))
        }
        #[inline]
        pub fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
            #[target_feature(enable = "avx2,fma")]
            fn inner<K: Kernel>(simd: Avx2, kernel: K) -> K::Output {
                kernel.run(simd)
            }
            // SAFETY: `self` proves that the processor has AVX2 and FMA.
            unsafe { inner(self, kernel) }
        }
    }

    /// One safe method a line: the instruction set is there because `self` is.
    macro_rules! methods {
        ($(fn $name:ident($self:ident $(, $arg:ident: $ty:ty)*) -> $out:ty $body:block)*) => {
            $(#[inline(always)]
            // Some bodies need no unsafe: on masks that are integers, for one.
            #[allow(unused_unsafe)]
            fn $name($self $(, $arg: $ty)*) -> $out {
                // SAFETY: `self` proves the instruction set; slices are indexed to LANES before their pointer is used.
                unsafe { $body }
            })*
        };
    }

    /// One entry of [`Simd::gather`], found by a checked index.
    macro_rules! four {
        ($from:ident, $at:expr) => {
            _mm_loadu_ps($from[$at as usize].as_ptr())
        };
    }

    impl Simd for Avx2 {
        const LANES: usize = 8;
        type F = __m256;
        type M = __m256;
        methods! {
            fn splat(self, x: f32) -> __m256 { _mm256_set1_ps(x) }
            fn load(self, from: &[f32]) -> __m256 { _mm256_loadu_ps(from[..8].as_ptr()) }
            fn store(self, value: __m256, to: &mut [f32]) -> () { _mm256_storeu_ps(to[..8].as_mut_ptr(), value) }
            fn add(self, a: __m256, b: __m256) -> __m256 { _mm256_add_ps(a, b) }
            fn sub(self, a: __m256, b: __m256) -> __m256 { _mm256_sub_ps(a, b) }
            fn mul(self, a: __m256, b: __m256) -> __m256 { _mm256_mul_ps(a, b) }
            fn div(self, a: __m256, b: __m256) -> __m256 { _mm256_div_ps(a, b) }
            fn reciprocal(self, a: __m256) -> __m256 {
                // An estimate and one Newton step: r + r (1 − a r).
                let r = _mm256_rcp_ps(a);
                _mm256_fmadd_ps(r, _mm256_fnmadd_ps(a, r, _mm256_set1_ps(1.0)), r)
            }
            fn min(self, a: __m256, b: __m256) -> __m256 { _mm256_min_ps(a, b) }
            fn sqrt(self, a: __m256) -> __m256 { _mm256_sqrt_ps(a) }
            fn fma(self, a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fmadd_ps(a, b, c) }
            fn fnma(self, a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fnmadd_ps(a, b, c) }
            fn ge(self, a: __m256, b: __m256) -> __m256 { _mm256_cmp_ps::<_CMP_GE_OQ>(a, b) }
            fn gt(self, a: __m256, b: __m256) -> __m256 { _mm256_cmp_ps::<_CMP_GT_OQ>(a, b) }
            fn and(self, a: __m256, b: __m256) -> __m256 { _mm256_and_ps(a, b) }
            fn any(self, m: __m256) -> bool { _mm256_movemask_ps(m) != 0 }
            fn select(self, m: __m256, a: __m256, b: __m256) -> __m256 { _mm256_blendv_ps(b, a, m) }
            fn exp2(self, a: __m256) -> __m256 {
                let magic = _mm256_set1_ps(ROUND);
                let r = _mm256_add_ps(a, magic);
                let f = _mm256_sub_ps(a, _mm256_sub_ps(r, magic));
                let mut p = _mm256_set1_ps(EXP2[0]);
                for c in &EXP2[1..] {
                    p = _mm256_fmadd_ps(p, f, _mm256_set1_ps(*c));
                }
                let p = _mm256_fmadd_ps(p, f, _mm256_set1_ps(1.0));
                let exponent = _mm256_slli_epi32::<23>(_mm256_castps_si256(r));
                _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(p), exponent))
            }
            fn sum(self, a: __m256) -> f32 {
                let h = _mm_add_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
                let h = _mm_add_ps(h, _mm_movehl_ps(h, h));
                _mm_cvtss_f32(_mm_add_ss(h, _mm_shuffle_ps::<1>(h, h)))
            }
            fn whole(self, a: __m256, to: &mut [i32]) -> () {
                _mm256_storeu_si256(to[..8].as_mut_ptr().cast(), _mm256_cvttps_epi32(a))
            }
            fn gather(self, from: &[[f32; 4]], at: &[u32]) -> [__m256; 4] {
                let at: &[u32] = &at[..8];
                // Lanes `i` and `i + 4`, in the two halves; then 4 × 4 numbers are transposed in each.
                macro_rules! pair {
                    ($i:literal) => {
                        _mm256_insertf128_ps::<1>(_mm256_castps128_ps256(four!(from, at[$i])), four!(from, at[$i + 4]))
                    };
                }
                let (a, b, c, d) = (pair!(0), pair!(1), pair!(2), pair!(3));
                let (ab, cd) = (_mm256_unpacklo_ps(a, b), _mm256_unpacklo_ps(c, d));
                let (ab2, cd2) = (_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
                [
                    _mm256_shuffle_ps::<0x44>(ab, cd),
                    _mm256_shuffle_ps::<0xee>(ab, cd),
                    _mm256_shuffle_ps::<0x44>(ab2, cd2),
                    _mm256_shuffle_ps::<0xee>(ab2, cd2),
                ]
            }
        }
    }

    /// Exists only where AVX-512 F and DQ do (and with them AVX2 and FMA).
    #[derive(Clone, Copy)]
    pub struct Avx512(());

    impl Avx512 {
        #[inline]
        pub fn detect() -> Option<Self> {
            (is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx2")
                && is_x86_feature_detected!("fma"))
            .then_some(Avx512(()))
        }
        #[inline]
        pub fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
            #[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
            fn inner<K: Kernel>(simd: Avx512, kernel: K) -> K::Output {
                kernel.run(simd)
            }
            // SAFETY: `self` proves that the processor has these.
            unsafe { inner(self, kernel) }
        }
    }

    impl Simd for Avx512 {
        const LANES: usize = 16;
        type F = __m512;
        type M = __mmask16;
        methods! {
            fn splat(self, x: f32) -> __m512 { _mm512_set1_ps(x) }
            fn load(self, from: &[f32]) -> __m512 { _mm512_loadu_ps(from[..16].as_ptr()) }
            fn store(self, value: __m512, to: &mut [f32]) -> () { _mm512_storeu_ps(to[..16].as_mut_ptr(), value) }
            fn add(self, a: __m512, b: __m512) -> __m512 { _mm512_add_ps(a, b) }
            fn sub(self, a: __m512, b: __m512) -> __m512 { _mm512_sub_ps(a, b) }
            fn mul(self, a: __m512, b: __m512) -> __m512 { _mm512_mul_ps(a, b) }
            fn div(self, a: __m512, b: __m512) -> __m512 { _mm512_div_ps(a, b) }
            fn reciprocal(self, a: __m512) -> __m512 {
                // An estimate and one Newton step: r + r (1 − a r).
                let r = _mm512_rcp14_ps(a);
                _mm512_fmadd_ps(r, _mm512_fnmadd_ps(a, r, _mm512_set1_ps(1.0)), r)
            }
            fn min(self, a: __m512, b: __m512) -> __m512 { _mm512_min_ps(a, b) }
            fn sqrt(self, a: __m512) -> __m512 { _mm512_sqrt_ps(a) }
            fn fma(self, a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fmadd_ps(a, b, c) }
            fn fnma(self, a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fnmadd_ps(a, b, c) }
            fn ge(self, a: __m512, b: __m512) -> __mmask16 { _mm512_cmp_ps_mask::<_CMP_GE_OQ>(a, b) }
            fn gt(self, a: __m512, b: __m512) -> __mmask16 { _mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b) }
            fn and(self, a: __mmask16, b: __mmask16) -> __mmask16 { a & b }
            fn any(self, m: __mmask16) -> bool { m != 0 }
            fn select(self, m: __mmask16, a: __m512, b: __m512) -> __m512 { _mm512_mask_blend_ps(m, b, a) }
            fn exp2(self, a: __m512) -> __m512 {
                let magic = _mm512_set1_ps(ROUND);
                let r = _mm512_add_ps(a, magic);
                let f = _mm512_sub_ps(a, _mm512_sub_ps(r, magic));
                let mut p = _mm512_set1_ps(EXP2[0]);
                for c in &EXP2[1..] {
                    p = _mm512_fmadd_ps(p, f, _mm512_set1_ps(*c));
                }
                let p = _mm512_fmadd_ps(p, f, _mm512_set1_ps(1.0));
                let exponent = _mm512_slli_epi32::<23>(_mm512_castps_si512(r));
                _mm512_castsi512_ps(_mm512_add_epi32(_mm512_castps_si512(p), exponent))
            }
            fn sum(self, a: __m512) -> f32 {
                let h = _mm256_add_ps(_mm512_castps512_ps256(a), _mm512_extractf32x8_ps::<1>(a));
                let h = _mm_add_ps(_mm256_castps256_ps128(h), _mm256_extractf128_ps::<1>(h));
                let h = _mm_add_ps(h, _mm_movehl_ps(h, h));
                _mm_cvtss_f32(_mm_add_ss(h, _mm_shuffle_ps::<1>(h, h)))
            }
            fn whole(self, a: __m512, to: &mut [i32]) -> () {
                _mm512_storeu_si512(to[..16].as_mut_ptr().cast(), _mm512_cvttps_epi32(a))
            }
            fn gather(self, from: &[[f32; 4]], at: &[u32]) -> [__m512; 4] {
                let at: &[u32] = &at[..16];
                // Lanes `i`, `i + 4`, `i + 8` and `i + 12`, in the four quarters; then 4 × 4 numbers are transposed in each.
                macro_rules! quad {
                    ($i:literal) => {{
                        let low = _mm512_castps128_ps512(four!(from, at[$i]));
                        let low = _mm512_insertf32x4::<1>(low, four!(from, at[$i + 4]));
                        let low = _mm512_insertf32x4::<2>(low, four!(from, at[$i + 8]));
                        _mm512_insertf32x4::<3>(low, four!(from, at[$i + 12]))
                    }};
                }
                let (a, b, c, d) = (quad!(0), quad!(1), quad!(2), quad!(3));
                let (ab, cd) = (_mm512_unpacklo_ps(a, b), _mm512_unpacklo_ps(c, d));
                let (ab2, cd2) = (_mm512_unpackhi_ps(a, b), _mm512_unpackhi_ps(c, d));
                [
                    _mm512_shuffle_ps::<0x44>(ab, cd),
                    _mm512_shuffle_ps::<0xee>(ab, cd),
                    _mm512_shuffle_ps::<0x44>(ab2, cd2),
                    _mm512_shuffle_ps::<0xee>(ab2, cd2),
                ]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Check;
    impl Kernel for Check {
        type Output = f32;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> f32 {
            let mut worst = 0f32;
            let (mut x, mut y) = ([0f32; 16], [0f32; 16]);
            for i in 0..2000 {
                x.fill(-20.0 + i as f32 * 0.0151);
                s.store(s.exp2(s.load(&x)), &mut y);
                let exact = (x[0] as f64).exp2();
                worst = worst.max((((y[0] as f64) - exact) / exact).abs() as f32);
                s.store(s.reciprocal(s.load(&y.clone())), &mut x);
                assert!((x[0] * y[0] - 1.0).abs() < 1e-6);
            }
            let ramp: [f32; 16] = std::array::from_fn(|i| i as f32);
            assert_eq!(s.sum(s.load(&ramp)), (0..S::LANES).sum::<usize>() as f32);
            let m = s.gt(s.load(&ramp), s.splat(2.5));
            s.store(s.select(m, s.splat(1.0), s.splat(0.0)), &mut y);
            assert_eq!(&y[..5], &[0.0, 0.0, 0.0, 1.0, 1.0]);
            let mut whole = [0i32; 16];
            s.whole(s.add(s.load(&ramp), s.splat(0.999)), &mut whole);
            assert!((0..S::LANES).all(|i| whole[i] == i as i32), "{whole:?}");
            let from: Vec<[f32; 4]> = (0..40).map(|i| std::array::from_fn(|k| (10 * i + k) as f32)).collect();
            let at: [u32; 16] = std::array::from_fn(|i| (7 * i as u32 + 3) % 40);
            for (k, numbers) in s.gather(&from, &at).into_iter().enumerate() {
                s.store(numbers, &mut y);
                assert!((0..S::LANES).all(|i| y[i] == (10 * at[i] as usize + k) as f32), "{k}: {y:?}");
            }
            worst
        }
    }

    #[test]
    fn every_instruction_set_agrees_with_the_library() {
        assert!(Check.run(Portable) < 2e-7);
        #[cfg(target_arch = "x86_64")]
        {
            if let Some(s) = x86::Avx2::detect() {
                assert!(s.vectorize(Check) < 2e-7);
            }
            if let Some(s) = x86::Avx512::detect() {
                assert!(s.vectorize(Check) < 2e-7);
            }
        }
        assert!(dispatch(Check) < 2e-7);
    }
}
