// Ids for the records of tests.
#pragma once

#include <cstdint>

#include "core/study/session_records.h"

namespace tactus::experiments {

/// An id that follows from a number.
inline study::RecordId idOf(std::uint64_t number) {
  study::RecordId id;
  for (std::size_t i = 0; i < 8; ++i) id.bytes[i] = static_cast<std::uint8_t>(number >> (8 * i));
  id.bytes[15] = 1;
  return id;
}

}  // namespace tactus::experiments
