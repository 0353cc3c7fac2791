#include "app/workbench/labs/data/influence_text.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

struct InfluenceText {
  Q_DECLARE_TR_FUNCTIONS(InfluenceText)
};

constexpr double kLeastN = 0.0005;         // what is shown as 0.001 N
constexpr double kLeastNoticeable = 0.05;  // what is shown as 0.1

// Not `0 N` for what is more than nothing.
QString forceMoved(double force_n) {
  return force_n > 0 && force_n < kLeastN ? InfluenceText::tr("less than 0.001 N") : quantityText(force_n, "N", 3);
}

QString noticeableText(double noticeable) {
  return noticeable > 0 && noticeable < kLeastNoticeable ? InfluenceText::tr("less than 0.1")
                                                         : numberText(noticeable, 1);
}

}  // namespace

QString movedText(const elicitation::RecordInfluence& moved) {
  const double largest_n = moved.difference.largest_n;
  const QString force =
      largest_n > 0 && largest_n < kLeastN ? InfluenceText::tr("< 0.001 N") : quantityText(largest_n, "N", 3);
  return InfluenceText::tr("%1 (%2 JND)")
      .arg(force, moved.noticeable > 0 && moved.noticeable < kLeastNoticeable ? QStringLiteral("< 0.1")
                                                                              : numberText(moved.noticeable, 1));
}

QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved,
                      const fuzzy::ForceModel& model) {
  if (!moved)
    return InfluenceText::tr("%1: without it there is no model: %2").arg(which, text(moved.error().message()));
  const analysis::ForceDifference& found = moved->difference;
  if (found.largest_n == 0) return InfluenceText::tr("%1: without it the averaged force is the same.").arg(which);
  if (found.largest_n < kLeastN) {
    return InfluenceText::tr("%1: without it the averaged force moves by less than 0.001 N everywhere.").arg(which);
  }
  return InfluenceText::tr(
             "%1: without it the averaged force moves by at most %2 (%3 just-noticeable differences), at %4; %5 rms.")
      .arg(which, forceMoved(found.largest_n), noticeableText(moved->noticeable),
           text(elicitation::pointText(model, found.at)), forceMoved(found.rms_n));
}

}  // namespace tactus::workbench
