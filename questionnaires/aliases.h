// The words that forms and papers use, and the ids of the inputs, the output and their terms that they stand for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

/// An id and the words for it. Case, and how words are spaced, make no difference; an id is always a word for itself.
struct NamedId {
  std::string id;
  std::vector<std::string> words;  ///< lower case, single spaces
};

/// A variable with the words for it and for its terms.
struct VariableWords {
  NamedId name;
  std::vector<NamedId> terms;

  /// The id of the term called `word`, or nothing.
  std::optional<std::string> term(std::string_view word) const;
};

struct AliasTable {
  std::vector<VariableWords> inputs;  ///< in the order in which conditions are listed
  VariableWords output;

  /// Index of the input called `word`, or nothing.
  std::optional<std::size_t> input(std::string_view word) const;
};

/// Reads an alias table from JSON `text`, said to be of `file` in errors. A word must mean one thing only.
base::Result<AliasTable> parseAliases(std::string_view text, const std::string& file);

/// The words of the nasogastric tube study (forms/aliases.json).
AliasTable ngtAliases();

}  // namespace tactus::questionnaires
