#include "app/workbench/labs/method/factor_table.h"

#include "app/workbench/base/display_text.h"
#include "elicitation/model/method_words.h"

namespace tactus::workbench {
namespace {

const QString kNotCompared = QStringLiteral("–");

}  // namespace

QString feltText(double share) {
  if (share > 0 && share < 0.0005) return QStringLiteral("< 0.1 %");
  return QStringLiteral("%1 %").arg(numberText(100 * share, 1));
}

void FactorTable::setStudy(const elicitation::MethodStudy* study) {
  beginResetModel();
  study_ = study == nullptr ? elicitation::MethodStudy() : *study;
  order_ = elicitation::factorsByEffect(study_);
  endResetModel();
}

int FactorTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(order_.size());
}

QVariant FactorTable::data(const QModelIndex& index, int role) const {
  const auto& factor = study_.factors[factorAt(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((index.column() == kNoticeable ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const auto* const worst = factor.worst ? &study_.variants[*factor.worst] : nullptr;
  switch (index.column()) {
    case kFactor:
      return text(elicitation::factorTitle(factor.factor));
    case kNow:
      return text(factor.unchanged);
    case kSentence:
      return text(elicitation::factorSentence(study_, factor));
    case kNoticeable:
      return worst == nullptr ? kNotCompared : numberText(worst->rms_noticeable, 2);
    default:
      return {};
  }
}

QVariant FactorTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((section == kNoticeable ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && section == kNoticeable) {
    return tr(
        "Root mean square of the difference over the input space, in just-noticeable differences, for the value that "
        "moves the force most.");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kFactor:
      return tr("Choice");
    case kNow:
      return tr("Now");
    case kSentence:
      return tr("Does it matter here?");
    case kNoticeable:
      return tr("JND");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
