// Shared: which tiles an ellipse can touch (Hanson et al. 2025, "Speedy-Splat": the exact ellipse, row by row).

// Tile rows that the splat reaches inside the band: first, end.
fn tile_rows(place: vec4<f32>, view: View) -> vec2<u32> {
    // Rounding must not lose a pixel that the exact ellipse holds.
    let half = place.w + 0.01 + 1e-5 * (place.z + place.w);
    let low = f32(view.band.x);
    let high = f32(view.band.y);
    let first = clamp(floor(ceil(place.y - half - 0.5) / f32(TILE)), low, high);
    let end = clamp(floor((place.y + half - 0.5 + f32(TILE)) / f32(TILE)), low, high);
    return vec2<u32>(u32(first), u32(max(first, end)));
}

// Tiles of one row whose pixel centres the ellipse α = 1/255 can hold: first, end.
fn tile_span(place: vec4<f32>, form: vec4<f32>, row: u32, view: View) -> vec2<u32> {
    let slack = 0.01 + 1e-5 * (place.z + place.w);
    let top = max(f32(row * TILE) + 0.5 - place.y, -place.w);
    let bottom = min(f32(row * TILE + TILE - 1u) + 0.5 - place.y, place.w);
    var left = -place.z - slack;
    var right = place.z + slack;
    if (top <= bottom) {
        // The ellipse's rightmost point lies `lean` below its centre, the leftmost as far above.
        let lean = -0.5 * form.y / form.z * place.z;
        let slope = 0.5 * form.y / form.x;
        let width = max((form.w - MIN_LEVEL) / -form.x, 0.0);
        let r = clamp(lean, top, bottom);
        let l = clamp(-lean, top, bottom);
        let ur = r / place.w;
        let ul = l / place.w;
        right = min(right, sqrt(width * max(1.0 - ur * ur, 0.0)) - slope * r + slack);
        left = max(left, -sqrt(width * max(1.0 - ul * ul, 0.0)) - slope * l - slack);
    }
    let limit = f32(view.size.z);
    let first = clamp(floor(ceil(place.x + left - 0.5) / f32(TILE)), 0.0, limit);
    let end = clamp(floor((place.x + right - 0.5 + f32(TILE)) / f32(TILE)), 0.0, limit);
    return vec2<u32>(u32(first), u32(max(first, end)));
}
