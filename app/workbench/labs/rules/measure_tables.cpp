#include "app/workbench/labs/rules/measure_tables.h"

#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

const QString kNoValue = QStringLiteral("–");

QString fixed(double value, int digits = 3) { return QString::number(value, 'f', digits); }

template <class T>
QString reasonOf(const elicitation::OrReason<T>& value) {
  return value ? QString() : text(value.error());
}

QString measureText(const AgreementRow& row, int column) {
  const elicitation::Agreement& m = row.measures;
  const auto number = [](const elicitation::OrReason<double>& value) { return value ? fixed(*value) : kNoValue; };
  switch (column) {
    case AgreementTable::kSize:
      return QStringLiteral("%1 × %2").arg(row.units).arg(row.raters);
    case AgreementTable::kOrdinal:
      return number(m.alpha_ordinal);
    case AgreementTable::kInterval:
      return row.interval
                 ? AgreementTable::tr("%1 to %2").arg(fixed(row.interval->low, 2), fixed(row.interval->high, 2))
                 : kNoValue;
    case AgreementTable::kConsensus:
      return row.consensus ? fixed(*row.consensus) : kNoValue;
    case AgreementTable::kIntervalAlpha:
      return number(m.alpha_interval);
    case AgreementTable::kNominal:
      return number(m.alpha_nominal);
    case AgreementTable::kKendall:
      return m.kendall_w ? fixed(m.kendall_w->w) : kNoValue;
    case AgreementTable::kFleiss:
      return m.fleiss_kappa ? fixed(m.fleiss_kappa->kappa) : kNoValue;
    default:
      return {};
  }
}

// Why a measure is missing.
QString reasonText(const AgreementRow& row, int column) {
  const elicitation::Agreement& m = row.measures;
  switch (column) {
    case AgreementTable::kOrdinal:
      return reasonOf(m.alpha_ordinal);
    case AgreementTable::kIntervalAlpha:
      return reasonOf(m.alpha_interval);
    case AgreementTable::kNominal:
      return reasonOf(m.alpha_nominal);
    case AgreementTable::kKendall:
      return reasonOf(m.kendall_w);
    case AgreementTable::kFleiss:
      return reasonOf(m.fleiss_kappa);
    default:
      return {};
  }
}

QString meanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 (%2)").arg(fixed(row.mean, 2), fixed(row.sd, 2));
}

QString spanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 – %2").arg(row.min).arg(row.max);
}

}  // namespace

void AgreementTable::setRows(std::vector<AgreementRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int AgreementTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant AgreementTable::data(const QModelIndex& index, int role) const {
  const AgreementRow& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole) {
    if (index.column() == kRatings) return row.ratings;
    return row.refusal.isEmpty() ? measureText(row, index.column()) : kNoValue;
  }
  if (role == Qt::ToolTipRole) return row.refusal.isEmpty() ? reasonText(row, index.column()) : row.refusal;
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((index.column() == kRatings ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
  }
  return {};
}

QVariant AgreementTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section == kRatings) return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case kOrdinal:
        return tr("Krippendorff's alpha for ordered words: 1 is full agreement, 0 what chance gives.");
      case kInterval:
        return tr("95 % of 2,000 draws of the forces or items; the participants stay the same.");
      case kConsensus:
        return tr("Tastle and Wierman: 1 if all say the same, 0 if half are at each end; mean of the forces or items.");
      case kNominal:
      case kFleiss:
        return tr("Takes no account of the order of the words: neighbors count as different as the ends.");
      case kKendall:
        return tr("How similarly the participants order the forces or items, from 0 to 1.");
      default:
        return {};
    }
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kRatings:
      return tr("Ratings");
    case kSize:
      return tr("Units × raters");
    case kOrdinal:
      return tr("Ordinal alpha");
    case kInterval:
      return tr("95 % interval");
    case kConsensus:
      return tr("Consensus");
    case kIntervalAlpha:
      return tr("Interval alpha");
    case kNominal:
      return tr("Nominal alpha");
    case kKendall:
      return tr("Kendall's W");
    case kFleiss:
      return tr("Fleiss' kappa");
    default:
      return {};
  }
}

void UsabilityTable::setRows(std::vector<UsabilityRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int UsabilityTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant UsabilityTable::data(const QModelIndex& index, int role) const {
  const UsabilityRow& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((index.column() == kStatement ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && index.column() == kStatement) return row.statement;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kStatement:
      return row.statement;
    case kCount:
      return QString::number(row.here.n);
    case kHere:
      return meanText(row.here);
    case kHereRange:
      return spanText(row.here);
    case kPublished:
      return meanText(row.published);
    case kPublishedRange:
      return spanText(row.published);
    default:
      return {};
  }
}

QVariant UsabilityTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section == kStatement) return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kStatement:
      return tr("Statement");
    case kCount:
      return tr("Answers");
    case kHere:
      return tr("Mean (SD)");
    case kHereRange:
      return tr("Range");
    case kPublished:
      return tr("Published");
    case kPublishedRange:
      return tr("Published range");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
