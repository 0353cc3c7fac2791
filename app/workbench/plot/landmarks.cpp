#include "app/workbench/plot/landmarks.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/shown_procedure.h"

namespace tactus::workbench {
namespace {

struct LandmarkText {
  Q_DECLARE_TR_FUNCTIONS(LandmarkText)
};

std::vector<Landmark> ofProcedure(const fuzzy::Variable& variable) {
  const ProcedurePtr& about = shownProcedure();
  if (about == nullptr || variable.id != about->wayInput().id || variable.unit != about->wayInput().unit) return {};
  std::vector<Landmark> out;
  for (const procedure::Landmark& one : about->landmarks) {
    if (one.from_mm < variable.min || one.to_mm > variable.max) continue;
    out.push_back({inProgramLanguage(one.name), one.from_mm, one.to_mm, inProgramLanguage(one.what), text(one.source)});
  }
  return out;
}

Landmark puncture(const fuzzy::Variable& way, const fuzzy::Term& term, double share) {
  const double place_mm = fuzzy::endOfCore(way, term);
  return {LandmarkText::tr("Puncture: %1").arg(labelOf(term)), place_mm, place_mm,
          LandmarkText::tr("%1 % of the force is lost, once in a stroke").arg(numberText(share * 100)),
          LandmarkText::tr("the model")};
}

}  // namespace

std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable, std::span<const fuzzy::TubeEvent> events) {
  std::vector<Landmark> out = ofProcedure(variable);
  for (const fuzzy::TubeEvent& event : events) {
    const fuzzy::Term* const term = fuzzy::findTerm(variable.terms, event.term);
    if (term == nullptr || fuzzy::roleOf(variable) != fuzzy::Role::kWay) continue;
    Landmark mark = puncture(variable, *term, event.share);
    const auto behind =
        std::find_if(out.begin(), out.end(), [&](const Landmark& other) { return other.from_mm > mark.from_mm; });
    out.insert(behind, std::move(mark));
  }
  return out;
}

}  // namespace tactus::workbench
