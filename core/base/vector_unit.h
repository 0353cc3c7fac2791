// Which vector instructions this processor has, for code that is compiled once for each.
#pragma once

#include <cstddef>

namespace tactus::base {

/// Each includes the ones before it.
enum class VectorUnit : std::size_t {
  kPlain,   ///< what every processor of the build's kind has; on x86-64 SSE2
  kAvx2,    ///< x86-64 with AVX2
  kAvx512,  ///< x86-64 with AVX-512 F, DQ and VL
};

/// The widest of this processor; kPlain elsewhere than on x86-64. Asks the processor each time.
VectorUnit widestVectorUnit() noexcept;

}  // namespace tactus::base
