// Encodes the samples of a stroke as one block of bytes.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Layout 1, all numbers little-endian:
///   4 bytes  `TREC`
///   u16      layout, 1
///   u16      number of channels
///   u32      samples per channel
///   f64      samples per second
///   for each channel: u8 length of the name, the name, u8 length of the unit, the unit (UTF-8)
///   channel after channel its samples as f64 (IEEE 754)
///   u32      CRC-32 (core/base/files/checksums.h) of all bytes before it
/// Returns an error for channels of different lengths, a number that is not finite, a rate <= 0, a name or unit of more
/// than 255 bytes, or more than 64 MiB.
base::Result<std::string> encodeRecording(const study::Recording& recording);

/// The recording in `bytes`. Returns an error if the checksum is wrong or the layout is not layout 1.
base::Result<study::Recording> decodeRecording(std::string_view bytes);

}  // namespace tactus::store
