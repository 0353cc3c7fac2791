#include "app/workbench/labs/data/influence_text.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

struct InfluenceText {
  Q_DECLARE_TR_FUNCTIONS(InfluenceText)
};

}  // namespace

QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved) {
  if (!moved)
    return InfluenceText::tr("%1: without it there is no model: %2").arg(which, text(moved.error().message()));
  if (moved->difference.largest_n == 0)
    return InfluenceText::tr("%1: without it the averaged force is the same.").arg(which);
  return InfluenceText::tr("%1: without it the averaged force moves by at most %2 (%3 just-noticeable differences).")
      .arg(which, quantityText(moved->difference.largest_n, "N", 3), numberText(moved->noticeable, 1));
}

}  // namespace tactus::workbench
