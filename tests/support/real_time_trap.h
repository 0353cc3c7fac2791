// Catches what a servo tick must not do: allocate, lock, wait, read or write files and devices, throw. A test program
// that lists real_time_trap.cpp among its sources has these functions replaced by ones that look first whether the
// trap is armed on their thread.
#pragma once

namespace tactus::support {

/// Armed on this thread from its beginning until `disarm` or its end; not nested.
/// Under a sanitizer, which replaces the same functions itself, only allocation is caught.
class RealTimeTrap {
 public:
  RealTimeTrap() noexcept;
  ~RealTimeTrap();
  RealTimeTrap(const RealTimeTrap&) = delete;
  RealTimeTrap& operator=(const RealTimeTrap&) = delete;

  void disarm() noexcept;
  /// Forbidden calls while this trap was armed.
  int hits() const noexcept { return hits_; }
  /// The first of them, e.g. `malloc`; empty without any. Sets of synonyms have one name.
  const char* first() const noexcept { return first_; }

  /// True where calls other than allocation are caught too.
  static bool catchesEverything() noexcept;

 private:
  int hits_ = 0;
  const char* first_ = "";
};

/// How often this thread has allocated memory so far.
long allocations() noexcept;

}  // namespace tactus::support
