#include "app/workbench/labs/data/influence_text.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

struct InfluenceText {
  Q_DECLARE_TR_FUNCTIONS(InfluenceText)
};

// Not `0 N` for what is more than nothing.
QString movedText(double force_n) {
  constexpr double kLeastN = 0.0005;  // what is shown as 0.001 N
  return force_n > 0 && force_n < kLeastN ? InfluenceText::tr("less than 0.001 N") : quantityText(force_n, "N", 3);
}

}  // namespace

QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved,
                      const fuzzy::ForceModel& model) {
  if (!moved)
    return InfluenceText::tr("%1: without it there is no model: %2").arg(which, text(moved.error().message()));
  const analysis::ForceDifference& found = moved->difference;
  if (found.largest_n == 0) return InfluenceText::tr("%1: without it the averaged force is the same.").arg(which);
  return InfluenceText::tr(
             "%1: without it the averaged force moves by at most %2 (%3 just-noticeable differences), at %4; %5 rms.")
      .arg(which, movedText(found.largest_n), numberText(moved->noticeable, 1),
           text(elicitation::pointText(model, found.at)), movedText(found.rms_n));
}

}  // namespace tactus::workbench
