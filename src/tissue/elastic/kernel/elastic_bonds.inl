// Sums over a cell's neighbours bond by bond, for chunks with cuts or ends (elastic_planes.inl has
// the others).

// Neighbours of one kind share a weight, which is applied once to their sum.
template <int... D>
struct Directions {};
constexpr Directions<4, 10, 12, 13, 15, 21> kFaces;
constexpr Directions<1, 3, 5, 7, 9, 11, 14, 16, 18, 20, 22, 24> kEdges;
constexpr Directions<0, 2, 6, 8, 17, 19, 23, 25> kCorners;

// For each direction, all ones in the lanes that have that bond.
template <int N>
RESECT_INLINE void spreadBonds(IntLanes<N>* bonded, const std::uint32_t* bits) {
  IntLanes<N> bonds;
  __builtin_memcpy(&bonds, bits, sizeof bonds);
  for (int d = 0; d < kDirections; ++d) bonded[d] = (bonds << (31 - d)) >> 31;
}

// a + sign * b for a sign known when compiling.
template <int Sign, typename V>
RESECT_INLINE void accumulate(V& a, V b) {
  if constexpr (Sign > 0) a += b;
  if constexpr (Sign < 0) a -= b;
}

// One component of u: its gradient sum and its bond sum.
template <int N>
struct Gathered {
  Lanes<N> x = {}, y = {}, z = {};  // sum of w (u_j - u_i) d_ij
  Lanes<N> q = {};                  // sum of w (u_j - u_i)
};

template <int D, int N>
RESECT_INLINE void gatherStrain(Gathered<N>& sum, const float* u, const Lanes<N>& own,
                                const std::int32_t* step, const IntLanes<N>* bonded) {
  const Lanes<N> difference = masked(load<N>(u + step[D]) - own, bonded[D]);
  sum.q += difference;
  accumulate<offsetAlong(D, 0)>(sum.x, difference);
  accumulate<offsetAlong(D, 1)>(sum.y, difference);
  accumulate<offsetAlong(D, 2)>(sum.z, difference);
}

template <int N, int... D>
RESECT_INLINE void gatherStrains(Gathered<N>& total, float weight, Directions<D...>, const float* u,
                                 const Lanes<N>& own, const std::int32_t* step,
                                 const IntLanes<N>* bonded) {
  Gathered<N> sum;
  (gatherStrain<D, N>(sum, u, own, step, bonded), ...);
  const Lanes<N> w = all<N>(weight);
  total.x += w * sum.x;
  total.y += w * sum.y;
  total.z += w * sum.z;
  total.q += w * sum.q;
}

// Row a of A_j d_ij, summed.
template <int D, int N>
RESECT_INLINE void gatherForce(Lanes<N>& sum, const float* const* row, std::int32_t i,
                               const std::int32_t* step, const IntLanes<N>* bonded) {
  Lanes<N> along = {};
  if constexpr (offsetAlong(D, 0) != 0)
    accumulate<offsetAlong(D, 0)>(along, load<N>(row[0] + i + step[D]));
  if constexpr (offsetAlong(D, 1) != 0)
    accumulate<offsetAlong(D, 1)>(along, load<N>(row[1] + i + step[D]));
  if constexpr (offsetAlong(D, 2) != 0)
    accumulate<offsetAlong(D, 2)>(along, load<N>(row[2] + i + step[D]));
  sum += masked(along, bonded[D]);
}

template <int N, int... D>
RESECT_INLINE void gatherForces(Lanes<N>& total, float weight, Directions<D...>,
                                const float* const* row, std::int32_t i, const std::int32_t* step,
                                const IntLanes<N>* bonded) {
  Lanes<N> sum = {};
  (gatherForce<D, N>(sum, row, i, step, bonded), ...);
  total += all<N>(weight) * sum;
}

// Aims at 380 instructions for a vector: of 26 neighbours a mask, three differences and their sums.
template <int N>
RESECT_INLINE Strains<N> strainsFromBonds(const ElasticView& s, const SubstepConstants& c,
                                          std::int32_t i) {
  IntLanes<N> bonded[kDirections];
  spreadBonds<N>(bonded, s.bonds + i);
  Strains<N> strains;
  for (int a = 0; a < 3; ++a) {
    const float* u = s.ahead[a] + i;
    const Lanes<N> own = load<N>(u);
    Gathered<N> sum;
    gatherStrains<N>(sum, c.faceShare, kFaces, u, own, s.step, bonded);
    gatherStrains<N>(sum, 1, kEdges, u, own, s.step, bonded);
    gatherStrains<N>(sum, c.cornerShare, kCorners, u, own, s.step, bonded);
    strains.gradient[3 * a] = sum.x;
    strains.gradient[3 * a + 1] = sum.y;
    strains.gradient[3 * a + 2] = sum.z;
    strains.difference[a] = sum.q;
  }
  return strains;
}

// Aims at 350 instructions for a vector.
template <int N>
RESECT_INLINE Forces<N> forcesFromBonds(const ElasticView& s, const SubstepConstants& c,
                                        std::int32_t i) {
  IntLanes<N> bonded[kDirections];
  spreadBonds<N>(bonded, s.bonds + i);
  Forces<N> sum;
  for (int a = 0; a < 3; ++a) {
    sum.along[a] = Lanes<N>{};
    const float* const* row = s.stress + 3 * a;
    gatherForces<N>(sum.along[a], c.faceShare, kFaces, row, i, s.step, bonded);
    gatherForces<N>(sum.along[a], 1, kEdges, row, i, s.step, bonded);
    gatherForces<N>(sum.along[a], c.cornerShare, kCorners, row, i, s.step, bonded);
  }
  return sum;
}
