// The capsule's stress, for N cells at once. Included by elastic_kernel.inl.

// Where the entry of a symmetric matrix is in an array of six: xx yy zz xy xz yz.
constexpr int kSymmetric[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

template <int N>
RESECT_INLINE Lanes<N> root(const Lanes<N>& x) {
  Lanes<N> y;
  for (int lane = 0; lane < N; ++lane) y[lane] = __builtin_sqrtf(x[lane]);
  return y;
}

template <int N>
RESECT_INLINE Lanes<N> larger(const Lanes<N>& a, const Lanes<N>& b) {
  return a > b ? a : b;
}

// Adds the capsule's second Piola-Kirchhoff stress times volume (xx yy zz xy xz yz, J) to t.
// h: F - I. The law is that of tissue/elastic/capsule.h.
template <int N>
RESECT_INLINE void stretchCapsule(const ElasticView& s, std::int32_t i, const Lanes<N>* h,
                                  Lanes<N>* t) {
  const Lanes<N> none = {}, one = all<N>(1);
  const Lanes<N> nx = load<N>(s.skinNormal[0] + i), ny = load<N>(s.skinNormal[1] + i),
                 nz = load<N>(s.skinNormal[2] + i);
  // Two tangents (Duff et al. 2017).
  const Lanes<N> sign = nz < none ? -one : one;
  const Lanes<N> a = -one / (sign + nz), b = nx * ny * a;
  const Lanes<N> t1[3] = {one + sign * nx * nx * a, sign * b, -sign * nx};
  const Lanes<N> t2[3] = {b, sign + ny * ny * a, -ny};
  Lanes<N> g1[3], g2[3];  // H times the tangents
  for (int k = 0; k < 3; ++k) {
    g1[k] = h[3 * k] * t1[0] + h[3 * k + 1] * t1[1] + h[3 * k + 2] * t1[2];
    g2[k] = h[3 * k] * t2[0] + h[3 * k + 1] * t2[1] + h[3 * k + 2] * t2[2];
  }
  // Green's strain in the tangent plane, and its principal values e1 and e2.
  const auto dot = [](const Lanes<N>* p, const Lanes<N>* q) __attribute__((always_inline)) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const Lanes<N> e11 = dot(t1, g1) + 0.5f * dot(g1, g1), e22 = dot(t2, g2) + 0.5f * dot(g2, g2);
  const Lanes<N> e12 = 0.5f * ((dot(t1, g2) + dot(t2, g1)) + dot(g1, g2));
  const Lanes<N> middle = 0.5f * (e11 + e22), half = 0.5f * (e11 - e22);
  const Lanes<N> radius = root<N>(half * half + e12 * e12);
  const Lanes<N> e1 = middle + radius, e2 = middle - radius;
  // Stretches minus 1, tensions per width at rest, both over E t.
  const Lanes<N> long1 = root<N>(larger<N>(none, one + 2.0f * e1));
  const Lanes<N> long2 = root<N>(larger<N>(none, one + 2.0f * e2));
  const Lanes<N> d1 = 2.0f * e1 / (one + long1), d2 = 2.0f * e2 / (one + long2);
  const Lanes<N> tight = load<N>(s.tightness + i), x1 = d1 + tight, x2 = d2 + tight;
  const Lanes<N> pull1 = larger<N>(none, larger<N>(x1, kBothWays * (x1 + kCapsulePoisson * x2)));
  const Lanes<N> pull2 = larger<N>(none, kBothWays * (x2 + kCapsulePoisson * x1));
  // In the basis of the tangents: S = s2 I + q (e - e2 I), with q = (s1 - s2) / (e1 - e2).
  const Lanes<N> stiffness = load<N>(s.capsule + i);
  const Lanes<N> s1 = stiffness * pull1 / (one + d1), s2 = stiffness * pull2 / (one + d2);
  const Lanes<N> q = (s1 - s2) / (2.0f * radius + all<N>(1e-12f));
  const Lanes<N> s11 = s2 + q * (e11 - e2), s22 = s2 + q * (e22 - e2), s12 = q * e12;
  for (int k = 0; k < 3; ++k)
    for (int l = k; l < 3; ++l)
      t[kSymmetric[k][l]] +=
          s11 * t1[k] * t1[l] + s22 * t2[k] * t2[l] + s12 * (t1[k] * t2[l] + t2[k] * t1[l]);
}
