// The kernels that read a program, one set per instruction set, chosen at run time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

/// Area and first moment of one expert's output set, positions from the lower end of the universe.
struct Centroid {
  double area, moment;  // not initialised: evaluation keeps a thousand of them on the stack
};

/// kBatch points at once.
struct BatchOutcome {
  alignas(128) double force_n[kBatch];  ///< mean over all experts
  std::uint32_t look_again = 0;         ///< bit p: at point p some expert may not fire, or an input is not finite
};

/// The same source compiled for one instruction set. Every set does the same operations in the same order on each lane,
/// so all give the same bits.
struct Kernels {
  std::string_view name;  ///< sse2, avx2, avx512-only, avx512; or portable on other processors
  /// All experts of `program` at one point of clamped, finite inputs.
  void (*point)(const Program& program, const double* inputs, Centroid* out) noexcept;
  /// The mean at kBatch points: `columns` holds, for each varying input of the program, a pointer to kBatch values of
  /// any kind.
  void (*batch)(const Program& program, const double* const* columns, BatchOutcome& out) noexcept;
};

/// The sets that this processor can run, the fastest last.
std::span<const Kernels> supportedKernels() noexcept;

/// The fastest of them.
const Kernels& activeKernels() noexcept;

}  // namespace tactus::fuzzy
