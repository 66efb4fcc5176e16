// The two passes, written once for vectors of kLanes cells. Included by one source file per
// instruction set, inside a namespace of its own, after the file has set the target; uses nothing
// from other headers that would be compiled for that target under a shared name.

#pragma GCC diagnostic ignored "-Wpsabi"

typedef float Lanes __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t IntLanes __attribute__((vector_size(4 * kLanes)));

// Neighbours of one kind have one weight: it is applied once to their sum.
template <int... D>
struct Directions {};
constexpr Directions<4, 10, 12, 13, 15, 21> kFaces;
constexpr Directions<1, 3, 5, 7, 9, 11, 14, 16, 18, 20, 22, 24> kEdges;
constexpr Directions<0, 2, 6, 8, 17, 19, 23, 25> kCorners;

#define RESECT_INLINE static inline __attribute__((always_inline))

RESECT_INLINE Lanes load(const float* p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
RESECT_INLINE void store(float* p, Lanes v) { __builtin_memcpy(p, &v, sizeof v); }
RESECT_INLINE Lanes all(float x) { return x - Lanes{}; }

// For each direction, all ones in the lanes that have that bond.
RESECT_INLINE void spreadBonds(IntLanes* bonded, const std::uint32_t* bits) {
  IntLanes bonds;
  __builtin_memcpy(&bonds, bits, sizeof bonds);
  for (int d = 0; d < kDirections; ++d) bonded[d] = (bonds << (31 - d)) >> 31;
}
RESECT_INLINE Lanes masked(Lanes value, IntLanes mask) { return (Lanes)((IntLanes)value & mask); }

// a + sign * b for a sign known when compiling.
template <int Sign>
RESECT_INLINE void accumulate(Lanes& a, Lanes b) {
  if constexpr (Sign > 0) a += b;
  if constexpr (Sign < 0) a -= b;
}

// One component of u: its gradient sum and its bond sum.
struct Gathered {
  Lanes x = {}, y = {}, z = {};  // sum of w (u_j - u_i) d_ij
  Lanes q = {};  // sum of w (u_j - u_i), in the general path times the stiffness of both ends
};

template <int D, bool Full, bool Special>
RESECT_INLINE void gatherStrain(Gathered& sum, const float* u, Lanes own, const std::int32_t* step,
                                const IntLanes* bonded, const float* kappa, Lanes ownKappa) {
  Lanes difference = load(u + step[D]) - own;
  if constexpr (!Full) difference = masked(difference, bonded[D]);
  if constexpr (Special)
    sum.q += (ownKappa + load(kappa + step[D])) * difference;
  else
    sum.q += difference;
  accumulate<offsetAlong(D, 0)>(sum.x, difference);
  accumulate<offsetAlong(D, 1)>(sum.y, difference);
  accumulate<offsetAlong(D, 2)>(sum.z, difference);
}

template <bool Full, bool Special, int... D>
RESECT_INLINE void gatherStrains(Gathered& total, float weight, Directions<D...>, const float* u,
                                 Lanes own, const std::int32_t* step, const IntLanes* bonded,
                                 const float* kappa, Lanes ownKappa) {
  Gathered sum;
  (gatherStrain<D, Full, Special>(sum, u, own, step, bonded, kappa, ownKappa), ...);
  const Lanes w = all(weight);
  total.x += w * sum.x;
  total.y += w * sum.y;
  total.z += w * sum.z;
  total.q += w * sum.q;
}

template <bool Full, bool Special>
RESECT_INLINE void stressOf(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                            Lanes& stiffest) {
  IntLanes bonded[kDirections];
  if constexpr (!Full) spreadBonds(bonded, s.bonds + i);
  const Lanes kappa = load(s.kappa + i), perLength = all(c.inverseSpacing);
  Lanes g[9];  // sum of w u_ij d_ij / spacing
  for (int a = 0; a < 3; ++a) {
    const float* u = s.ahead[a] + i;
    const Lanes own = load(u);
    Gathered sum;
    gatherStrains<Full, Special>(sum, c.weight[1], kFaces, u, own, s.step, bonded, s.kappa + i,
                                 kappa);
    gatherStrains<Full, Special>(sum, c.weight[2], kEdges, u, own, s.step, bonded, s.kappa + i,
                                 kappa);
    gatherStrains<Full, Special>(sum, c.weight[3], kCorners, u, own, s.step, bonded, s.kappa + i,
                                 kappa);
    Lanes q = sum.q * (perLength * perLength);
    if constexpr (!Special) q *= kappa + kappa;
    store(s.bondForce[a] + i, q);
    g[3 * a] = sum.x * perLength;
    g[3 * a + 1] = sum.y * perLength;
    g[3 * a + 2] = sum.z * perLength;
  }

  const Lanes xx = load(s.inverseMoment[0] + i), yy = load(s.inverseMoment[1] + i),
              zz = load(s.inverseMoment[2] + i), xy = load(s.inverseMoment[3] + i),
              xz = load(s.inverseMoment[4] + i), yz = load(s.inverseMoment[5] + i);
  Lanes h[9];  // H = G L
  for (int a = 0; a < 9; a += 3) {
    h[a + 0] = g[a] * xx + g[a + 1] * xy + g[a + 2] * xz;
    h[a + 1] = g[a] * xy + g[a + 1] * yy + g[a + 2] * yz;
    h[a + 2] = g[a] * xz + g[a + 1] * yz + g[a + 2] * zz;
  }
  // Cofactors of H; those of F = I + H are (1 + tr H) I - H^T + cof H.
  Lanes cof[9] = {h[4] * h[8] - h[5] * h[7], h[5] * h[6] - h[3] * h[8], h[3] * h[7] - h[4] * h[6],
                  h[2] * h[7] - h[1] * h[8], h[0] * h[8] - h[2] * h[6], h[1] * h[6] - h[0] * h[7],
                  h[1] * h[5] - h[2] * h[4], h[2] * h[3] - h[0] * h[5], h[0] * h[4] - h[1] * h[3]};
  const Lanes trace = h[0] + h[4] + h[8];
  const Lanes growth = trace + (cof[0] + cof[4] + cof[8]) +
                       (h[0] * cof[0] + h[1] * cof[1] + h[2] * cof[2]);  // J - 1
  Lanes shear[9];  // F - cof F = H + H^T - tr H I - cof H
  Lanes squares = {};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const int k = 3 * a + b;
      shear[k] = h[k] + h[3 * b + a] - cof[k];
      cof[k] -= h[3 * b + a];
      if (a == b) {
        shear[k] -= trace;
        cof[k] += 1.0f + trace;
      }
      squares += cof[k] * cof[k];
    }
  // A cell stretched beyond sqrt 2 in area answers to volume change less than the energy says;
  // without this a cut at stretch 2 explodes.
  const Lanes six = all(6.0f);
  const Lanes limit = squares > six ? six / squares : all(1.0f);
  for (int b = 0; b < 3; ++b) {
    const Lanes along =
        limit * (cof[b] * cof[b] + cof[3 + b] * cof[3 + b] + cof[6 + b] * cof[6 + b]);
    stiffest = along > stiffest ? along : stiffest;
  }
  const Lanes mu = load(s.shearVolume + i);
  const Lanes pressure = limit * load(s.lameVolume + i) * growth;
  for (int a = 0; a < 3; ++a) {
    const Lanes px = mu * shear[3 * a] + pressure * cof[3 * a],
                py = mu * shear[3 * a + 1] + pressure * cof[3 * a + 1],
                pz = mu * shear[3 * a + 2] + pressure * cof[3 * a + 2];
    store(s.stress[3 * a + 0] + i, px * xx + py * xy + pz * xz - kappa * h[3 * a]);
    store(s.stress[3 * a + 1] + i, px * xy + py * yy + pz * yz - kappa * h[3 * a + 1]);
    store(s.stress[3 * a + 2] + i, px * xz + py * yz + pz * zz - kappa * h[3 * a + 2]);
  }
}

