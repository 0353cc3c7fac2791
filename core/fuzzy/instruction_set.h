// The instruction set of the evaluators on this processor.
#pragma once

#include <string_view>

namespace tactus::fuzzy {

/// `sse2`, `avx2` or `avx512`; `portable` if the processor is not x86-64.
std::string_view activeInstructionSet() noexcept;

}  // namespace tactus::fuzzy
