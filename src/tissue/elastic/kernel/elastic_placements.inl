// Displacements and gradients of cells: the sums of elastic_bonds.inl over the present
// displacements. Weights are applied bond by bond, in the order of the directions.

constexpr Directions<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                     22, 23, 24, 25>
    kEveryDirection;

template <int D, int N>
RESECT_INLINE void addStretch(Lanes<N>* along, const float weight[4], const float* u,
                              const Lanes<N>& own, const std::int32_t* step,
                              const IntLanes<N>* bonded) {
  const Lanes<N> difference =
      masked(all<N>(weight[neighbourKind(D)]) * (load<N>(u + step[D]) - own), bonded[D]);
  accumulate<offsetAlong(D, 0)>(along[0], difference);
  accumulate<offsetAlong(D, 1)>(along[1], difference);
  accumulate<offsetAlong(D, 2)>(along[2], difference);
}

template <int N, int... D>
RESECT_INLINE void addStretches(Lanes<N>* along, const float weight[4], Directions<D...>,
                                const float* u, const std::int32_t* step,
                                const IntLanes<N>* bonded) {
  const Lanes<N> own = load<N>(u);
  (addStretch<D, N>(along, weight, u, own, step, bonded), ...);
}

static void placements(const ElasticView& s, const float weight[4], std::int32_t start,
                       std::uint32_t wanted, float (*out)[kChunk]) {
  for (int at = 0; at < kChunk; at += kLanes) {
    if ((wanted >> at & ((1u << kLanes) - 1)) == 0) continue;
    const std::int32_t i = start + at;
    IntLanes<kLanes> bonded[kDirections];
    spreadBonds<kLanes>(bonded, s.bonds + i);
    const InverseMoment<false, kLanes> moment(s, i);
    for (int a = 0; a < 3; ++a) {
      const float* u = s.u[a] + i;
      Lanes<kLanes> along[3] = {}, row[3];
      addStretches<kLanes>(along, weight, kEveryDirection, u, s.step, bonded);
      // This order of summation determines the recorded state hashes of scenarios.
      const Lanes<kLanes>* l = moment.l;
      row[0] = along[0] * l[0] + (along[1] * l[3] + along[2] * l[4]);
      row[1] = along[0] * l[3] + (along[1] * l[1] + along[2] * l[5]);
      row[2] = along[0] * l[4] + (along[1] * l[5] + along[2] * l[2]);
      store(out[a] + at, load<kLanes>(u));
      for (int b = 0; b < 3; ++b) store(out[3 + 3 * a + b] + at, row[b]);
    }
  }
}
