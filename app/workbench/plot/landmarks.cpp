#include "app/workbench/plot/landmarks.h"

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/shown_procedure.h"

namespace tactus::workbench {

std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable) {
  const ProcedurePtr& about = shownProcedure();
  if (about == nullptr || variable.id != about->wayInput().id || variable.unit != about->wayInput().unit) return {};
  const std::string language = programLanguage().toStdString();
  std::vector<Landmark> out;
  for (const procedure::Landmark& one : about->landmarks) {
    if (one.from_mm < variable.min || one.to_mm > variable.max) continue;
    out.push_back({text(procedure::textIn(one.name, language)), one.from_mm, one.to_mm,
                   text(procedure::textIn(one.what, language)), text(one.source)});
  }
  return out;
}

}  // namespace tactus::workbench
