// Shared: the items of one round of density control, in the order of the next list.

// How many come of item i: first every Gaussian itself, then its children, those of the hardest pulled first.
fn offspring(i: u32, items: u32) -> vec2<u32> {
    if (i >= items) {
        return vec2(0u);
    }
    if (i < refine.gaussians) {
        return vec2(select(0u, 1u, (core[i].w >= refine.faintest || keeps_still(core[i], refine.moving)) && kinds[i] != SPLIT), i);
    }
    let id = order[i - refine.gaussians];
    let kind = kinds[id];
    return vec2(select(0u, kind, core[id].w >= refine.faintest), id | NEW | select(0u, HALF, kind == SPLIT));
}
