#include "app/workbench/model/shown_impact.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/figures/force_curves.h"
#include "app/workbench/base/display_text.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

struct ImpactText {
  Q_DECLARE_TR_FUNCTIONS(ImpactText)
};

constexpr double kLastDigit = 0.001;  // of forceText

}  // namespace

QString forceChangeText(double change_n, const std::string& unit) {
  return change_n < kLastDigit / 2 ? ImpactText::tr("below %1").arg(forceText(kLastDigit, unit))
                                   : forceText(change_n, unit);
}

QString largestChangeText(double change_n, const std::string& unit, Scope scope) {
  const QString change = forceChangeText(change_n, unit);
  return scope == Scope::kAnywhere ? ImpactText::tr("max ΔF anywhere at least %1").arg(change)
                                   : ImpactText::tr("max ΔF on this curve at least %1").arg(change);
}

QString briefChangeText(double change_n, const std::string& unit, Scope scope) {
  const bool none = change_n < kLastDigit / 2;
  const QString change = none ? ImpactText::tr("ΔF < %1").arg(forceText(kLastDigit, unit))
                              : ImpactText::tr("ΔF ≥ %1").arg(forceText(change_n, unit));
  return scope == Scope::kAnywhere ? ImpactText::tr("%1 anywhere").arg(change)
                                   : ImpactText::tr("%1 on this curve").arg(change);
}

QString impactText(const editing::EditImpact& impact, const std::string& unit) {
  QStringList parts;
  // Less is rounding.
  if (impact.largest_n > 1e-12 * std::abs(impact.before_n)) {
    QString change = largestChangeText(impact.largest_n, unit, Scope::kAnywhere);
    if (unit == "N") change += ImpactText::tr(" (%1 JND)").arg(numberText(impact.noticeable, 1));
    parts << change;
  }
  if (impact.closed > 0) parts << ImpactText::tr("fills a hole");
  if (impact.opened > 0) parts << ImpactText::tr("leaves a hole");
  return parts.isEmpty() ? ImpactText::tr("no change of the force") : parts.join(QStringLiteral(" · "));
}

editing::GhostCurve curveBetween(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                 const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                 const CurveSetting& setting) {
  // The largest difference of lines that bend at vertices lies at one of them, in most cases.
  const auto before_x = figures::samplePositions(before, setting.x_input);
  const auto after_x = figures::samplePositions(after, setting.x_input);
  std::vector<double> places;
  std::set_union(before_x.begin(), before_x.end(), after_x.begin(), after_x.end(), std::back_inserter(places));
  auto compared = editing::ghostCurve(compiled_before, compiled_after, setting.x_input, setting.values, places);
  TACTUS_CHECK(compared.has_value());
  return std::move(*compared);
}

editing::EditImpact shownImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                const CurveSetting& setting) {
  editing::EditImpact impact = editing::editImpact(before, compiled_before, after, compiled_after);
  if (setting.values.size() != before.inputs.size() || setting.values.size() != after.inputs.size()) return impact;
  const auto curve = curveBetween(before, compiled_before, after, compiled_after, setting);
  editing::include(impact, curve, setting.x_input, setting.values);
  return impact;
}

}  // namespace tactus::workbench
