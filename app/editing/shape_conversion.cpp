#include "app/editing/shape_conversion.h"

#include <utility>

#include "app/editing/edit_text.h"
#include "core/analysis/term_conversion.h"

namespace tactus::editing {

base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape) {
  fuzzy::ForceModel out = model;
  const auto list = openList(out, place.list);
  if (!list) return tl::unexpected(list.error());
  const auto index = findTermIn(*list, place.term);
  if (!index) return tl::unexpected(index.error());
  fuzzy::Term& term = (*list->terms)[*index];
  auto other = analysis::convertedTerm(term, shape, list->variable->min, list->variable->max);
  if (!other) return tl::unexpected(other.error());
  std::string label =
      list->title() + " / " + labelOf(term) + ": " + std::string(name(term.shape)) + " to " + std::string(name(shape));
  term = std::move(*other);
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
