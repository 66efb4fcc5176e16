// Vectors of kLanes floats, for the files included after it in elastic_kernel.inl.

#pragma GCC diagnostic ignored "-Wpsabi"

typedef float Lanes __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t IntLanes __attribute__((vector_size(4 * kLanes)));

#define RESECT_INLINE static inline __attribute__((always_inline))

RESECT_INLINE Lanes load(const float* p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
RESECT_INLINE void store(float* p, Lanes v) { __builtin_memcpy(p, &v, sizeof v); }
RESECT_INLINE Lanes all(float x) { return x - Lanes{}; }

RESECT_INLINE Lanes masked(Lanes value, IntLanes mask) { return (Lanes)((IntLanes)value & mask); }