// Row a of A_j d_ij, summed.
template <int D, bool Full>
RESECT_INLINE void gatherForce(Lanes& sum, const float* const* row, std::int32_t i,
                               const std::int32_t* step, const IntLanes* bonded) {
  Lanes along = {};
  if constexpr (offsetAlong(D, 0) != 0)
    accumulate<offsetAlong(D, 0)>(along, load(row[0] + i + step[D]));
  if constexpr (offsetAlong(D, 1) != 0)
    accumulate<offsetAlong(D, 1)>(along, load(row[1] + i + step[D]));
  if constexpr (offsetAlong(D, 2) != 0)
    accumulate<offsetAlong(D, 2)>(along, load(row[2] + i + step[D]));
  if constexpr (!Full) along = masked(along, bonded[D]);
  sum += along;
}

template <bool Full, int... D>
RESECT_INLINE void gatherForces(Lanes& total, float weight, Directions<D...>,
                                const float* const* row, std::int32_t i, const std::int32_t* step,
                                const IntLanes* bonded) {
  Lanes sum = {};
  (gatherForce<D, Full>(sum, row, i, step, bonded), ...);
  total += all(weight) * sum;
}

template <bool Full, bool Special>
RESECT_INLINE void move(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                        IntLanes& exploded) {
  IntLanes bonded[kDirections];
  if constexpr (!Full) spreadBonds(bonded, s.bonds + i);
  const Lanes inverseMass = load(s.inverseMass + i), perLength = all(c.inverseSpacing);
  const IntLanes there = inverseMass > Lanes{};
  IntLanes held = {};
  if constexpr (Special)
    for (int lane = 0; lane < kLanes; ++lane) held[lane] = s.held[i + lane];
  const Lanes dt = all(c.dt), keep = all(c.keep), lookAhead = all(c.lookAhead);
  Lanes speed2 = {};
  for (int a = 0; a < 3; ++a) {
    Lanes force = {};
    gatherForces<Full>(force, c.weight[1], kFaces, s.stress + 3 * a, i, s.step, bonded);
    gatherForces<Full>(force, c.weight[2], kEdges, s.stress + 3 * a, i, s.step, bonded);
    gatherForces<Full>(force, c.weight[3], kCorners, s.stress + 3 * a, i, s.step, bonded);
    if constexpr (!Full)
      for (int b = 0; b < 3; ++b) force += load(s.stress[3 * a + b] + i) * load(s.skew[b] + i);
    force = force * perLength + load(s.bondForce[a] + i);
    if constexpr (Special) force += load(s.load[a] + i);
    const Lanes pull = force * inverseMass + all(c.gravity[a]);
    const Lanes before = load(s.v[a] + i);
    Lanes v = keep * (before + dt * pull);
    if constexpr (!Full) v = (Lanes)((IntLanes)v & there);
    if constexpr (Special) v = (held & (1 << a)) != 0 ? before : v;
    const Lanes u = load(s.u[a] + i) + dt * v;
    store(s.v[a] + i, v);
    store(s.u[a] + i, u);
    store(s.ahead[a] + i, u + lookAhead * v);
    speed2 += v * v;
  }
  exploded |= ~(speed2 <= all(c.mostSpeedSquared));  // true for what is not a number too
}

