// Takes the codes of a participant who withdrew out of the records that stay: what others wrote, and the models.
// Private to core/store.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/store/connection.h"

namespace tactus::store {

/// The texts of a model version that may hold a code.
struct ModelTexts {
  std::string author;
  std::string label;
  std::string text;
};

/// Takes names out of texts. The outcome follows from text and names alone, in whatever order names are taken out.
class NameCleaning {
 public:
  explicit NameCleaning(std::vector<std::string> names);

  bool isEmpty() const { return names_.empty(); }
  /// The names, and how they are spelled in JSON where that differs.
  const std::vector<std::string>& names() const { return names_; }

  /// A text of a record, plain or JSON.
  std::string cleaned(std::string_view text) const;
  /// The texts of a model version without the experts of these names (model_io/expert_removal.h). A label that is about
  /// one of them keeps its first word (`edit: (withdrawn)`), for it may repeat a rule. False where nothing changed.
  bool clean(ModelTexts& version) const;

 private:
  std::vector<std::string> names_;
};

/// A column that people write into.
struct FreeText {
  std::string_view table;
  std::string_view column;
};

/// All of them but those of the models.
const std::vector<FreeText>& freeTexts();

/// Cleans all records and models of the file; model versions that change get a new SHA-256 and say so with `utc_ms`.
/// Only within a transaction in which an erasure is noted, for the guards. Returns how many model versions changed.
/// Throws as Query does.
long long cleanRecords(Connection& connection, const NameCleaning& cleaning, std::int64_t utc_ms);

/// The ids of the experts in the models of the file, each once: a code may come in with a model alone.
std::vector<std::string> expertsOfModels(Connection& connection);

}  // namespace tactus::store
