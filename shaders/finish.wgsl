// Shared: a finished pixel over the background, to the picture.

fn finish(p: Pixel, pixel: vec2<u32>) {
    if (pixel.x < view.size.x && pixel.y < view.size.y) {
        let at = pixel.y * view.size.x + pixel.x;
        let alpha = 1.0 - p.transmittance;
        picture[at] = vec4(p.color + p.transmittance * view.background.xyz, alpha);
        if (DEPTH) {
            var expected = 0.0;
            if (alpha >= MIN_ALPHA) {
                expected = p.depth.x / alpha;
            }
            depths[at] = vec2(expected, p.depth.y);
        }
    }
}
