// The penumbra of a light with a size: percentage-closer soft shadows (Fernando 2005). A search around the receiver for what
// blocks the light gives the width of the penumbra, over which the shadow map is then filtered. Lengths are radii across the
// light, at the receiver; each light's shader chooses their unit, and projects the places of its taps into its map.

// From one sample of a Vogel disc (1979) to the next: the golden angle.
const mat2 goldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// The blockers that a search has found, each with the penumbra that it leaves alone.
struct BlockerSearch {
    float weight;
    float weightPerPenumbra;
};

// `penumbra`: of a blocker at the tap, or 0 where the tap finds none. `radius`: from the middle of the search to the tap.
void addTap(inout BlockerSearch search, float penumbra, float radius) {
    // A blocker beside the light's cone does not block; it only tells of an edge that the other taps have missed.
    float within = clamp(penumbra / max(radius, 1e-6), 0.0, 1.0);
    search.weight += within * within;
    search.weightPerPenumbra += within * within / max(penumbra, 1e-6);
}

// The harmonic mean: of blockers one over the other the nearer one decides. A penumbra too wide would reach around it to where
// the light is, and light the creases of a room; one too narrow hardens the edge of the farther one.
float penumbraOf(BlockerSearch search) {
    return search.weight / search.weightPerPenumbra;
}
