// Compiles the loops for each instruction set. A #pragma instead of compiler flags for the whole file keeps the
// standard library's inline functions on the plain instruction set, so none of them can leak into other code.
#include <algorithm>
#include <array>

#include "core/base/vector_unit.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_pass.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TACTUS_FCM_FOR_X86 1
#endif

namespace tactus::elicitation {
namespace {

// Below this, products of squared distances lose digits to underflow.
constexpr double kSmallestProduct = 1e-250;

#define TACTUS_FCM_WIDTH 2
namespace plain {
#include "elicitation/clustering/fcm_kernel_source.h"
}  // namespace plain

#ifdef TACTUS_FCM_FOR_X86
#pragma GCC push_options
#pragma GCC target("avx2")
#define TACTUS_FCM_WIDTH 4
namespace avx2 {
#include "elicitation/clustering/fcm_kernel_source.h"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#define TACTUS_FCM_WIDTH 8
namespace avx512 {
#include "elicitation/clustering/fcm_kernel_source.h"
}  // namespace avx512
#pragma GCC pop_options

constexpr std::array<FcmKernels, 3> kAll = {{{"sse2", plain::products, plain::ratios},
                                             {"avx2", avx2::products, avx2::ratios},
                                             {"avx512", avx512::products, avx512::ratios}}};
#else
constexpr std::array<FcmKernels, 1> kAll = {{{"portable", plain::products, plain::ratios}}};
#endif

}  // namespace

std::span<const FcmKernels> supportedFcmKernels() noexcept {
  static const auto widest = static_cast<std::size_t>(base::widestVectorUnit());
  return std::span(kAll).first(std::min(widest + 1, kAll.size()));
}

}  // namespace tactus::elicitation
