// The words of forms and papers for the inputs, the output and their terms, with the ids that they mean.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

/// An id and its words. Case and spacing of words do not matter. An id is always a word for itself.
struct NamedId {
  std::string id;
  std::vector<std::string> words;  ///< lower case, single spaces
};

/// A variable with the words for itself and its terms.
struct VariableWords {
  NamedId name;
  std::vector<NamedId> terms;

  /// The id of the term called `word`; nothing if there is none.
  std::optional<std::string> term(std::string_view word) const;
};

struct AliasTable {
  std::vector<VariableWords> inputs;  ///< in the order of listed conditions
  VariableWords output;

  /// The index of the input called `word`; nothing if there is none.
  std::optional<std::size_t> input(std::string_view word) const;
};

/// Reads an alias table from the JSON `text`; `file` is its name in errors. Returns an error if a word has two
/// meanings.
base::Result<AliasTable> parseAliases(std::string_view text, const std::string& file);

/// The words of the nasogastric tube study (forms/aliases.json).
AliasTable ngtAliases();

}  // namespace tactus::questionnaires
