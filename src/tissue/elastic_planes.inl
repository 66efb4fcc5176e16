// The sums over the neighbours of a cell, plane by plane: for chunks in which every neighbour that
// is there is bonded.
//
// The nine cells across the row at x - 1, x and x + 1 contribute what depends on the plane alone,
// so each plane is summed once and read three times. Differences are taken from the cell in the
// middle of their plane, never from zero: large displacements cost no digits. In units of an edge
// neighbour's weight; a face neighbour has `faceShare`, a corner neighbour `cornerShare` of it.

constexpr int kRunChunks = 3;  // so that the sums of a run stay in the first-level cache
constexpr int kRunCells = kRunChunks * kChunk + 2 + kChunk;  // one before, one after, a vector more

// The eight cells round the middle of a plane.
enum Round { kUp, kDown, kFore, kAft, kUpFore, kUpAft, kDownFore, kDownAft };

struct PlaneSteps {
  std::int32_t to[8];
};
RESECT_INLINE PlaneSteps planeSteps(const ElasticView& s) {
  const std::int32_t y = s.step[15], z = s.step[21];  // directions (0, 1, 0) and (0, 0, 1)
  return {{y, -y, z, -z, y + z, y - z, -y + z, -y - z}};
}

// Of a plane, for each component of u: what it gives to the sums of its own middle cell (own), and
// to those of the cells before and behind in the row (next), as seen from its middle cell.
struct StrainPlanes {
  float middle[3][kRunCells];
  float own[3][3][kRunCells];  // [component of u][0: sum of w u_ij, 1: times d_y, 2: times d_z]
  float next[3][3][kRunCells];
};

RESECT_INLINE void sumStrainPlanes(const ElasticView& s, const SubstepConstants& c,
                                   const PlaneSteps& step, std::int32_t first, int begin, int end,
                                   StrainPlanes& planes) {
  const Lanes face = all(c.faceShare), corner = all(c.cornerShare);
  for (int at = begin; at < end; at += kLanes) {
    const std::int64_t p = first + at;
    std::int64_t to[8];
    for (int k = 0; k < 8; ++k) to[k] = p + step.to[k];
    IntLanes there[8];
    for (int k = 0; k < 8; ++k) there[k] = load(s.inverseMass + to[k]) > Lanes{};
    const IntLanes here = load(s.inverseMass + p) > Lanes{};
    const IntLanes before = load(s.inverseMass + p - 1) > Lanes{};
    for (int a = 0; a < 3; ++a) {
      const float* u = s.ahead[a];
      // Where no cell is, its neighbour in the row stands in.
      const Lanes own = load(u + p), left = load(u + p - 1), right = load(u + p + 1);
      const Lanes middle = here ? own : before ? left : right;
      Lanes d[8];
      for (int k = 0; k < 8; ++k) d[k] = masked(load(u + to[k]) - middle, there[k]);
      const Lanes up = d[kUpFore] + d[kUpAft], down = d[kDownFore] + d[kDownAft];
      const Lanes faces[3] = {(d[kUp] + d[kDown]) + (d[kFore] + d[kAft]), d[kUp] - d[kDown],
                              d[kFore] - d[kAft]};
      const Lanes corners[3] = {up + down, up - down,
                                (d[kUpFore] - d[kUpAft]) + (d[kDownFore] - d[kDownAft])};
      store(planes.middle[a] + at, middle);
      for (int k = 0; k < 3; ++k) {
        store(planes.own[a][k] + at, face * faces[k] + corners[k]);
        store(planes.next[a][k] + at, faces[k] + corner * corners[k]);
      }
    }
  }
}

