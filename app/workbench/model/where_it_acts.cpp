#include "app/workbench/model/where_it_acts.h"

#include <QStringList>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "core/analysis/rule_table.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

double nearestPeak(const fuzzy::Term& term, const fuzzy::Variable& input, double from) {
  const auto function = fuzzy::MembershipFunction::of(term);
  const double low = std::max(function.gaussian ? function.mean : function.b, input.min);
  const double high = std::min(function.gaussian ? function.mean : function.c, input.max);
  // A core outside the universe leaves the end next to it.
  return low <= high ? std::clamp(from, low, high) : analysis::peakPosition(term, input.min, input.max);
}

}  // namespace

std::vector<double> pointOfRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                                std::span<const double> from) {
  std::vector<double> point(from.begin(), from.end());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Variable& input = model.inputs[i];
    for (const fuzzy::Condition& condition : rule.conditions) {
      if (condition.input != input.id) continue;
      const fuzzy::Term* const term = fuzzy::findTerm(fuzzy::termsFor(expert, input), condition.term);
      if (term != nullptr) point[i] = nearestPeak(*term, input, from[i]);
    }
  }
  return point;
}

QString rangesOutside(const fuzzy::ForceModel& model, const std::vector<analysis::InputRange>& region,
                      std::span<const double> values, std::size_t but) {
  QStringList out;
  for (std::size_t i = 0; i < region.size(); ++i) {
    if (i == but || (values[i] >= region[i].low && values[i] <= region[i].high)) continue;
    const fuzzy::Variable& input = model.inputs[i];
    out << labelOf(input) + QLatin1Char(' ') + rangeText(input, region[i].low, region[i].high);
  }
  return out.join(QStringLiteral(", "));
}

}  // namespace tactus::workbench
