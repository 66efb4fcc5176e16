// The two passes, for vectors of up to kLanes cells. Included by one source file per instruction
// set, in a namespace of its own and after the file has set the target; it must not use inline
// functions of other headers, which would be compiled for that target under a shared name.
//
// Rows of an organ are short, and an empty half of sixteen lanes costs as much as a full one; so
// with sixteen lanes vectors have N = 16 or N = 8 cells.

#include "tissue/elastic/kernel/elastic_lanes.inl"

constexpr int kHalf = kLanes > 8 ? kLanes / 2 : kLanes;

// Sums over the neighbours of a cell; w in units of an edge neighbour's weight.
template <int N>
struct Strains {
  Lanes<N> gradient[9];    // sum of w u_ij d_ij, row by row, m
  Lanes<N> difference[3];  // sum of w u_ij, m
};
template <int N>
struct Forces {
  Lanes<N> along[3];  // sum of w A_j d_ij, N
};

#include "tissue/elastic/kernel/elastic_bonds.inl"
#include "tissue/elastic/kernel/elastic_planes.inl"

// L of the cells: symmetric, and a multiple of the identity if all neighbours are bonded.
template <bool Full, int N>
struct InverseMoment {
  __attribute__((always_inline)) InverseMoment(const ElasticView& s, std::int32_t i) {
    for (int k = 0; k < (Full ? 1 : 6); ++k) l[k] = load<N>(s.inverseMoment[k] + i);
  }
  __attribute__((always_inline)) void multiply(const Lanes<N>* row, Lanes<N>* product) const {
    if constexpr (Full) {
      for (int b = 0; b < 3; ++b) product[b] = row[b] * l[0];
    } else {
      product[0] = row[0] * l[0] + row[1] * l[3] + row[2] * l[4];
      product[1] = row[0] * l[3] + row[1] * l[1] + row[2] * l[5];
      product[2] = row[0] * l[4] + row[1] * l[5] + row[2] * l[2];
    }
  }
  Lanes<N> l[Full ? 1 : 6];
};

#include "tissue/elastic/kernel/elastic_capsule.inl"
#include "tissue/elastic/kernel/elastic_law.inl"

// Velocity and position after the substep. Full: as above. Steered: some cells are held or loaded.
// exploded: per lane, all bits set if the speed is beyond the limit. Aims at 80 instructions for a
// vector when all neighbours are bonded.
template <bool Full, bool Steered, int N>
RESECT_INLINE void move(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                        const Forces<N>& neighbours, std::int32_t* exploded) {
  const Lanes<N> inverseMass = load<N>(s.inverseMass + i);
  const Lanes<N> weight = load<N>(s.weight + i);
  const IntLanes<N> there = inverseMass > Lanes<N>{};
  IntLanes<N> held = {};
  if constexpr (Steered)
    for (int lane = 0; lane < N; ++lane) held[lane] = s.held[i + lane];
  const Lanes<N> dt = all<N>(c.dt), keep = all<N>(c.keep), lookAhead = all<N>(c.lookAhead);
  Lanes<N> speed2 = {};
  for (int a = 0; a < 3; ++a) {
    Lanes<N> force = neighbours.along[a];
    if constexpr (!Full)
      for (int b = 0; b < 3; ++b)
        force += load<N>(s.stress[3 * a + b] + i) * load<N>(s.skew[b] + i);
    force += load<N>(s.bondForce[a] + i);
    if constexpr (Steered) force += load<N>(s.load[a] + i);
    const Lanes<N> pull = force * inverseMass + weight * all<N>(c.gravity[a]);
    const Lanes<N> before = load<N>(s.v[a] + i);
    Lanes<N> v = keep * (before + dt * pull);
    v = masked(v, ~((v <= all<N>(kAtRest)) & (v >= all<N>(-kAtRest))));
    if constexpr (!Full) v = masked(v, there);
    if constexpr (Steered) v = (held & (1 << a)) != 0 ? before : v;
    const Lanes<N> u = load<N>(s.u[a] + i) + dt * v;
    store(s.v[a] + i, v);
    store(s.u[a] + i, u);
    store(s.ahead[a] + i, u + lookAhead * v);
    speed2 += v * v;
  }
  IntLanes<N> beyond;
  __builtin_memcpy(&beyond, exploded, sizeof beyond);
  beyond |= ~(speed2 <= all<N>(c.mostSpeedSquared));  // also true for NaN
  __builtin_memcpy(exploded, &beyond, sizeof beyond);
}

// Consecutive chunks that can be summed by planes.
struct PlaneRun {
  int chunks;          // 0 if the first one cannot
  std::int32_t first;  // index of the cell one chunk before them
  int begin, end;  // planes needed, counted from `first`: those of the solid cells and one more on
                   // each side
};
static PlaneRun planeRun(const TissueChunk* chunk, const TissueChunk* end) {
  int n = 0;
  while (n < kRunChunks && chunk + n < end && chunk[n].whole &&
         chunk[n].start == chunk[0].start + n * kChunk)
    ++n;
  if (n == 0) return {0, 0, 0, 0};
  return {n, chunk[0].start - kChunk, kChunk + chunk[0].first - 1,
          n * kChunk + chunk[n - 1].last + 2};
}

