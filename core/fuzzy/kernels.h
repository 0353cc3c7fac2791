// The kernels: functions that evaluate a program (program.h). There is one set per instruction set, chosen at run time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

/// The outcome of each expert at one point, in the order of PointProgram::expert_at. The arrays are not initialized,
/// because evaluation keeps them on the stack.
struct PointOutcome {
  double area[kMostExperts + kTeam];    ///< of the output set
  double offset[kMostExperts + kTeam];  ///< centroid from the lower end of the universe; undefined if the area is 0
  double mean;                          ///< the weighted mean of the offsets; set only if all experts fire
};

/// One set of kernels, compiled for one instruction set. Every set does the same operations in the same order on each
/// lane, so all sets give the same bits.
struct Kernels {
  std::string_view name;  ///< sse2, avx2, avx512; portable if the processor is not x86-64
  /// Evaluates all experts of the model at one point. The kernel clamps the inputs. Returns false if an area is
  /// negligible or an input is not finite; the outcome is then undefined.
  bool (*point)(const Program& program, const double* inputs, PointOutcome& out) noexcept;
  /// Evaluates one chunk of experts at kBatch points, with the program of the model or a specialized one.
  /// `force_n`: kBatch forces. The first chunk sets them; the other chunks, called in order, add to them.
  /// `columns`: kMostInputs pointers, to kBatch values for each input that varies, null for the others.
  /// Returns one bit per point that the general path must evaluate: an expert of the chunk may not fire there, or an
  /// input is not finite.
  std::uint32_t (*batch)(const Program& model, const BatchProgram& program, const BatchChunk& chunk,
                         const double* const* columns, double* force_n) noexcept;
};

/// The sets that this processor supports, the fastest last.
std::span<const Kernels> supportedKernels() noexcept;

/// The fastest supported set.
const Kernels& activeKernels() noexcept;

}  // namespace tactus::fuzzy
