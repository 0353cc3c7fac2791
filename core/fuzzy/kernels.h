// The kernels that read a program, one set per instruction set, chosen at run time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

/// Each expert at one point, in the order of PointProgram::expert_at. Not initialised: evaluation keeps it on the
/// stack.
struct PointOutcome {
  double area[kMostExperts + kTeam];    ///< of the output set
  double offset[kMostExperts + kTeam];  ///< centroid from the lower end of the universe; any value where the area is 0
  double mean;                          ///< of the offsets, where all fire
};

/// The same source compiled for one instruction set. Every set does the same operations in the same order on each lane,
/// so all give the same bits.
struct Kernels {
  std::string_view name;  ///< sse2, avx2, avx512; or portable on other processors
  /// All experts of the model at one point, clamped here. False where an area is negligible, or an input is not finite:
  /// then the outcome is not set.
  bool (*point)(const Program& program, const double* inputs, PointOutcome& out) noexcept;
  /// The part of one chunk of experts in the mean at kBatch points, by a program made from that of the model. The first
  /// chunk sets `force_n`, which has room for kBatch forces; the others, in order, add to it. `columns` holds
  /// kMostInputs pointers: to kBatch values of any kind for each input that varies, null for the others. Returns bits
  /// of the points that must be looked at again: some expert of the chunk may not fire there, or an input is not
  /// finite.
  std::uint32_t (*batch)(const Program& model, const BatchProgram& program, const BatchChunk& chunk,
                         const double* const* columns, double* force_n) noexcept;
};

/// The sets that this processor can run, the fastest last.
std::span<const Kernels> supportedKernels() noexcept;

/// The fastest of them.
const Kernels& activeKernels() noexcept;

}  // namespace tactus::fuzzy
