#include "core/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace tactus::base {

void checkFailed(const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: a bug in Tactus: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace tactus::base
