// The constitutive law of tissue/material.h, for N cells at once. Included by elastic_kernel.inl.

// Adds one to the counters of the lanes in `mask`.
template <typename Mask>
RESECT_INLINE void count(std::int32_t* counters, Mask mask) {
  Mask sum;
  __builtin_memcpy(&sum, counters, sizeof sum);
  sum -= mask;  // all bits set are -1
  __builtin_memcpy(counters, &sum, sizeof sum);
}

// Advances the Maxwell branches by c.relaxTime and gives their stress over the time that follows:
// t, the sum of modulus V times B (ElasticState::viscous). d: H^T - cof H, row by row; trace: tr H;
// growth: J - 1. A branch tends to I + B = J^(-4/3) (cof F)^T cof F, at which its stress is purely
// volumetric; the power is a quotient of linear functions, good to 2 % for J from 0.6 to 2. limit:
// of the response to volume change (kCofactorLimit); where it acts, B is made smaller as much.
template <int N>
RESECT_INLINE void relax(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                         const Lanes<N>* d, const Lanes<N>& trace, const Lanes<N>& growth,
                         const Lanes<N>& limit, Lanes<N>* t) {
  Lanes<N> k[9];  // cof F - I
  for (int a = 0; a < 9; ++a) k[a] = a % 4 == 0 ? trace - d[a] : -d[a];
  const Lanes<N> least = all<N>(-0.7f), largest = all<N>(4.0f);  // beyond, the quotient is useless
  const Lanes<N> bounded = growth > largest ? largest : growth > least ? growth : least;
  const Lanes<N> q = -1.3333333f * bounded / (1.0f + 1.1666667f * bounded);  // J^(-4/3) - 1
  Lanes<N> target[6];
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const Lanes<N> m =
          (k[3 * a + b] + k[3 * b + a]) + (k[a] * k[b] + k[3 + a] * k[3 + b] + k[6 + a] * k[6 + b]);
      target[kSymmetric[a][b]] = limit * (m + q * (a == b ? 1.0f + m : m));
    }
  for (int branch = 0; branch < s.branches; ++branch) {
    // 1 - exp(-time) to 0.1 % up to 1.
    const Lanes<N> time = c.relaxTime * load<N>(s.branchRate[branch] + i);
    const Lanes<N> share = time / (1.0f + time * (0.5f + time * 0.083333333f));
    const Lanes<N> modulus = load<N>(s.branchVolume[branch] + i);
    for (int n = 0; n < 6; ++n) {
      float* kept = s.relaxed[branch][n] + i;
      const Lanes<N> before = load<N>(kept);
      Lanes<N> after = before + share * (target[n] - before);
      // What is as small would make products with it denormal.
      after = masked(after, ~((after <= all<N>(kAtRest)) & (after >= all<N>(-kAtRest))));
      store(kept, after);
      t[n] += modulus * (0.5f * (before + after));
    }
  }
}

