// How long a test of the window waits for what must come.
#pragma once

namespace tactus::tests {

/// In ms: a busy machine with a sanitizer may need so long. Only a test that fails waits to the end.
inline constexpr int kPatience = 180'000;

}  // namespace tactus::tests
