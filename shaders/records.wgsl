// Shared: what the rasteriser leaves for each (tile, Gaussian) pair, sums over the tile's pixels. With g = ∂L/∂(ln α)
// and (dx, dy) = pixel − mean: Σ g, Σ g dx, Σ g dy, Σ g dx², Σ g dx dy, Σ g dy², ∂L/∂rgb.

const RECORD: u32 = 9u;
