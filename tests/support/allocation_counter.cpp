#include "tests/support/allocation_counter.h"

#include <cstdlib>
#include <new>

namespace {
thread_local long count = 0;
}

void* operator new(std::size_t size) {
  ++count;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
// The standard library's temporary buffers come from here and go through the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tactus::support {

long allocations() noexcept { return count; }

}  // namespace tactus::support
