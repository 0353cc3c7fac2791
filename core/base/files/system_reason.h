// The reason of a system error, in words for the user.
#pragma once

#include <string>

namespace tactus::base {

/// The reason for `error_number` (errno) of a file or a disk, never empty. Uses the system's words. Uses our own words
/// if there is no number, if the number concerns our own handling (a closed descriptor), and for a limit on the file
/// size. Thread: any.
std::string systemReason(int error_number);

/// Whether `error_number` is a reason that concerns a file or a disk.
bool isReason(int error_number) noexcept;

}  // namespace tactus::base