// Calls sum(at) for vectors of planes that cover [begin, end). They are aligned to their length, so
// that loads do not straddle cache lines.
template <typename Sum>
RESECT_INLINE void forPlanes(int begin, int end, Sum sum) {
  int at = begin / kHalf * kHalf;
  if (kLanes > kHalf && at % kLanes != 0) {
    sum.template operator()<kHalf>(at);
    at += kHalf;
  }
  for (; at + kHalf < end; at += kLanes) sum.template operator()<kLanes>(at);
  if (at < end) sum.template operator()<kHalf>(at);
}

// visit(at, full) for the vectors of a chunk with solid cells. full: all cells are solid with all
// their bonds.
template <typename Visit>
RESECT_INLINE void forVectors(const TissueChunk& chunk, Visit visit) {
  if (kLanes > kHalf && chunk.first < kHalf && chunk.last >= kHalf)
    return visit.template operator()<kLanes>(0, chunk.full[0] && chunk.full[1]);
  for (int at = 0; at < kChunk; at += kHalf)
    if (chunk.first < at + kHalf && chunk.last >= at)
      visit.template operator()<kHalf>(at, chunk.full[at / 8]);
}

// For a chunk with a cut. Not inlined: such chunks are few, and the loop over the others stays
// small.
template <bool Viscous, bool Relaxes>
static __attribute__((noinline)) void stressByBonds(const ElasticView& s, const SubstepConstants& c,
                                                    const TissueChunk& chunk, std::int32_t* stiff) {
  forVectors(
      chunk, [&]<int N>(int at, bool) __attribute__((always_inline)) {
        const std::int32_t i = chunk.start + at;
        respond<false, Viscous, Relaxes>(s, c, i, strainsFromBonds<N>(s, c, i), chunk.skin, stiff);
      });
}
static __attribute__((noinline)) void moveByBonds(const ElasticView& s, const SubstepConstants& c,
                                                  const TissueChunk& chunk,
                                                  std::int32_t* exploded) {
  forVectors(
      chunk, [&]<int N>(int at, bool) __attribute__((always_inline)) {
        const std::int32_t i = chunk.start + at;
        const Forces<N> force = forcesFromBonds<N>(s, c, i);
        if (chunk.steered)
          move<false, true>(s, c, i, force, exploded);
        else
          move<false, false>(s, c, i, force, exploded);
      });
}

template <bool Viscous, bool Relaxes>
static StiffCells stressOf(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                           std::size_t end) {
  const PlaneSteps step = planeSteps(s);
  StrainPlanes planes = {};  // planes beyond the solid cells are read but have no effect
  std::int32_t stiff[2 * kChunk] = {};
  for (const TissueChunk *chunk = s.chunks + begin, *last = s.chunks + end; chunk < last;) {
    const PlaneRun run = planeRun(chunk, last);
    if (run.chunks > 0) {
      forPlanes(
          run.begin, run.end, [&]<int N>(int at) __attribute__((always_inline)) {
            sumStrainPlanes<N>(s, c, step, run.first, at, planes);
          });
      for (const TissueChunk* after = chunk + run.chunks; chunk < after; ++chunk)
        forVectors(
            *chunk, [&]<int N>(int at, bool full) __attribute__((always_inline)) {
              const std::int32_t i = chunk->start + at;
              if (full)
                respond<true, Viscous, Relaxes>(
                    s, c, i, strainsFromPlanes<true, N>(s, planes, i, i - run.first), false, stiff);
              else
                respond<false, Viscous, Relaxes>(
                    s, c, i, strainsFromPlanes<false, N>(s, planes, i, i - run.first), chunk->skin,
                    stiff);
            });
      continue;
    }
    stressByBonds<Viscous, Relaxes>(s, c, *chunk++, stiff);
  }
  StiffCells count;
  for (int lane = 0; lane < kChunk; ++lane) {
    count.beyond += stiff[lane];
    count.beyondLess += stiff[kChunk + lane];
  }
  return count;
}

static StiffCells stressPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                             std::size_t end) {
  if (s.branches > 0 || s.capsule)
    return c.relaxes ? stressOf<true, true>(s, c, begin, end)
                     : stressOf<true, false>(s, c, begin, end);
  return c.relaxes ? stressOf<false, true>(s, c, begin, end)
                   : stressOf<false, false>(s, c, begin, end);
}

static bool motionPass(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                       std::size_t end) {
  const PlaneSteps step = planeSteps(s);
  std::int32_t exploded[kChunk] = {};
  ForcePlanes planes = {};
  for (const TissueChunk *chunk = s.chunks + begin, *last = s.chunks + end; chunk < last;) {
    const PlaneRun run = planeRun(chunk, last);
    if (run.chunks > 0) {
      forPlanes(
          run.begin, run.end, [&]<int N>(int at) __attribute__((always_inline)) {
            sumForcePlanes<N>(s, c, step, run.first, at, planes);
          });
      for (const TissueChunk* after = chunk + run.chunks; chunk < after; ++chunk)
        forVectors(
            *chunk, [&]<int N>(int at, bool full) __attribute__((always_inline)) {
              const std::int32_t i = chunk->start + at;
              const Forces<N> force = forcesFromPlanes<N>(planes, i - run.first);
              if (chunk->steered)
                move<false, true>(s, c, i, force, exploded);
              else if (full)
                move<true, false>(s, c, i, force, exploded);
              else
                move<false, false>(s, c, i, force, exploded);
            });
      continue;
    }
    moveByBonds(s, c, *chunk++, exploded);
  }
  std::int32_t any = 0;
  for (const std::int32_t lane : exploded) any |= lane;
  return any == 0;
}

#include "tissue/elastic/kernel/elastic_placements.inl"

#undef RESECT_INLINE
