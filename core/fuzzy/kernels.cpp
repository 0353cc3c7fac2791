// Compiles the kernels for each instruction set and picks one. A #pragma instead of compiler flags for whole files
// keeps the standard library's inline functions on the plain instruction set, so none of them can leak into other code.
#include "core/fuzzy/kernels.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/base/vector_unit.h"
#include "core/fuzzy/instruction_set.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TACTUS_KERNELS_FOR_X86 1
#endif

namespace tactus::fuzzy {
namespace {

#define TACTUS_KERNEL_WIDTH 2
namespace plain {
#include "core/fuzzy/kernel_source.h"
}  // namespace plain

#ifdef TACTUS_KERNELS_FOR_X86
#pragma GCC push_options
#pragma GCC target("avx2")
#define TACTUS_KERNEL_WIDTH 4
namespace avx2 {
#include "core/fuzzy/kernel_source.h"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#define TACTUS_KERNEL_WIDTH 8
namespace avx512 {
#include "core/fuzzy/kernel_source.h"
}  // namespace avx512
#pragma GCC pop_options

// One point is not wide enough to gain from 512 bits (36 ns with 256, 39 ns with 512 where both were measured).
constexpr std::array<Kernels, 3> kAll = {
    {{"sse2", plain::point, plain::batch}, {"avx2", avx2::point, avx2::batch}, {"avx512", avx2::point, avx512::batch}}};
#else
constexpr std::array<Kernels, 1> kAll = {{{"portable", plain::point, plain::batch}}};
#endif

}  // namespace

std::span<const Kernels> supportedKernels() noexcept {
  static const auto widest = static_cast<std::size_t>(base::widestVectorUnit());
  return std::span(kAll).first(std::min(widest + 1, kAll.size()));
}

const Kernels& activeKernels() noexcept { return supportedKernels().back(); }

std::string_view activeInstructionSet() noexcept { return activeKernels().name; }

}  // namespace tactus::fuzzy