// Numbers below 1e-38 count as zero while it lives: the faint front of a wave that spreads through
// tissue at rest would otherwise cost ten times the rest.
struct NoDenormals {
  NoDenormals() : before(__builtin_ia32_stmxcsr()) { __builtin_ia32_ldmxcsr(before | 0x8040u); }
  ~NoDenormals() { __builtin_ia32_ldmxcsr(before); }
  NoDenormals(const NoDenormals&) = delete;
  NoDenormals& operator=(const NoDenormals&) = delete;
  unsigned before;
};

static float stressPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                        std::size_t end) {
  const NoDenormals guard;
  Lanes stiffest = all(1.0f);
  for (std::size_t n = begin; n < end; ++n) {
    const TissueChunk& chunk = s.chunks[n];
    for (int at = 0; at < kChunk; at += kLanes) {
      const std::int32_t i = chunk.start + at;
      const bool full = kLanes > 8 ? chunk.full[0] && chunk.full[1] : chunk.full[at / 8];
      if (kLanes <= 8 && chunk.empty[at / 8]) continue;
      if (chunk.special)
        stressOf<false, true>(s, c, i, stiffest);
      else if (full)
        stressOf<true, false>(s, c, i, stiffest);
      else
        stressOf<false, false>(s, c, i, stiffest);
    }
  }
  float most = 1;
  for (int lane = 0; lane < kLanes; ++lane) most = stiffest[lane] > most ? stiffest[lane] : most;
  return most;
}

static bool motionPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
  const NoDenormals guard;
  IntLanes exploded = {};
  for (std::size_t n = begin; n < end; ++n) {
    const TissueChunk& chunk = s.chunks[n];
    for (int at = 0; at < kChunk; at += kLanes) {
      const std::int32_t i = chunk.start + at;
      const bool full = kLanes > 8 ? chunk.full[0] && chunk.full[1] : chunk.full[at / 8];
      if (kLanes <= 8 && chunk.empty[at / 8]) continue;
      if (chunk.special)
        move<false, true>(s, c, i, exploded);
      else if (full)
        move<true, false>(s, c, i, exploded);
      else
        move<false, false>(s, c, i, exploded);
    }
  }
  std::int32_t any = 0;
  for (int lane = 0; lane < kLanes; ++lane) any |= exploded[lane];
  return any == 0;
}

#undef RESECT_INLINE
