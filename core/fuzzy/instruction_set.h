// Which instruction set the evaluators use on this processor.
#pragma once

#include <string_view>

namespace tactus::fuzzy {

/// `sse2`, `avx2`, `avx512`; `portable` on processors that are not x86-64.
std::string_view activeInstructionSet() noexcept;

}  // namespace tactus::fuzzy
