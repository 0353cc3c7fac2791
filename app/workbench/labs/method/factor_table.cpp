#include "app/workbench/labs/method/factor_table.h"

#include "app/workbench/base/display_text.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {
namespace {

const QString kNotCompared = QStringLiteral("–");

}  // namespace

QString feltText(double share) {
  if (share > 0 && share < 0.0005) return QStringLiteral("< 0.1 %");
  return QStringLiteral("%1 %").arg(numberText(100 * share, 1));
}

FactorTable::FactorTable(QObject* parent)
    : LabTableModel({{tr("Choice")},
                     {tr("Now")},
                     {tr("Does it matter here?")},
                     {tr("At most"), Qt::AlignRight},
                     {tr("JND"), Qt::AlignRight,
                      tr("Root mean square of the difference over the input space, in just-noticeable differences, for "
                         "the value that moves the force most.")}},
                    parent) {}

void FactorTable::setStudy(const elicitation::MethodStudy* study) {
  beginResetModel();
  study_ = study == nullptr ? elicitation::MethodStudy() : *study;
  order_ = elicitation::factorsByEffect(study_);
  endResetModel();
}

int FactorTable::rows() const { return static_cast<int>(order_.size()); }

QVariant FactorTable::cell(int row, int column, int role) const {
  const auto& factor = study_.factors[factorAt(row)];
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const auto* const worst = factor.worst ? &study_.variants[*factor.worst] : nullptr;
  switch (column) {
    case kFactor:
      return text(elicitation::factorTitle(factor.factor));
    case kNow:
      return text(factor.unchanged);
    case kSentence:
      if (role == Qt::ToolTipRole) return text(elicitation::factorSentence(study_, factor));
      // A narrow column shall not break between a number and its sign.
      return text(elicitation::factorVerdict(study_, factor)).replace(QStringLiteral(" %"), QStringLiteral("\u00A0%"));
    case kLargest:
      return worst == nullptr ? kNotCompared : quantityText(worst->largest_n, "N", 3);
    case kNoticeable:
      return worst == nullptr ? kNotCompared : numberText(worst->rms_noticeable, 2);
    default:
      return {};
  }
}

}  // namespace tactus::workbench
