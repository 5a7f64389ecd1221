// Self-test: 64 workgroups of 256 threads add to shared places with a compare-and-swap loop; the sums are small whole
// numbers, exact in any order. A driver whose atomics lie is caught here before it can spoil a gradient.
//
// out[k] = Σ over threads with index % 8 = k of (index % 4 + 1).

@group(0) @binding(0) var<storage, read_write> out: array<atomic<u32>, 8>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let place = id.x % 8u;
    let value = f32(id.x % 4u + 1u);
    var old = atomicLoad(&out[place]);
    // Another thread wins at most once a thread: 16,384 of them.
    for (var i = 0u; i < 1000000u; i++) {
        let next = bitcast<u32>(bitcast<f32>(old) + value);
        let result = atomicCompareExchangeWeak(&out[place], old, next);
        if (result.exchanged) {
            break;
        }
        old = result.old_value;
    }
}
