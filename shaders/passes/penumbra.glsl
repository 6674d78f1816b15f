// The width of a penumbra by percentage-closer soft shadows (Fernando 2005): a search for blockers around the
// receiver gives the width over which the shadow map is then filtered. Lengths are radii at the receiver,
// across the direction to the light. The including shader chooses their unit and projects its taps into its
// map.

// Rotation by the golden angle, from one sample of a Vogel disc (1979) to the next.
const mat2 goldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// Accumulates the blockers that a search finds, with the penumbra of each.
struct BlockerSearch {
    float weight;
    float weightPerPenumbra;
};

// Adds a tap. `penumbra`: penumbra of the blocker, or 0 if there is none. `radius`: distance of the tap from
// the middle.
void addTap(inout BlockerSearch search, float penumbra, float radius) {
    // A blocker outside of the light's cone does not block. It counts less, but shows an edge that other taps
    // may miss.
    float within = clamp(penumbra / max(radius, 1e-6), 0.0, 1.0);
    search.weight += within * within;
    search.weightPerPenumbra += within * within / max(penumbra, 1e-6);
}

// The harmonic mean of the penumbrae, so that the blocker nearest to the receiver decides. A penumbra that is
// too wide leaks light into the creases of a room. One that is too narrow only hardens the edge of a farther
// blocker.
float penumbraWidth(BlockerSearch search) {
    return search.weight / search.weightPerPenumbra;
}
