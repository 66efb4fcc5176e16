// The two passes, written once for vectors of kLanes cells. Included by one source file per
// instruction set, inside a namespace of its own, after the file has set the target; uses nothing
// from other headers that would be compiled for that target under a shared name.

#include "tissue/elastic_lanes.inl"

// What the sums over the neighbours of a cell yield.
struct Strains {
  Lanes gradient[9];    // sum of w u_ij d_ij / spacing, row by row
  Lanes difference[3];  // sum of w u_ij
};

#include "tissue/elastic_bonds.inl"
#include "tissue/elastic_planes.inl"

// L of the cells: symmetric, and a multiple of the identity where all neighbours are there.
template <bool Full>
struct InverseMoment {
  __attribute__((always_inline)) InverseMoment(const ElasticView& s, std::int32_t i) {
    for (int k = 0; k < (Full ? 1 : 6); ++k) l[k] = load(s.inverseMoment[k] + i);
  }
  __attribute__((always_inline)) void multiply(const Lanes* row, Lanes* product) const {
    if constexpr (Full) {
      for (int b = 0; b < 3; ++b) product[b] = row[b] * l[0];
    } else {
      product[0] = row[0] * l[0] + row[1] * l[3] + row[2] * l[4];
      product[1] = row[0] * l[3] + row[1] * l[1] + row[2] * l[5];
      product[2] = row[0] * l[4] + row[1] * l[5] + row[2] * l[2];
    }
  }
  Lanes l[Full ? 1 : 6];
};

// The material's answer: stress and bond force of the cells. Full: all neighbours are there, so the
// moment is that of the whole stencil.
template <bool Full>
RESECT_INLINE void respond(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                           const Strains& strains) {
  const Lanes kappa = load(s.kappa + i), perLength = all(c.inverseSpacing);
  const Lanes bondStiffness = (perLength * perLength) * (kappa + kappa);
  IntLanes there = {};
  if constexpr (!Full) there = load(s.inverseMass + i) > Lanes{};
  // Zero where no cell is: the force sums rely on it.
  const auto put = [&](float* to, const Lanes& value) {
    store(to + i, Full ? value : masked(value, there));
  };
  for (int a = 0; a < 3; ++a) put(s.bondForce[a], strains.difference[a] * bondStiffness);
  const Lanes* g = strains.gradient;
  const InverseMoment<Full> moment(s, i);
  Lanes h[9];  // H = G L
  for (int a = 0; a < 9; a += 3) moment.multiply(g + a, h + a);
  // Cofactors of H; those of F = I + H are (1 + tr H) I - H^T + cof H.
  Lanes cof[9] = {h[4] * h[8] - h[5] * h[7], h[5] * h[6] - h[3] * h[8], h[3] * h[7] - h[4] * h[6],
                  h[2] * h[7] - h[1] * h[8], h[0] * h[8] - h[2] * h[6], h[1] * h[6] - h[0] * h[7],
                  h[1] * h[5] - h[2] * h[4], h[2] * h[3] - h[0] * h[5], h[0] * h[4] - h[1] * h[3]};
  const Lanes trace = h[0] + h[4] + h[8];
  const Lanes growth = trace + (cof[0] + cof[4] + cof[8]) +
                       (h[0] * cof[0] + h[1] * cof[1] + h[2] * cof[2]);  // J - 1
  // With d = H^T - cof H: cof F = (1 + tr H) I - d and F - cof F = H + d - tr H I.
  Lanes squares = {};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      Lanes& d = cof[3 * a + b];
      d = h[3 * b + a] - d;
      const Lanes ofF = a == b ? (1.0f + trace) - d : d;
      squares += ofF * ofF;
    }
  // See kMostStiffening; without this a cut at stretch 2 explodes.
  const Lanes most = all(kMostStiffening);
  const Lanes limit = squares > most ? most / squares : all(1.0f);
  const Lanes pressure = limit * (load(s.lameVolume + i) * growth);
  const Lanes mu = load(s.shearVolume + i);
  const Lanes diagonal = pressure * (1.0f + trace) - mu * trace, both = mu - pressure;
  for (int a = 0; a < 3; ++a) {
    Lanes p[3], pl[3];
    for (int b = 0; b < 3; ++b) p[b] = mu * h[3 * a + b] + both * cof[3 * a + b];
    p[a] += diagonal;
    moment.multiply(p, pl);
    for (int b = 0; b < 3; ++b) put(s.stress[3 * a + b], pl[b] - kappa * h[3 * a + b]);
  }
}

