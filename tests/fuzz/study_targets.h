// The tables and recordings of a study as functions of bytes; see fuzz_targets.h.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// Each of the five tables of a study: what is read holds what records.h promises.
void fuzzTables(std::string_view bytes);
/// A block of samples: what is decoded is encoded as the same bytes.
void fuzzRecording(std::string_view bytes);

}  // namespace tactus::fuzz
