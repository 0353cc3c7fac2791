#include "app/workbench/controllers/impact_text.h"

#include <QCoreApplication>

#include "app/workbench/display_text.h"

namespace tactus::workbench {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("ImpactText", text); }

}  // namespace

QString impactText(const editing::EditImpact& impact, const std::string& unit) {
  QString out = tr("no change of the force");
  if (impact.largest_n != 0) {
    out = tr("max ΔF %1").arg(forceText(impact.largest_n, unit));
    if (unit == "N") out += tr(" (%1 JND)").arg(numberText(impact.noticeable, 1));
  }
  if (impact.closed > 0) out += tr(" · fills a hole");
  if (impact.opened > 0) out += tr(" · leaves a hole");
  return out;
}

}  // namespace tactus::workbench
