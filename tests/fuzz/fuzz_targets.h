// The readers of outside input as functions of bytes, for libFuzzer and for the replay of the corpus. A target stops
// the program (TACTUS_CHECK) where a reader breaks a promise; refusing the bytes is no failure.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// FLL, FCL, FIS: whatever is read gives no model or a valid one that survives its own model file.
void fuzzFll(std::string_view bytes);
void fuzzFcl(std::string_view bytes);
void fuzzFis(std::string_view bytes);
/// A model file that is read is written and read as the same model.
void fuzzModel(std::string_view bytes);
/// A manifest of a bundle that is read leads out of no folder, and is written and read as the same.
void fuzzManifest(std::string_view bytes);
/// Each cell of a table that is read has a row and a column.
void fuzzCsv(std::string_view bytes);
/// JSON that is read can be walked to its end.
void fuzzJson(std::string_view bytes);

}  // namespace tactus::fuzz
