#include "core/base/vector_unit.h"

namespace tactus::base {

VectorUnit widestVectorUnit() noexcept {
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return VectorUnit::kPlain;
  const bool wide =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return wide ? VectorUnit::kAvx512 : VectorUnit::kAvx2;
#else
  return VectorUnit::kPlain;
#endif
}

}  // namespace tactus::base
