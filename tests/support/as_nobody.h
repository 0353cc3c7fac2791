// File permissions do not bind the superuser, so tests of them act as another user meanwhile.
#pragma once

#include <cstdlib>
#include <unistd.h>

namespace tactus::support {

/// All threads of the process act so while this lives.
class AsNobody {
 public:
  AsNobody() {
    if (::geteuid() == 0) acts_ = ::seteuid(65534) == 0;
  }
  ~AsNobody() {
    if (acts_ && ::seteuid(0) != 0) std::abort();
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool acts_ = false;
};

}  // namespace tactus::support
