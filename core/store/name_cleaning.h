// Removes the codes of a participant who withdrew from the remaining records: texts of other persons, and models.
// Private to core/store.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/store/connection.h"

namespace tactus::store {

/// The texts of a model version that may contain a code.
struct ModelTexts {
  std::string author;
  std::string label;
  std::string text;
};

/// Removes names from texts. The result depends only on text and names, not on the order of the removals.
class NameCleaning {
 public:
  explicit NameCleaning(std::vector<std::string> names);

  bool isEmpty() const { return names_.empty(); }
  /// The names, and their spelling in JSON if it differs.
  const std::vector<std::string>& names() const { return names_; }

  /// The cleaned form of a record's text, plain or JSON.
  std::string cleaned(std::string_view text) const;
  /// Removes the experts with these names from the texts of a model version (model_io/expert_removal.h). A label about
  /// one of them keeps only its first word (`edit: (withdrawn)`), because it may repeat a rule. Returns false if there
  /// was no change.
  bool clean(ModelTexts& version) const;

 private:
  std::vector<std::string> names_;
};

/// A column with text typed by users.
struct FreeText {
  std::string_view table;
  std::string_view column;
};

/// All free-text columns except those of the models.
const std::vector<FreeText>& freeTexts();

/// Cleans all records and models of the file. A changed model version gets a new SHA-256 and a note with `utc_ms`. Call
/// only inside a transaction in which an erasure is noted, because the guards require it. Returns the number of changed
/// model versions. Throws as Query does.
long long cleanRecords(Connection& connection, const NameCleaning& cleaning, std::int64_t utc_ms);

/// The ids of the experts in the file's models, without duplicates. A code may occur in a model only.
std::vector<std::string> expertsOfModels(Connection& connection);

}  // namespace tactus::store
