// Counts allocations, for tests that code allocates nothing. A test program that lists allocation_counter.cpp among its
// sources has its operator new replaced.
#pragma once

namespace tactus::support {

/// How often this thread has called operator new so far.
long allocations() noexcept;

}  // namespace tactus::support
