// A model that moves: the section of a report in which a reader moves inputs, tube and words, with the model inside.
#pragma once

#include <optional>
#include <string>

#include "core/exchange/origin.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::living {

/// With more experts a page is too large and too slow. The curves of more than 12 are drawn as a range
/// (page/panels.js).
inline constexpr std::size_t kMostExperts = 60;

/// One element of a page, written as XML. Its scripts come with a checksum and with about 2,000 points and their forces
/// by the evaluator. When the page opens it checks both and says so; without scripts it says that it is only read.
struct Section {
  std::string html;
  std::string style;  ///< for the head of the page
};

/// `compiled`: made from `model`. `simulated`: data of the model are, and the section says so. Nothing for a model with
/// more than kMostExperts experts, or with none.
std::optional<Section> sectionOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, bool simulated,
                                 const exchange::Origin& origin = {});

}  // namespace tactus::living