// The constitutive law: stress and bond force of the cells. Full: all neighbours are bonded, so the
// moment is that of the whole stencil. Aims at 250 instructions for a vector then, else 390.
// Viscous: some material has Maxwell branches or a capsule. skin: cells may carry the capsule.
// Relaxes: the branches are advanced, and the lanes whose cells are stiff are counted in `stiff`
// (StiffCells: kChunk lanes each).
template <bool Full, bool Viscous, bool Relaxes, int N>
RESECT_INLINE void respond(const ElasticView& s, const SubstepConstants& c, std::int32_t i,
                           const Strains<N>& strains, bool skin, std::int32_t* stiff) {
  const Lanes<N> kappa = load<N>(s.kappa + i);
  const Lanes<N> bondStiffness = c.bondStiffness * kappa, penalty = c.edgePerLength * kappa;
  IntLanes<N> there = {};
  if constexpr (!Full) there = load<N>(s.inverseMass + i) > Lanes<N>{};
  // Zero where no cell is: the force sums require it.
  const auto put = [&](float* to, const Lanes<N>& value) {
    store(to + i, Full ? value : masked(value, there));
  };
  for (int a = 0; a < 3; ++a) put(s.bondForce[a], strains.difference[a] * bondStiffness);
  const Lanes<N>* g = strains.gradient;
  const InverseMoment<Full, N> moment(s, i);
  Lanes<N> h[9];  // H = G L
  for (int a = 0; a < 9; a += 3) moment.multiply(g + a, h + a);
  // Cofactors of H; those of F = I + H are (1 + tr H) I - H^T + cof H.
  Lanes<N> cof[9] = {
      h[4] * h[8] - h[5] * h[7], h[5] * h[6] - h[3] * h[8], h[3] * h[7] - h[4] * h[6],
      h[2] * h[7] - h[1] * h[8], h[0] * h[8] - h[2] * h[6], h[1] * h[6] - h[0] * h[7],
      h[1] * h[5] - h[2] * h[4], h[2] * h[3] - h[0] * h[5], h[0] * h[4] - h[1] * h[3]};
  const Lanes<N> trace = h[0] + h[4] + h[8];
  const Lanes<N> bent =
      (cof[0] + cof[4] + cof[8]) + (h[0] * cof[0] + h[1] * cof[1] + h[2] * cof[2]);
  const Lanes<N> growth = trace + bent;  // J - 1
  Lanes<N> length2 = h[0] * h[0];
  for (int k = 1; k < 9; ++k) length2 += h[k] * h[k];
  const Lanes<N> x = length2 - 2.0f * bent;  // F:F - 3 - 2 (J - 1)
  // With d = H^T - cof H: cof F = (1 + tr H) I - d and F - cof F = H + d - tr H I.
  Lanes<N> squares[3];
  for (int a = 0; a < 3; ++a) {
    Lanes<N> square[3];
    for (int b = 0; b < 3; ++b) {
      Lanes<N>& d = cof[3 * a + b];
      d = h[3 * b + a] - d;
      const Lanes<N> ofF = a == b ? (1.0f + trace) - d : d;
      square[b] = ofF * ofF;
    }
    squares[a] = square[0] + square[1] + square[2];
  }
  // See kCofactorLimit; without this a cut at stretch 2 explodes.
  const Lanes<N> sum = squares[0] + squares[1] + squares[2], most = all<N>(c.cofactorLimit);
  const Lanes<N> limit = sum > most ? most / sum : all<N>(1.0f);
  if constexpr (Relaxes) {
    count(stiff, sum > most);
    count(stiff + kChunk, sum > all<N>(c.lessCofactorLimit));
  }
  const Lanes<N> pressure = limit * (load<N>(s.lameVolume + i) * growth);
  const Lanes<N> hardening = (limit * limit) * (load<N>(s.stiffening + i) * x);
  const Lanes<N> mostHarder = all<N>(kMostStiffening), none = Lanes<N>{};
  const Lanes<N> harder = hardening > mostHarder ? mostHarder : hardening > none ? hardening : none;
  Lanes<N> mu = load<N>(s.shearVolume + i) * (1.0f + harder);
  Lanes<N> t[6] = {};
  if constexpr (Viscous) {
    mu += limit * load<N>(s.viscousVolume + i);
    if constexpr (Relaxes) {
      relax<N>(s, c, i, cof, trace, growth, limit, t);
      for (int k = 0; k < 6; ++k) store(s.viscous[k] + i, t[k]);
    } else {
      for (int k = 0; k < 6; ++k) t[k] = load<N>(s.viscous[k] + i);
    }
    for (int k = 0; k < 6; ++k) t[k] *= limit;
    if constexpr (!Full)
      if (skin) stretchCapsule<N>(s, i, h, t);
  }
  const Lanes<N> diagonal = pressure * (1.0f + trace) - mu * trace, both = mu - pressure;
  for (int a = 0; a < 3; ++a) {
    Lanes<N> p[3], pl[3];
    for (int b = 0; b < 3; ++b) p[b] = mu * h[3 * a + b] + both * cof[3 * a + b];
    p[a] += diagonal;
    if constexpr (Viscous) {
      const Lanes<N>* row = h + 3 * a;  // F T
      p[0] += t[kSymmetric[a][0]] + (row[0] * t[0] + row[1] * t[3] + row[2] * t[4]);
      p[1] += t[kSymmetric[a][1]] + (row[0] * t[3] + row[1] * t[1] + row[2] * t[5]);
      p[2] += t[kSymmetric[a][2]] + (row[0] * t[4] + row[1] * t[5] + row[2] * t[2]);
    }
    moment.multiply(p, pl);
    for (int b = 0; b < 3; ++b) put(s.stress[3 * a + b], pl[b] - penalty * h[3 * a + b]);
  }
}
