#include "core/exchange/import/carried_variables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/exchange/import/foreign_names.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;
using base::formatNumber;
using base::quoted;

std::string rangeText(ForeignRange range) { return formatNumber(range.min) + " to " + formatNumber(range.max); }

}  // namespace

base::Result<CarriedVariable> CarriedVariable::carry(const ForeignModel& model, const ForeignVariable& variable,
                                                     bool is_output, std::size_t number,
                                                     const std::vector<bool>& used) {
  CarriedVariable out(model, variable, is_output);
  out.variable_.id = idFrom(variable.name.text, is_output ? "output" : "input_" + std::to_string(number));
  out.variable_.label = base::oneLine(variable.name.text);
  out.variable_.unit = is_output ? "N" : "1";
  if (const auto ok = out.setRange(); !ok) return tl::unexpected(ok.error());
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    if (const auto ok = out.addTerm(model, i, used[i]); !ok) return tl::unexpected(ok.error());
  }
  out.nots_.resize(variable.terms.size());
  return out;
}

base::Result<void> CarriedVariable::setRange() {
  if (from_->range) {
    range_ = *from_->range;
  } else {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    ForeignRange span{kFar, -kFar};
    for (const ForeignTerm& term : from_->terms) {
      if (const auto reach = reachOf(term)) span = {std::min(span.min, reach->min), std::max(span.max, reach->max)};
    }
    if (!(span.max - span.min > 0) || std::isinf(span.max - span.min)) {
      return source_->fail(ErrorCode::kSchema, from_->name.at, "no range of " + quoted(from_->name.text),
                           "a range, or terms that span one");
    }
    range_ = span;
    source_->warn(from_->name.at, "no range of " + quoted(from_->name.text) +
                                      " is stated; that of its terms is taken, " + rangeText(span));
  }
  variable_.min = range_.min;
  variable_.max = range_.max;
  return {};
}

base::Result<void> CarriedVariable::addTerm(const ForeignModel& model, std::size_t index, bool is_used) {
  const ForeignTerm& term = from_->terms[index];
  const std::string name = "term " + quoted(term.name.text) + " of " + quoted(from_->name.text);
  terms_.emplace_back();
  ids_.emplace_back();
  auto shape = carried(term, range_, model.format == ImportFormat::kFis, *source_);
  if (!shape) {
    if (shape.error().is_wrong || is_used) return tl::unexpected(shape.error().error);
    source_->warn(term.name.at, name + " is left out: found " + shape.error().error.found + ", wanted " +
                                    shape.error().error.wanted + "; no rule uses it");
    return {};
  }
  terms_.back() = *shape;
  if (!meets(*shape, range_)) {
    source_->warn(term.name.at, name + " lies outside the range of " + rangeText(range_) +
                                    (is_output_ ? " and is left out, with the rules that conclude it" : ""));
    if (is_output_) return {};
  }
  const std::string id = idFrom(term.name.text, "term_" + std::to_string(index + 1));
  if (hasId(id)) {
    return source_->fail(ErrorCode::kSchema, term.name.at, name + " with the id " + quoted(id) + " of an earlier term",
                         "names that differ in letters and digits");
  }
  ids_.back() = {addPart(*shape, id, base::oneLine(term.name.text))};
  return {};
}

base::Result<std::vector<std::string>> CarriedVariable::idsOf(std::size_t index, bool negated, std::size_t at) {
  if (!negated) return ids_[index];
  if (nots_[index]) return *nots_[index];
  const ForeignTerm& term = from_->terms[index];
  const auto parts = complement(*terms_[index], range_);
  if (!parts) {
    return source_->fail(ErrorCode::kValue, at, "NOT of the Gaussian " + quoted(term.name.text),
                         "NOT of a trapezoid or triangle, which two terms can carry");
  }
  const std::string label = "not " + base::oneLine(term.name.text);
  const std::string id = "not_" + idFrom(term.name.text, "term_" + std::to_string(index + 1));
  std::vector<std::string> ids;
  for (const CarriedTerm& part : *parts) {
    if (!meets(part, range_) && is_output_) continue;
    const bool is_below = part.points.front() <= range_.min && &part == &parts->front();
    const bool both = parts->size() == 2;
    ids.push_back(addPart(part, both ? id + (is_below ? "_below" : "_above") : id,
                          both ? label + (is_below ? ", below" : ", above") : label));
  }
  nots_[index] = ids;
  return ids;
}

const std::string& CarriedVariable::addPart(const CarriedTerm& part, const std::string& id, const std::string& label) {
  std::string own = id.substr(0, 60);
  for (int copy = 2; hasId(own); ++copy) own = id.substr(0, 56) + "_" + std::to_string(copy);
  variable_.terms.push_back({own, label, part.shape, part.points});
  return variable_.terms.back().id;
}

bool CarriedVariable::hasId(const std::string& id) const { return fuzzy::findTerm(variable_.terms, id) != nullptr; }

}  // namespace tactus::exchange
