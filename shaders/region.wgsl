// Shared: where Gaussians move, change their shapes and multiply. Those outside keep number, place and shape.

struct Region {
    // Low x and y, high x and y.
    sides: vec4<f32>,
    // Squared distance from the origin in x.
    ball: vec4<f32>,
}

// One that is nowhere does not keep still.
fn keeps_still(core: vec4<f32>, moving: Region) -> bool {
    let p = core.xyz;
    return dot(p, p) > moving.ball.x || any(p.xy < moving.sides.xy) || any(p.xy > moving.sides.zw);
}