// What the planes after and before the cells give to their k-th sum, seen from the cells
// themselves.
struct NextPlanes {
  Lanes after, before;
};
template <bool Full>
RESECT_INLINE NextPlanes nextPlanes(const ElasticView& s, const StrainPlanes& planes, int a, int k,
                                    std::int32_t i, int at) {
  NextPlanes next = {load(planes.next[a][k] + at + 1), load(planes.next[a][k] + at - 1)};
  if (Full && k > 0) return next;  // both sides of a whole plane cancel
  const float* middle = planes.middle[a] + at;
  const float* weight = s.planeWeight[k] + i;
  next.after += (load(middle + 1) - load(middle)) * load(weight + 1);
  next.before += (load(middle - 1) - load(middle)) * load(weight - 1);
  return next;
}

// Of the cells from i on, which are `at` cells into the planes. Full: all neighbours are there.
template <bool Full>
RESECT_INLINE void strainsFromPlanes(const ElasticView& s, const SubstepConstants& c,
                                     const StrainPlanes& planes, std::int32_t i, int at,
                                     Strains& strains) {
  const Lanes weight = all(c.weight[2]), perLength = all(c.weight[2] * c.inverseSpacing);
  for (int a = 0; a < 3; ++a) {
    const NextPlanes sum = nextPlanes<Full>(s, planes, a, 0, i, at);
    strains.gradient[3 * a] = perLength * (sum.after - sum.before);
    strains.difference[a] = weight * (load(planes.own[a][0] + at) + (sum.after + sum.before));
    for (int k = 1; k < 3; ++k) {
      const NextPlanes across = nextPlanes<Full>(s, planes, a, k, i, at);
      strains.gradient[3 * a + k] =
          perLength * (load(planes.own[a][k] + at) + (across.after + across.before));
    }
  }
}

// The same for A, which is zero where no cell is: row a of sum w A_j d_ij is own at the cell plus
// `after` of the plane after it and `before` of the plane before it.
struct ForcePlanes {
  float own[3][kRunCells], after[3][kRunCells], before[3][kRunCells];
};

RESECT_INLINE void sumForcePlanes(const ElasticView& s, const SubstepConstants& c,
                                  const PlaneSteps& step, std::int32_t first, int begin, int end,
                                  ForcePlanes& planes) {
  const Lanes face = all(c.faceShare), corner = all(c.cornerShare);
  const std::int64_t up = step.to[kUp], fore = step.to[kFore];
  // Row after row: the addresses of three arrays stay in registers.
  for (int a = 0; a < 3; ++a) {
    const float *x = s.stress[3 * a] + first, *y = s.stress[3 * a + 1] + first,
                *z = s.stress[3 * a + 2] + first;
    for (std::int64_t at = begin; at < end; at += kLanes) {
      const std::int64_t upper = at + up, lower = at - up;
      const Lanes faces =
          (load(x + upper) + load(x + lower)) + (load(x + at + fore) + load(x + at - fore));
      const Lanes corners = (load(x + upper + fore) + load(x + upper - fore)) +
                            (load(x + lower + fore) + load(x + lower - fore));
      const Lanes along = face * load(x + at) + faces + corner * corners;
      const Lanes facesAcross =
          (load(y + upper) - load(y + lower)) + (load(z + at + fore) - load(z + at - fore));
      const Lanes cornersAcross = ((load(y + upper + fore) + load(y + upper - fore)) -
                                   (load(y + lower + fore) + load(y + lower - fore))) +
                                  ((load(z + upper + fore) + load(z + lower + fore)) -
                                   (load(z + upper - fore) + load(z + lower - fore)));
      const Lanes across = facesAcross + corner * cornersAcross;
      store(planes.own[a] + at, face * facesAcross + cornersAcross);
      store(planes.after[a] + at, across + along);
      store(planes.before[a] + at, across - along);
    }
  }
}

RESECT_INLINE void forcesFromPlanes(const SubstepConstants& c, const ForcePlanes& planes, int at,
                                    Lanes* force) {
  for (int a = 0; a < 3; ++a)
    force[a] = all(c.weight[2]) * (load(planes.own[a] + at) + (load(planes.after[a] + at + 1) +
                                                               load(planes.before[a] + at - 1)));
}
