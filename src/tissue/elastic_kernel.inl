// The two passes, written once for vectors of kLanes cells. Included by one source file per
// instruction set, inside a namespace of its own, after the file has set the target; uses nothing
// from other headers that would be compiled for that target under a shared name.

#pragma GCC diagnostic ignored "-Wpsabi"

typedef float Lanes __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t IntLanes __attribute__((vector_size(4 * kLanes)));

template <int... D>
struct Directions {};
constexpr Directions<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                     22, 23, 24, 25>
    kEveryDirection;

#define RESECT_INLINE static inline __attribute__((always_inline))

RESECT_INLINE Lanes load(const float* p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
RESECT_INLINE void store(float* p, Lanes v) { __builtin_memcpy(p, &v, sizeof v); }
RESECT_INLINE Lanes all(float x) { return x - Lanes{}; }

// All ones in the lanes whose bond in direction d is there.
template <int D>
RESECT_INLINE IntLanes bonded(IntLanes bonds) {
  return (bonds << (31 - D)) >> 31;
}

// a + sign * b for a sign known when compiling.
template <int Sign>
RESECT_INLINE void accumulate(Lanes& a, Lanes b) {
  if constexpr (Sign > 0) a += b;
  if constexpr (Sign < 0) a -= b;
}

struct Gathered {
  Lanes g[9] = {};  // sum of w u_ij d_ij, row by row
  Lanes q[3] = {};  // sum of w u_ij, in the general path times the stiffness of both ends
};

template <int D, bool Full, bool Special>
RESECT_INLINE void gatherStrain(Gathered& sum, const ElasticView& s, const float* const* from,
                                const float* weights, std::int32_t i, const Lanes* own,
                                IntLanes bonds, Lanes ownKappa) {
  constexpr int o[3] = {offsetAlong(D, 0), offsetAlong(D, 1), offsetAlong(D, 2)};
  const std::int32_t j = i + s.step[D];
  Lanes weight = all(weights[neighbourKind(D)]);
  if constexpr (!Full) weight = (Lanes)((IntLanes)weight & bonded<D>(bonds));
  Lanes stiffness;
  if constexpr (Special) stiffness = ownKappa + load(s.kappa + j);
  for (int a = 0; a < 3; ++a) {
    const Lanes wu = weight * (load(from[a] + j) - own[a]);
    if constexpr (Special)
      sum.q[a] += stiffness * wu;
    else
      sum.q[a] += wu;
    accumulate<o[0]>(sum.g[3 * a + 0], wu);
    accumulate<o[1]>(sum.g[3 * a + 1], wu);
    accumulate<o[2]>(sum.g[3 * a + 2], wu);
  }
}

template <bool Full, bool Special, int... D>
RESECT_INLINE void gatherStrains(Gathered& sum, const ElasticView& s, const float* const* from,
                                 const float* weights, std::int32_t i, const Lanes* own,
                                 IntLanes bonds, Lanes ownKappa, Directions<D...>) {
  (gatherStrain<D, Full, Special>(sum, s, from, weights, i, own, bonds, ownKappa), ...);
}

template <bool Full, bool Special>
RESECT_INLINE void stressOf(const ElasticView& s, const SubstepConstants& c, std::int32_t i) {
  const float* from[3] = {s.ahead[0], s.ahead[1], s.ahead[2]};
  const Lanes own[3] = {load(from[0] + i), load(from[1] + i), load(from[2] + i)};
  IntLanes bonds;
  __builtin_memcpy(&bonds, s.bonds + i, sizeof bonds);
  const Lanes kappa = load(s.kappa + i);
  Gathered sum;
  gatherStrains<Full, Special>(sum, s, from, c.weight, i, own, bonds, kappa, kEveryDirection);

  const Lanes perLength = all(c.inverseSpacing);
  for (int a = 0; a < 3; ++a) {
    Lanes q = sum.q[a] * (perLength * perLength);
    if constexpr (!Special) q *= kappa + kappa;
    store(s.bondForce[a] + i, q);
  }

  const Lanes xx = load(s.inverseMoment[0] + i), yy = load(s.inverseMoment[1] + i),
              zz = load(s.inverseMoment[2] + i), xy = load(s.inverseMoment[3] + i),
              xz = load(s.inverseMoment[4] + i), yz = load(s.inverseMoment[5] + i);
  Lanes h[9];  // H = G L / spacing
  for (int a = 0; a < 3; ++a) {
    const Lanes gx = sum.g[3 * a] * perLength, gy = sum.g[3 * a + 1] * perLength,
                gz = sum.g[3 * a + 2] * perLength;
    h[3 * a + 0] = gx * xx + gy * xy + gz * xz;
    h[3 * a + 1] = gx * xy + gy * yy + gz * yz;
    h[3 * a + 2] = gx * xz + gy * yz + gz * zz;
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

template <int D, bool Full>
RESECT_INLINE void gatherForce(Lanes* f, const ElasticView& s, const float* weights, std::int32_t i,
                               IntLanes bonds) {
  constexpr int o[3] = {offsetAlong(D, 0), offsetAlong(D, 1), offsetAlong(D, 2)};
  const std::int32_t j = i + s.step[D];
  Lanes weight = all(weights[neighbourKind(D)]);
  if constexpr (!Full) weight = (Lanes)((IntLanes)weight & bonded<D>(bonds));
  for (int a = 0; a < 3; ++a) {
    Lanes along = {};
    if constexpr (o[0] != 0) accumulate<o[0]>(along, load(s.stress[3 * a] + j));
    if constexpr (o[1] != 0) accumulate<o[1]>(along, load(s.stress[3 * a + 1] + j));
    if constexpr (o[2] != 0) accumulate<o[2]>(along, load(s.stress[3 * a + 2] + j));
    f[a] += weight * along;
  }
}

template <bool Full, int... D>
RESECT_INLINE void gatherForces(Lanes* f, const ElasticView& s, const float* weights,
                                std::int32_t i, IntLanes bonds, Directions<D...>) {
  (gatherForce<D, Full>(f, s, weights, i, bonds), ...);
}

template <bool Full, bool Special>
RESECT_INLINE void move(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                        IntLanes& exploded) {
  IntLanes bonds;
  __builtin_memcpy(&bonds, s.bonds + i, sizeof bonds);
  Lanes f[3] = {};
  gatherForces<Full>(f, s, c.weight, i, bonds, kEveryDirection);
  const Lanes inverseMass = load(s.inverseMass + i), perLength = all(c.inverseSpacing);
  const IntLanes there = inverseMass > Lanes{};
  IntLanes held = {};
  if constexpr (Special)
    for (int lane = 0; lane < kLanes; ++lane) held[lane] = s.held[i + lane];
  const Lanes dt = all(c.dt), keep = all(c.keep), lookAhead = all(c.lookAhead);
  Lanes speed2 = {};
  for (int a = 0; a < 3; ++a) {
    Lanes force = f[a];
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

static void stressPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
  for (std::size_t n = begin; n < end; ++n) {
    const TissueChunk& chunk = s.chunks[n];
    for (int at = 0; at < kChunk; at += kLanes) {
      const std::int32_t i = chunk.start + at;
      const bool full = kLanes > 8 ? chunk.full[0] && chunk.full[1] : chunk.full[at / 8];
      if (kLanes <= 8 && chunk.empty[at / 8]) continue;
      if (chunk.special)
        stressOf<false, true>(s, c, i);
      else if (full)
        stressOf<true, false>(s, c, i);
      else
        stressOf<false, false>(s, c, i);
    }
  }
}

static bool motionPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
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
