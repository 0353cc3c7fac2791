// JSON lists of pairs of texts, as columns of a study hold them. Example, the conditions of a rule:
// `[["lubrication", "well"], ["depth", "stomach"]]`.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tactus::store {

using PairList = std::vector<std::pair<std::string, std::string>>;

/// The list as JSON on one line.
std::string pairListText(const PairList& pairs);

/// Reads the JSON back. Nothing if `text` is anything but a list of pairs of texts.
std::optional<PairList> pairListIn(const std::string& text);

}  // namespace tactus::store
