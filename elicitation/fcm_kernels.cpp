// Compiles the loops for each instruction set. A #pragma instead of compiler flags for the whole file keeps the
// standard library's inline functions on the plain instruction set, so none of them can leak into other code.
#include "elicitation/fcm_kernels.h"

#include <array>

#include "elicitation/fcm.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TACTUS_FCM_FOR_X86 1
#endif

namespace tactus::elicitation {
namespace {

// Below this, products of squared distances lose digits to underflow.
constexpr double kSmallestProduct = 1e-250;

#define TACTUS_FCM_WIDTH 2
namespace plain {
#include "elicitation/fcm_kernel_source.h"
}  // namespace plain

#ifdef TACTUS_FCM_FOR_X86
#pragma GCC push_options
#pragma GCC target("avx2")
#define TACTUS_FCM_WIDTH 4
namespace avx2 {
#include "elicitation/fcm_kernel_source.h"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#define TACTUS_FCM_WIDTH 8
namespace avx512 {
#include "elicitation/fcm_kernel_source.h"
}  // namespace avx512
#pragma GCC pop_options

constexpr std::array<FcmKernels, 3> kAll = {{{"sse2", plain::products, plain::ratios},
                                             {"avx2", avx2::products, avx2::ratios},
                                             {"avx512", avx512::products, avx512::ratios}}};

std::size_t countSupported() noexcept {
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return 1;
  const bool wide =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return wide ? 3 : 2;
}
#else
constexpr std::array<FcmKernels, 1> kAll = {{{"portable", plain::products, plain::ratios}}};

std::size_t countSupported() noexcept { return 1; }
#endif

}  // namespace

std::span<const FcmKernels> supportedFcmKernels() noexcept {
  static const std::size_t count = countSupported();
  return std::span(kAll).first(count);
}

}  // namespace tactus::elicitation
