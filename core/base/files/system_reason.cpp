// The part of file.h that every system has.
#include <cerrno>
#include <system_error>

#include "core/base/files/file.h"

namespace tactus::base {

bool isReason(int error_number) noexcept {
  switch (error_number) {
    case 0:
    case EBADF:
    case EINTR:
    case EAGAIN:
    case ENOTTY: return false;
    default: return error_number > 0;
  }
}

std::string systemReason(int error_number) {
  if (!isReason(error_number)) return "an error of which the system does not say the reason";
  if (error_number == EFBIG) return "a file larger than the limit of this session or disk (ulimit -f)";
  return std::generic_category().message(error_number);
}

}  // namespace tactus::base
