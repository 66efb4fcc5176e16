// Sums over a cell's neighbours plane by plane, for chunks in which every solid neighbour is
// bonded.
//
// The contribution of the nine cells in a plane across the row depends on the plane alone, so each
// plane is summed once and used by the cells at x - 1, x and x + 1. Differences are taken relative
// to the middle cell of the plane, so that large displacements lose no digits. In units of an edge
// neighbour's weight; a face neighbour's is `faceShare`, a corner neighbour's `cornerShare` of it.

constexpr int kRunChunks = 3;  // so that the sums of a run stay in the first-level cache
constexpr int kRunCells = (kRunChunks + 2) * kChunk;  // one more chunk before and after

// The eight cells round the middle one of a plane.
enum Round { kUp, kDown, kFore, kAft, kUpFore, kUpAft, kDownFore, kDownAft };

struct PlaneSteps {
  std::int32_t to[8];
};
RESECT_INLINE PlaneSteps planeSteps(const ElasticView& s) {
  const std::int32_t y = s.step[15], z = s.step[21];  // directions (0, 1, 0) and (0, 0, 1)
  return {{y, -y, z, -z, y + z, y - z, -y + z, -y - z}};
}

// Contributions of planes, per component of u: to the sums of the plane's middle cell (own), and to
// those of the cells before and after it in the row (next), relative to the middle cell.
struct alignas(kCacheLine) StrainPlanes {
  float middle[3][kRunCells];
  float own[3][3][kRunCells];  // [component of u][0: sum of w u_ij, 1: times d_y, 2: times d_z]
  float next[3][3][kRunCells];
};

// For the N planes from `at` on; `first`: cell that has plane 0. Aims at 240 instructions.
template <int N>
RESECT_INLINE void sumStrainPlanes(const ElasticView& s, const SubstepConstants& c,
                                   const PlaneSteps& step, std::int32_t first, int at,
                                   StrainPlanes& planes) {
  const Lanes<N> face = all<N>(c.faceShare), corner = all<N>(c.cornerShare);
  const std::int64_t p = first + at;
  std::int64_t to[8];
  for (int k = 0; k < 8; ++k) to[k] = p + step.to[k];
  // Where the middle cell is missing its neighbour in the row is the reference.
  const IntLanes<N> here = load<N>(s.inverseMass + p) > Lanes<N>{};
  const IntLanes<N> before = load<N>(s.inverseMass + p - 1) > Lanes<N>{};
  Lanes<N> middles[3];
  for (int a = 0; a < 3; ++a) {
    const float* u = s.ahead[a] + p;
    const Lanes<N> own = load<N>(u), left = load<N>(u - 1), right = load<N>(u + 1);
    middles[a] = here ? own : before ? left : right;
    store(planes.middle[a] + at, middles[a]);
  }
  IntLanes<N> there[8];
  for (int k = 0; k < 8; ++k) there[k] = load<N>(s.inverseMass + to[k]) > Lanes<N>{};
  for (int a = 0; a < 3; ++a) {
    const float* u = s.ahead[a];
    const Lanes<N> middle = middles[a];
    Lanes<N> d[8];
    for (int k = 0; k < 8; ++k) d[k] = masked(load<N>(u + to[k]) - middle, there[k]);
    const Lanes<N> up = d[kUpFore] + d[kUpAft], down = d[kDownFore] + d[kDownAft];
    const Lanes<N> faces[3] = {(d[kUp] + d[kDown]) + (d[kFore] + d[kAft]), d[kUp] - d[kDown],
                               d[kFore] - d[kAft]};
    const Lanes<N> corners[3] = {up + down, up - down,
                                 (d[kUpFore] - d[kUpAft]) + (d[kDownFore] - d[kDownAft])};
    for (int k = 0; k < 3; ++k) {
      store(planes.own[a][k] + at, face * faces[k] + corners[k]);
      store(planes.next[a][k] + at, faces[k] + corner * corners[k]);
    }
  }
}

