//! What an HEVC stream says of its colours, in the video usability information of its sequence parameter set (ITU-T H.265, sections
//! 7.3.2.2 and E.2.1): phones write no word of it into the container around the stream.

/// By the codes of ISO/IEC 23091-2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Said {
    pub full_range: bool,
    pub primaries: u16,
    pub transfer: u16,
    pub matrix: u16,
}

impl Default for Said {
    /// What a stream means that says nothing (section E.3.1): levels 16 to 235, the rest unspecified.
    fn default() -> Self {
        Said { full_range: false, primaries: 2, transfer: 2, matrix: 2 }
    }
}

/// NAL unit type of a sequence parameter set (section 7.4.2.2).
const SEQUENCE: u8 = 33;

/// By the first sequence parameter set of these NAL units. One that breaks off, or has reference pictures predicted from each other,
/// which no still has, says nothing.
pub(super) fn said(units: &[&[u8]]) -> Said {
    let sequence = units.iter().find(|unit| unit.first().is_some_and(|head| head >> 1 & 0x3f == SEQUENCE));
    sequence.and_then(|unit| Bits::of_unit(unit).sequence()).unwrap_or_default()
}

/// The payload of a NAL unit, bit by bit. `None` past its end.
struct Bits {
    bytes: Vec<u8>,
    at: usize,
}

impl Bits {
    /// After the unit's header of two bytes, without what keeps start codes out (section 7.4.2: every 3 after two zeros).
    fn of_unit(unit: &[u8]) -> Bits {
        let mut zeros = 0;
        let kept = |byte: &u8| {
            let kept = !(zeros >= 2 && *byte == 3);
            zeros = if *byte == 0 { zeros + 1 } else { 0 };
            kept
        };
        Bits { bytes: unit.iter().skip(2).copied().filter(kept).collect(), at: 0 }
    }

    fn flag(&mut self) -> Option<bool> {
        let byte = self.bytes.get(self.at / 8)?;
        let bit = byte >> (7 - self.at % 8) & 1;
        self.at += 1;
        Some(bit == 1)
    }

    /// u(n), n ≤ 32.
    fn number(&mut self, bits: u32) -> Option<u32> {
        (0..bits).try_fold(0, |n, _| Some(n << 1 | u32::from(self.flag()?)))
    }

    /// ue(v), section 9.2; se(v) is as long.
    fn golomb(&mut self) -> Option<u32> {
        let mut zeros = 0;
        while !self.flag()? {
            zeros += 1;
        }
        (zeros < 32).then_some(())?;
        Some((1 << zeros) - 1 + self.number(zeros)?)
    }

    fn skip(&mut self, bits: usize) -> Option<()> {
        self.at = self.at.checked_add(bits)?;
        (self.at <= 8 * self.bytes.len()).then_some(())
    }

    fn golombs(&mut self, count: u32) -> Option<()> {
        (0..count).try_for_each(|_| self.golomb().map(drop))
    }

    /// Section 7.3.2.2.1, as far as the colours.
    fn sequence(&mut self) -> Option<Said> {
        self.skip(4)?;
        let sub_layers = self.number(3)?;
        self.skip(1)?;
        self.profile(sub_layers)?;
        self.golomb()?;
        if self.golomb()? == 3 {
            self.skip(1)?; // separate_colour_plane_flag
        }
        self.golombs(2)?; // Width and height.
        if self.flag()? {
            self.golombs(4)?; // conf_win offsets
        }
        self.golombs(2)?; // Bit depths.
        let order_bits = self.golomb()? as usize + 4;
        let layers = if self.flag()? { sub_layers + 1 } else { 1 };
        self.golombs(3 * layers)?;
        self.golombs(6)?; // Sizes of blocks, depths of their trees.
        if self.flag()? && self.flag()? {
            self.scaling_lists()?;
        }
        self.skip(2)?; // amp_enabled_flag, sample_adaptive_offset_enabled_flag
        if self.flag()? {
            self.skip(8)?;
            self.golombs(2)?;
            self.skip(1)?;
        }
        for i in 0..self.golomb()? {
            self.reference_pictures(i)?;
        }
        if self.flag()? {
            for _ in 0..self.golomb()? {
                self.skip(order_bits + 1)?;
            }
        }
        self.skip(2)?; // sps_temporal_mvp_enabled_flag, strong_intra_smoothing_enabled_flag
        if self.flag()? { self.usability() } else { Some(Said::default()) }
    }

