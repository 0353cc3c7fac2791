// Names of other programs: ids of Tactus made from them, and the search for what a rule names.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

/// ASCII letters, digits and `_` of `name`, one `_` for each run of other characters inside it; at most 64 bytes.
/// `otherwise` where nothing remains. `very small` gives `very_small`, `dV*` gives `dV`.
std::string idFrom(std::string_view name, const std::string& otherwise);

/// The names of one list, found as the program of the format finds them: FCL in any case, FLL also without the
/// characters that fuzzylite drops from names. A name that is meant exactly always wins.
class ForeignNames {
 public:
  explicit ForeignNames(ImportFormat format) : format_(format) {}

  /// Adds the next name.
  void add(std::string_view name);
  /// The place of a name in the list; nothing where it is not there or could be two.
  std::optional<std::size_t> find(std::string_view name) const;
  /// The names for a message: `'low', 'high'`.
  std::string listed() const;
  /// ` ('low'?)` for the closest one.
  std::string suggestion(std::string_view name) const;

 private:
  static constexpr std::size_t kSeveral = static_cast<std::size_t>(-1);

  std::string loose(std::string_view name) const;

  ImportFormat format_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> exact_;
  std::map<std::string, std::size_t, std::less<>> loose_;
};

}  // namespace tactus::exchange