// Contribution of the planes after and before the cells to their k-th sum, relative to the cells
// themselves.
template <int N>
struct NextPlanes {
  Lanes<N> after, before;
};
template <bool Full, int N>
RESECT_INLINE NextPlanes<N> nextPlanes(const ElasticView& s, const StrainPlanes& planes, int a,
                                       int k, std::int32_t i, int at) {
  NextPlanes<N> next = {load<N>(planes.next[a][k] + at + 1), load<N>(planes.next[a][k] + at - 1)};
  if (Full && k > 0) return next;  // both sides of a whole plane cancel
  const float* middle = planes.middle[a] + at;
  const float* weight = s.planeWeight[k] + i;
  next.after += (load<N>(middle + 1) - load<N>(middle)) * load<N>(weight + 1);
  next.before += (load<N>(middle - 1) - load<N>(middle)) * load<N>(weight - 1);
  return next;
}

// For the cells from i on; `at`: their index in the planes. Full: all neighbours are bonded.
template <bool Full, int N>
RESECT_INLINE Strains<N> strainsFromPlanes(const ElasticView& s, const StrainPlanes& planes,
                                           std::int32_t i, int at) {
  Strains<N> strains;
  for (int a = 0; a < 3; ++a) {
    const NextPlanes<N> sum = nextPlanes<Full, N>(s, planes, a, 0, i, at);
    strains.gradient[3 * a] = sum.after - sum.before;
    strains.difference[a] = load<N>(planes.own[a][0] + at) + (sum.after + sum.before);
    for (int k = 1; k < 3; ++k) {
      const NextPlanes<N> across = nextPlanes<Full, N>(s, planes, a, k, i, at);
      strains.gradient[3 * a + k] = load<N>(planes.own[a][k] + at) + (across.after + across.before);
    }
  }
  return strains;
}

// The same for A, which is zero where no cell is: row a of sum w A_j d_ij is own at the cell plus
// `after` of the plane after it and `before` of the plane before it.
struct alignas(kCacheLine) ForcePlanes {
  float own[3][kRunCells], after[3][kRunCells], before[3][kRunCells];
};

// The same of forces. Aims at 180 instructions.
template <int N>
RESECT_INLINE void sumForcePlanes(const ElasticView& s, const SubstepConstants& c,
                                  const PlaneSteps& step, std::int32_t first, int at,
                                  ForcePlanes& planes) {
  const Lanes<N> face = all<N>(c.faceShare), corner = all<N>(c.cornerShare);
  const std::int64_t p = first + at;
  std::int64_t to[8];
  for (int k = 0; k < 8; ++k) to[k] = p + step.to[k];
  for (int a = 0; a < 3; ++a) {
    const float *x = s.stress[3 * a], *y = s.stress[3 * a + 1], *z = s.stress[3 * a + 2];
    const auto from = [&](const float* row, Round k) { return load<N>(row + to[k]); };
    const Lanes<N> faces = (from(x, kUp) + from(x, kDown)) + (from(x, kFore) + from(x, kAft));
    const Lanes<N> corners =
        (from(x, kUpFore) + from(x, kUpAft)) + (from(x, kDownFore) + from(x, kDownAft));
    const Lanes<N> along = face * load<N>(x + p) + faces + corner * corners;
    const Lanes<N> facesAcross = (from(y, kUp) - from(y, kDown)) + (from(z, kFore) - from(z, kAft));
    const Lanes<N> cornersAcross =
        ((from(y, kUpFore) + from(y, kUpAft)) - (from(y, kDownFore) + from(y, kDownAft))) +
        ((from(z, kUpFore) + from(z, kDownFore)) - (from(z, kUpAft) + from(z, kDownAft)));
    const Lanes<N> across = facesAcross + corner * cornersAcross;
    store(planes.own[a] + at, face * facesAcross + cornersAcross);
    store(planes.after[a] + at, across + along);
    store(planes.before[a] + at, across - along);
  }
}

template <int N>
RESECT_INLINE Forces<N> forcesFromPlanes(const ForcePlanes& planes, int at) {
  Forces<N> sum;
  for (int a = 0; a < 3; ++a)
    sum.along[a] = load<N>(planes.own[a] + at) +
                   (load<N>(planes.after[a] + at + 1) + load<N>(planes.before[a] + at - 1));
  return sum;
}
