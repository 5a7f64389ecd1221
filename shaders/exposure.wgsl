// Shared: how one photo's colours differ from the scene's, x' = M x + b, and Adam's memory of it.

struct Exposure {
    // A row a channel: three numbers of M, then b.
    change: array<vec4<f32>, 3>,
    first: array<vec4<f32>, 3>,
    second: array<vec4<f32>, 3>,
    // x: steps taken.
    steps: vec4<f32>,
}
