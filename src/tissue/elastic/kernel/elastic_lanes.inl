// Vectors of N floats, for the files included after it in elastic_kernel.inl.

#pragma GCC diagnostic ignored "-Wpsabi"

template <int N>
struct VectorsOf {
  typedef float Floats __attribute__((vector_size(4 * N)));
  typedef std::int32_t Ints __attribute__((vector_size(4 * N)));
};
template <int N>
using Lanes = typename VectorsOf<N>::Floats;
template <int N>
using IntLanes = typename VectorsOf<N>::Ints;

#define RESECT_INLINE static inline __attribute__((always_inline))

template <int N>
RESECT_INLINE Lanes<N> load(const float* p) {
  Lanes<N> v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
template <typename V>
RESECT_INLINE void store(float* p, V v) {
  __builtin_memcpy(p, &v, sizeof v);
}
template <int N>
RESECT_INLINE Lanes<N> all(float x) {
  return x - Lanes<N>{};
}

// `value` where all bits of `mask` are set, else zero.
template <typename V, typename Mask>
RESECT_INLINE V masked(V value, Mask mask) {
  return mask ? value : V{};
}
