// Why the system refused something, in words for people.
#pragma once

#include <string>

namespace tactus::base {

/// The reason for `error_number` (errno) of a file or a disk, never empty: the system's words, and ours where those say
/// nothing: no number at all, a number that tells of our own handling (a descriptor that is closed already), and a
/// limit on the size of files. Thread: any.
std::string systemReason(int error_number);

/// Whether `error_number` says anything about a file or a disk.
bool isReason(int error_number) noexcept;

}  // namespace tactus::base
