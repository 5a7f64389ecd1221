// Shared: SplitMix64 (Steele et al. 2014) as a hash, the same numbers as on the CPU. 64 bits are (low, high).

fn product(a: u32, b: u32) -> vec2<u32> {
    let p = (a & 0xffffu) * (b & 0xffffu);
    let q = (a & 0xffffu) * (b >> 16u);
    let r = (a >> 16u) * (b & 0xffffu);
    let middle = (p >> 16u) + (q & 0xffffu) + (r & 0xffffu);
    return vec2((middle << 16u) | (p & 0xffffu), (a >> 16u) * (b >> 16u) + (q >> 16u) + (r >> 16u) + (middle >> 16u));
}

fn times(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let p = product(a.x, b.x);
    return vec2(p.x, p.y + a.x * b.y + a.y * b.x);
}

// a ^ (a >> by), 0 < by < 32.
fn fold(a: vec2<u32>, by: u32) -> vec2<u32> {
    return vec2(a.x ^ ((a.x >> by) | (a.y << (32u - by))), a.y ^ (a.y >> by));
}

fn hash(x: vec2<u32>) -> vec2<u32> {
    let low = x.x + 0x7f4a7c15u;
    var z = vec2(low, x.y + 0x9e3779b9u + select(0u, 1u, low < x.x));
    z = times(fold(z, 30u), vec2(0x1ce4e5b9u, 0xbf58476du));
    z = times(fold(z, 27u), vec2(0x133111ebu, 0x94d049bbu));
    return fold(z, 31u);
}
