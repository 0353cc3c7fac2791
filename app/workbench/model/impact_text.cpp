#include "app/workbench/model/impact_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("ImpactText", text); }

}  // namespace

QString forceChangeText(double change_n, const std::string& unit) {
  constexpr double kLastDigit = 0.001;  // of forceText
  return change_n < kLastDigit / 2 ? tr("below %1").arg(forceText(kLastDigit, unit)) : forceText(change_n, unit);
}

QString impactText(const editing::EditImpact& impact, const std::string& unit) {
  QStringList parts;
  // Less is rounding.
  if (impact.largest_n > 1e-12 * std::abs(impact.before_n)) {
    QString change = tr("max ΔF at least %1").arg(forceChangeText(impact.largest_n, unit));
    if (unit == "N") change += tr(" (%1 JND)").arg(numberText(impact.noticeable, 1));
    parts << change;
  }
  if (impact.closed > 0) parts << tr("fills a hole");
  if (impact.opened > 0) parts << tr("leaves a hole");
  return parts.isEmpty() ? tr("no change of the force") : parts.join(QStringLiteral(" · "));
}

}  // namespace tactus::workbench
