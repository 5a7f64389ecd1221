// Shared: elements a workgroup of 256 threads takes on.

const RADIX_ITEMS: u32 = 8u;
const RADIX_BLOCK: u32 = 2048u;
const SCAN_ITEMS: u32 = 4u;
const SCAN_BLOCK: u32 = 1024u;
const RANGE_ITEMS: u32 = 8u;
const RANGE_BLOCK: u32 = 2048u;
