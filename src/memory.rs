//! How much memory this process uses at most, stage by stage.

/// Highest resident memory since the start or the last [`reset_peak`], bytes; `None` where the system does not say.
pub fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kib| kib * 1024)
}

/// Bytes that this process could still take: what the system has free, or what its control group leaves, whichever is less;
/// `None` where the system does not say.
pub fn available() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let free = line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)?;
    // Version 2 of control groups, as containers see their own.
    let number =
        |name: &str| std::fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok()?.trim().parse::<u64>().ok();
    let left = number("memory.max").map(|most| most.saturating_sub(number("memory.current").unwrap_or(0)));
    Some(left.map_or(free, |l| l.min(free)))
}

/// Begins to measure anew, for a parent process that asks how much a run took at most (`time`) as well. False where the system does not allow it: then [`peak`] stays that of the whole process.
pub fn reset_peak() -> bool {
    // "5" resets the peak resident set size (Linux, Documentation/filesystems/proc.rst).
    std::fs::write("/proc/self/clear_refs", "5").is_ok()
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn some_memory_is_free() {
        assert!(available().unwrap() > 1 << 20);
    }

    #[test]
    fn a_large_buffer_shows_in_the_peak() {
        let before = peak().unwrap();
        let buffer = vec![1u8; 300 << 20];
        assert!(buffer.iter().map(|v| u64::from(*v)).sum::<u64>() == 300 << 20);
        assert!(peak().unwrap() > before.min(1 << 40) / 2 + (200 << 20));
    }
}
