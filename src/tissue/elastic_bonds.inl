// The sums over the neighbours of a cell, bond by bond: for chunks with a cut or an end, where each
// cell has its own neighbours (elastic_planes.inl has the rest).

// Neighbours of one kind have one weight: it is applied once to their sum.
template <int... D>
struct Directions {};
constexpr Directions<4, 10, 12, 13, 15, 21> kFaces;
constexpr Directions<1, 3, 5, 7, 9, 11, 14, 16, 18, 20, 22, 24> kEdges;
constexpr Directions<0, 2, 6, 8, 17, 19, 23, 25> kCorners;

// For each direction, all ones in the lanes that have that bond.
RESECT_INLINE void spreadBonds(IntLanes* bonded, const std::uint32_t* bits) {
  IntLanes bonds;
  __builtin_memcpy(&bonds, bits, sizeof bonds);
  for (int d = 0; d < kDirections; ++d) bonded[d] = (bonds << (31 - d)) >> 31;
}

// a + sign * b for a sign known when compiling.
template <int Sign>
RESECT_INLINE void accumulate(Lanes& a, Lanes b) {
  if constexpr (Sign > 0) a += b;
  if constexpr (Sign < 0) a -= b;
}

// One component of u: its gradient sum and its bond sum.
struct Gathered {
  Lanes x = {}, y = {}, z = {};  // sum of w (u_j - u_i) d_ij
  Lanes q = {};                  // sum of w (u_j - u_i)
};

template <int D>
RESECT_INLINE void gatherStrain(Gathered& sum, const float* u, Lanes own, const std::int32_t* step,
                                const IntLanes* bonded) {
  const Lanes difference = masked(load(u + step[D]) - own, bonded[D]);
  sum.q += difference;
  accumulate<offsetAlong(D, 0)>(sum.x, difference);
  accumulate<offsetAlong(D, 1)>(sum.y, difference);
  accumulate<offsetAlong(D, 2)>(sum.z, difference);
}

template <int... D>
RESECT_INLINE void gatherStrains(Gathered& total, float weight, Directions<D...>, const float* u,
                                 Lanes own, const std::int32_t* step, const IntLanes* bonded) {
  Gathered sum;
  (gatherStrain<D>(sum, u, own, step, bonded), ...);
  const Lanes w = all(weight);
  total.x += w * sum.x;
  total.y += w * sum.y;
  total.z += w * sum.z;
  total.q += w * sum.q;
}

// Row a of A_j d_ij, summed.
template <int D>
RESECT_INLINE void gatherForce(Lanes& sum, const float* const* row, std::int32_t i,
                               const std::int32_t* step, const IntLanes* bonded) {
  Lanes along = {};
  if constexpr (offsetAlong(D, 0) != 0)
    accumulate<offsetAlong(D, 0)>(along, load(row[0] + i + step[D]));
  if constexpr (offsetAlong(D, 1) != 0)
    accumulate<offsetAlong(D, 1)>(along, load(row[1] + i + step[D]));
  if constexpr (offsetAlong(D, 2) != 0)
    accumulate<offsetAlong(D, 2)>(along, load(row[2] + i + step[D]));
  sum += masked(along, bonded[D]);
}

template <int... D>
RESECT_INLINE void gatherForces(Lanes& total, float weight, Directions<D...>,
                                const float* const* row, std::int32_t i, const std::int32_t* step,
                                const IntLanes* bonded) {
  Lanes sum = {};
  (gatherForce<D>(sum, row, i, step, bonded), ...);
  total += all(weight) * sum;
}

RESECT_INLINE void strainsFromBonds(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                                    Strains& strains) {
  IntLanes bonded[kDirections];
  spreadBonds(bonded, s.bonds + i);
  const Lanes perLength = all(c.inverseSpacing);
  for (int a = 0; a < 3; ++a) {
    const float* u = s.ahead[a] + i;
    const Lanes own = load(u);
    Gathered sum;
    gatherStrains(sum, c.weight[1], kFaces, u, own, s.step, bonded);
    gatherStrains(sum, c.weight[2], kEdges, u, own, s.step, bonded);
    gatherStrains(sum, c.weight[3], kCorners, u, own, s.step, bonded);
    strains.gradient[3 * a] = sum.x * perLength;
    strains.gradient[3 * a + 1] = sum.y * perLength;
    strains.gradient[3 * a + 2] = sum.z * perLength;
    strains.difference[a] = sum.q;
  }
}

RESECT_INLINE void forcesFromBonds(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                                   Lanes* force) {
  IntLanes bonded[kDirections];
  spreadBonds(bonded, s.bonds + i);
  for (int a = 0; a < 3; ++a) {
    force[a] = Lanes{};
    const float* const* row = s.stress + 3 * a;
    gatherForces(force[a], c.weight[1], kFaces, row, i, s.step, bonded);
    gatherForces(force[a], c.weight[2], kEdges, row, i, s.step, bonded);
    gatherForces(force[a], c.weight[3], kCorners, row, i, s.step, bonded);
  }
}
