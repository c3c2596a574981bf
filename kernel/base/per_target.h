// The namespace and attributes of code that is compiled once or, where AXISCERT_PER_TARGET is defined, once for each of
// Highway's instruction sets. There is no include guard, because the macros depend on that definition.
#undef AXISCERT_TARGET
#undef AXISCERT_BEFORE_NAMESPACE
#undef AXISCERT_AFTER_NAMESPACE
#undef AXISCERT_INLINE
#ifdef AXISCERT_PER_TARGET
#define AXISCERT_TARGET HWY_NAMESPACE
#define AXISCERT_BEFORE_NAMESPACE HWY_BEFORE_NAMESPACE
#define AXISCERT_AFTER_NAMESPACE HWY_AFTER_NAMESPACE
#else
#define AXISCERT_TARGET portable
#define AXISCERT_BEFORE_NAMESPACE() static_assert(true)
#define AXISCERT_AFTER_NAMESPACE() static_assert(true)
#endif
#ifdef __CUDACC__
#define AXISCERT_INLINE __host__ __device__ inline
#else
#define AXISCERT_INLINE [[gnu::always_inline]] inline
#endif
