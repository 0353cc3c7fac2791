#include "app/workbench/labs/rules/agreement_rows.h"

#include <QCoreApplication>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/agreement_data.h"
#include "elicitation/variables/ngt_variables.h"

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
    case AgreementTable::kSize: return QStringLiteral("%1 × %2").arg(row.units).arg(row.raters);
    case AgreementTable::kOrdinal: return number(m.alpha_ordinal);
    case AgreementTable::kInterval:
      return row.interval
                 ? AgreementTable::tr("%1 to %2").arg(fixed(row.interval->low, 2), fixed(row.interval->high, 2))
                 : kNoValue;
    case AgreementTable::kConsensus: return row.consensus ? fixed(*row.consensus) : kNoValue;
    case AgreementTable::kIntervalAlpha: return number(m.alpha_interval);
    case AgreementTable::kNominal: return number(m.alpha_nominal);
    case AgreementTable::kKendall: return m.kendall_w ? fixed(m.kendall_w->w) : kNoValue;
    case AgreementTable::kFleiss: return m.fleiss_kappa ? fixed(m.fleiss_kappa->kappa) : kNoValue;
    default: return {};
  }
}

// Why a measure is missing.
QString reasonText(const AgreementRow& row, int column) {
  const elicitation::Agreement& m = row.measures;
  switch (column) {
    case AgreementTable::kOrdinal: return reasonOf(m.alpha_ordinal);
    case AgreementTable::kIntervalAlpha: return reasonOf(m.alpha_interval);
    case AgreementTable::kNominal: return reasonOf(m.alpha_nominal);
    case AgreementTable::kKendall: return reasonOf(m.kendall_w);
    case AgreementTable::kFleiss: return reasonOf(m.fleiss_kappa);
    default: return {};
  }
}

QString meanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 (%2)").arg(fixed(row.mean, 2), fixed(row.sd, 2));
}

QString spanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 – %2").arg(row.min).arg(row.max);
}

QString orderLessTip() {
  return AgreementTable::tr("Takes no account of the order of the words: neighbors count as different as the ends.");
}

}  // namespace

AgreementTable::AgreementTable(QObject* parent)
    : LabTableModel(
          {{tr("Ratings")},
           {tr("Units × raters"), Qt::AlignHCenter},
           {tr("Ordinal alpha"), Qt::AlignHCenter,
            tr("Krippendorff's alpha for ordered words: 1 is full agreement, 0 what chance gives.")},
           {tr("95 % interval"), Qt::AlignHCenter,
            tr("95 % of 2,000 draws of the forces or items; the participants stay the same.")},
           {tr("Consensus"), Qt::AlignHCenter,
            tr("Tastle and Wierman: 1 if all say the same, 0 if half are at each end; mean of the forces or items.")},
           {tr("Interval alpha"), Qt::AlignHCenter},
           {tr("Nominal alpha"), Qt::AlignHCenter, orderLessTip()},
           {tr("Kendall's W"), Qt::AlignHCenter,
            tr("How similarly the participants order the forces or items, from 0 to 1.")},
           {tr("Fleiss' kappa"), Qt::AlignHCenter, orderLessTip()}},
          parent) {}

void AgreementTable::setRows(std::vector<AgreementRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int AgreementTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant AgreementTable::cell(int row, int column, int role) const {
  const AgreementRow& at = rows_[static_cast<std::size_t>(row)];
  if (role == Qt::DisplayRole) {
    if (column == kRatings) return at.ratings;
    return at.refusal.isEmpty() ? measureText(at, column) : kNoValue;
  }
  if (role == Qt::ToolTipRole) return at.refusal.isEmpty() ? reasonText(at, column) : at.refusal;
  return {};
}

UsabilityTable::UsabilityTable(QObject* parent)
    : LabTableModel({{tr("Statement")},
                     {tr("Answers"), Qt::AlignHCenter},
                     {tr("Mean (SD)"), Qt::AlignHCenter},
                     {tr("Range"), Qt::AlignHCenter},
                     {tr("Published"), Qt::AlignHCenter},
                     {tr("Published range"), Qt::AlignHCenter}},
                    parent) {}

void UsabilityTable::setRows(std::vector<UsabilityRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int UsabilityTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant UsabilityTable::cell(int row, int column, int role) const {
  const UsabilityRow& at = rows_[static_cast<std::size_t>(row)];
  if (role == Qt::ToolTipRole && column == kStatement) return at.statement;
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kStatement: return at.statement;
    case kCount: return QString::number(at.here.n);
    case kHere: return meanText(at.here);
    case kHereRange: return spanText(at.here);
    case kPublished: return meanText(at.published);
    case kPublishedRange: return spanText(at.published);
    default: return {};
  }
}

namespace {

struct AgreementWords {
  Q_DECLARE_TR_FUNCTIONS(AgreementWords)
};

std::optional<double> meanConsensus(const elicitation::Agreement& measures) {
  double sum = 0;
  int count = 0;
  for (const auto& item : measures.items) {
    if (!item) continue;
    sum += item->consensus;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

AgreementRow rowOf(const QString& ratings, const base::Result<elicitation::AgreementData>& data,
                   const std::stop_token& stop) {
  AgreementRow row;
  row.ratings = ratings;
  if (!data) {
    row.refusal = text(data.error().message());
    return row;
  }
  row.units = data->units.size();
  row.raters = data->raters.size();
  row.measures = elicitation::agreement(*data);
  row.consensus = meanConsensus(row.measures);
  row.interval = elicitation::alphaInterval(data->counts, elicitation::AlphaLevel::kOrdinal, {.stop = stop});
  return row;
}

}  // namespace

std::vector<AgreementRow> agreementRows(const LabStudy& study, const std::stop_token& stop) {
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : elicitation::ngtOutput().terms) ids.push_back(term.id);
  return {rowOf(AgreementWords::tr("Judged forces"),
                elicitation::agreementData(study.study.judgements, "ascending", ids), stop),
          rowOf(AgreementWords::tr("Answers to the form"),
                elicitation::agreementData(study.study.answers, {}, study.forms, ids), stop)};
}

std::vector<UsabilityRow> usabilityRows(const LabStudy& study) {
  const questionnaires::ScaleForm form = questionnaires::usabilityForm();
  const auto here = questionnaires::summarize(form, study.answers);
  const auto published = questionnaires::publishedUsability();
  std::vector<UsabilityRow> rows;
  for (std::size_t i = 0; i < form.items.size(); ++i) {
    UsabilityRow row{text(form.items[i].text), here[i], {}};
    if (i < published.size()) row.published = published[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace tactus::workbench