    /// Section 7.3.3, with a profile.
    fn profile(&mut self, sub_layers: u32) -> Option<()> {
        self.skip(88 + 8)?;
        let present: Vec<[bool; 2]> =
            (0..sub_layers).map(|_| Some([self.flag()?, self.flag()?])).collect::<Option<_>>()?;
        if sub_layers > 0 {
            self.skip(2 * (8 - sub_layers as usize))?;
        }
        present
            .iter()
            .try_for_each(|[profile, level]| self.skip(if *profile { 88 } else { 0 } + if *level { 8 } else { 0 }))
    }

    /// Section 7.3.4.
    fn scaling_lists(&mut self) -> Option<()> {
        for size in 0..4 {
            for _ in (0..6).step_by(if size == 3 { 3 } else { 1 }) {
                if !self.flag()? {
                    self.golomb()?;
                    continue;
                }
                self.golombs(if size > 1 { 1 } else { 0 } + 64.min(1 << (4 + 2 * size)))?;
            }
        }
        Some(())
    }

    /// Section 7.3.7, where nothing is predicted.
    fn reference_pictures(&mut self, index: u32) -> Option<()> {
        if index > 0 && self.flag()? {
            return None;
        }
        let (before, after) = (self.golomb()?, self.golomb()?);
        for _ in 0..before.checked_add(after)? {
            self.golomb()?;
            self.skip(1)?;
        }
        Some(())
    }

    /// Section E.2.1, as far as the colours.
    fn usability(&mut self) -> Option<Said> {
        if self.flag()? && self.number(8)? == 255 {
            self.skip(32)?; // Aspect of a sample.
        }
        if self.flag()? {
            self.skip(1)?; // overscan_appropriate_flag
        }
        if !self.flag()? {
            return Some(Said::default());
        }
        self.skip(3)?; // video_format
        let full_range = self.flag()?;
        if !self.flag()? {
            return Some(Said { full_range, ..Said::default() });
        }
        let [primaries, transfer, matrix] = [self.number(8)?, self.number(8)?, self.number(8)?].map(|n| n as u16);
        Some(Said { full_range, primaries, transfer, matrix })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sequence parameter sets as encoders wrote them, and what they say.
    fn sets() -> Vec<(&'static str, Said)> {
        let full = |primaries, transfer, matrix| Said { full_range: true, primaries, transfer, matrix };
        vec![
            // Two phones of one maker, with a profile in the file.
            ("420101037000000300b0000003000003005aa0040200805887b91655370202060080", full(2, 2, 6)),
            ("420101037000000300b0000003000003005aa0040200805887b91655370c0d010080", full(12, 13, 1)),
            // Two of another.
            ("420101031000000300b0000003000003005aa004020080597ee4c96a560a0c0a05da1425", full(5, 6, 5)),
            ("420101016000000300000300000300000300baa00280802d1fe5f9246d9ed9", Said::default()),
            // x265.
            ("4201010370000003009000000300000300ffa0102020596ea4929ae6e04040c08000000300800000030084", full(2, 2, 6)),
            (
                "4201010408000003009db800000300005aa0040200804d96ea4929ae6e021a0c0800000300c8000003000840",
                full(1, 13, 6),
            ),
        ]
    }

    fn bytes(set: &str) -> Vec<u8> {
        hex::decode(set).unwrap()
    }

    #[test]
    fn encoders_are_understood() {
        for (set, expected) in sets() {
            assert_eq!(said(&[&[0x40, 1, 0], &bytes(set)]), expected, "{set}");
        }
        assert_eq!(said(&[]), Said::default());
    }

    #[test]
    fn what_breaks_off_or_is_damaged_says_nothing_or_something() {
        for (set, expected) in sets() {
            let whole = bytes(set);
            for length in 0..whole.len() {
                let cut = said(&[&whole[..length]]);
                assert!(cut == Said::default() || cut == expected, "{set} of {length} bytes: {cut:?}");
            }
            for at in 2..whole.len() {
                for bit in 0..8 {
                    let mut damaged = whole.clone();
                    damaged[at] ^= 1 << bit;
                    said(&[&damaged]);
                }
            }
        }
    }
}