// Speed and place after the substep; `neighbours`: sum of w A_j d_ij. Full: as above. Steered: some
// cells are held or loaded.
template <bool Full, bool Steered>
RESECT_INLINE void move(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                        const Lanes* neighbours, IntLanes& exploded) {
  const Lanes inverseMass = load(s.inverseMass + i), perLength = all(c.inverseSpacing);
  const IntLanes there = inverseMass > Lanes{};
  IntLanes held = {};
  if constexpr (Steered)
    for (int lane = 0; lane < kLanes; ++lane) held[lane] = s.held[i + lane];
  const Lanes dt = all(c.dt), keep = all(c.keep), lookAhead = all(c.lookAhead);
  Lanes speed2 = {};
  for (int a = 0; a < 3; ++a) {
    Lanes force = neighbours[a];
    if constexpr (!Full)
      for (int b = 0; b < 3; ++b) force += load(s.stress[3 * a + b] + i) * load(s.skew[b] + i);
    force = force * perLength + load(s.bondForce[a] + i);
    if constexpr (Steered) force += load(s.load[a] + i);
    const Lanes pull = force * inverseMass + all(c.gravity[a]);
    const Lanes before = load(s.v[a] + i);
    Lanes v = keep * (before + dt * pull);
    if constexpr (!Full) v = (Lanes)((IntLanes)v & there);
    if constexpr (Steered) v = (held & (1 << a)) != 0 ? before : v;
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

// Chunks that lie behind each other in memory and can be summed by planes.
struct PlaneRun {
  int chunks;          // 0 when the first cannot
  std::int32_t first;  // cell before the first
  int begin, end;  // planes that matter, from `first` on: of the solid cells and one more each way
};
static PlaneRun planeRun(const TissueChunk* chunk, const TissueChunk* end) {
  int n = 0;
  while (n < kRunChunks && chunk + n < end && chunk[n].whole &&
         chunk[n].start == chunk[0].start + n * kChunk)
    ++n;
  if (n == 0) return {0, 0, 0, 0};
  return {n, chunk[0].start - 1, chunk[0].first, (n - 1) * kChunk + chunk[n - 1].last + 3};
}

// A vector of a chunk: can it be passed over, and are all its cells solid with all their bonds?
struct Part {
  bool empty, full;
};
RESECT_INLINE Part partOf(const TissueChunk& chunk, int at) {
  const bool full = kLanes > 8 ? chunk.full[0] && chunk.full[1] : chunk.full[at / 8];
  return {chunk.last < at || chunk.first >= at + kLanes, full};
}

static void stressPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
  const NoDenormals guard;
  const PlaneSteps step = planeSteps(s);
  StrainPlanes planes = {};  // planes beyond solid cells are read, and count for nothing
  Strains strains;
  for (const TissueChunk *chunk = s.chunks + begin, *last = s.chunks + end; chunk < last;) {
    if (const PlaneRun run = planeRun(chunk, last); run.chunks > 0) {
      sumStrainPlanes(s, c, step, run.first, run.begin, run.end, planes);
      for (const TissueChunk* after = chunk + run.chunks; chunk < after; ++chunk)
        for (int at = 0; at < kChunk; at += kLanes) {
          const Part part = partOf(*chunk, at);
          const std::int32_t i = chunk->start + at;
          if (part.empty) continue;
          if (part.full) {
            strainsFromPlanes<true>(s, c, planes, i, i - run.first, strains);
            respond<true>(s, c, i, strains);
          } else {
            strainsFromPlanes<false>(s, c, planes, i, i - run.first, strains);
            respond<false>(s, c, i, strains);
          }
        }
      continue;
    }
    for (int at = 0; at < kChunk; at += kLanes) {
      const std::int32_t i = chunk->start + at;
      if (partOf(*chunk, at).empty) continue;
      strainsFromBonds(s, c, i, strains);
      respond<false>(s, c, i, strains);
    }
    ++chunk;
  }
}

static bool motionPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
  const NoDenormals guard;
  const PlaneSteps step = planeSteps(s);
  IntLanes exploded = {};
  ForcePlanes planes = {};
  Lanes force[3];
  for (const TissueChunk *chunk = s.chunks + begin, *last = s.chunks + end; chunk < last;) {
    if (const PlaneRun run = planeRun(chunk, last); run.chunks > 0) {
      sumForcePlanes(s, c, step, run.first, run.begin, run.end, planes);
      for (const TissueChunk* after = chunk + run.chunks; chunk < after; ++chunk)
        for (int at = 0; at < kChunk; at += kLanes) {
          const Part part = partOf(*chunk, at);
          const std::int32_t i = chunk->start + at;
          if (part.empty) continue;
          forcesFromPlanes(c, planes, i - run.first, force);
          if (chunk->steered)
            move<false, true>(s, c, i, force, exploded);
          else if (part.full)
            move<true, false>(s, c, i, force, exploded);
          else
            move<false, false>(s, c, i, force, exploded);
        }
      continue;
    }
    for (int at = 0; at < kChunk; at += kLanes) {
      const std::int32_t i = chunk->start + at;
      if (partOf(*chunk, at).empty) continue;
      forcesFromBonds(s, c, i, force);
      if (chunk->steered)
        move<false, true>(s, c, i, force, exploded);
      else
        move<false, false>(s, c, i, force, exploded);
    }
    ++chunk;
  }
  std::int32_t any = 0;
  for (int lane = 0; lane < kLanes; ++lane) any |= exploded[lane];
  return any == 0;
}

#include "tissue/elastic_placements.inl"

#undef RESECT_INLINE
