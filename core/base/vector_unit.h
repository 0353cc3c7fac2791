// The vector instructions of this processor, for code that is compiled once for each set.
#pragma once

#include <cstddef>

namespace tactus::base {

/// Each set includes the previous ones.
enum class VectorUnit : std::size_t {
  kPlain,   ///< the minimum of the build's architecture; on x86-64 SSE2
  kAvx2,    ///< x86-64 with AVX2
  kAvx512,  ///< x86-64 with AVX-512 F, DQ and VL
};

/// The widest set of this processor; kPlain if it is not x86-64. Queries the processor on each call.
VectorUnit widestVectorUnit() noexcept;

}  // namespace tactus::base
