#include "app/workbench/labs/rules/agreement_rows.h"

#include <QCoreApplication>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/procedure/procedure.h"
#include "elicitation/agreement/agreement_data.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench {
namespace {

const QString kNoValue = QStringLiteral("–");

QString fixed(double value, int digits = 3) { return QString::number(value, 'f', digits); }

struct AgreementWords {
  Q_DECLARE_TR_FUNCTIONS(AgreementWords)
};

/// A measure with its reason where it is missing. `get`: elicitation::OrReason<double> of the measures.
template <class Get>
Column<AgreementRow> measure(const QString& head, const QString& head_tip, Get get) {
  using Row = AgreementRow;
  return {head,
          [get](const Row& row) {
            const auto value = get(row.measures);
            return row.refusal.isEmpty() && value ? fixed(*value) : kNoValue;
          },
          Qt::AlignHCenter,
          head_tip,
          {{Qt::ToolTipRole, [get](const Row& row) {
              const auto value = get(row.measures);
              if (!row.refusal.isEmpty()) return row.refusal;
              return value ? QString() : text(value.error());
            }}}};
}

QString meanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 (%2)").arg(fixed(row.mean, 2), fixed(row.sd, 2));
}

QString spanText(const questionnaires::ScaleSummary& row) {
  return row.n == 0 ? kNoValue : QStringLiteral("%1 – %2").arg(row.min).arg(row.max);
}

}  // namespace

std::vector<Column<AgreementRow>> agreementColumns() {
  using Row = AgreementRow;
  using Measures = const elicitation::Agreement&;
  const QString order_less =
      AgreementWords::tr("Takes no account of the order of the words: neighbors count as different as the ends.");
  return withRole<Row>(
      {{AgreementWords::tr("Ratings"), &Row::ratings},
       {AgreementWords::tr("Units × raters"),
        [](const Row& row) {
          return row.refusal.isEmpty() ? QStringLiteral("%1 × %2").arg(row.units).arg(row.raters) : kNoValue;
        },
        Qt::AlignHCenter},
       measure(AgreementWords::tr("Ordinal alpha"),
               AgreementWords::tr("Krippendorff's alpha for ordered words: 1 is full agreement, 0 what chance gives."),
               [](Measures all) { return all.alpha_ordinal; }),
       {AgreementWords::tr("95 % interval"),
        [](const Row& row) {
          if (!row.refusal.isEmpty() || !row.interval) return kNoValue;
          return AgreementWords::tr("%1 to %2").arg(fixed(row.interval->low, 2), fixed(row.interval->high, 2));
        },
        Qt::AlignHCenter,
        AgreementWords::tr("95 % of 2,000 draws of the forces or items; the participants stay the same.")},
       {AgreementWords::tr("Consensus"),
        [](const Row& row) {
          return row.refusal.isEmpty() && row.measures.mean_consensus ? fixed(*row.measures.mean_consensus) : kNoValue;
        },
        Qt::AlignHCenter,
        AgreementWords::tr(
            "Tastle and Wierman: 1 if all say the same, 0 if half are at each end; mean of the forces or items.")},
       measure(AgreementWords::tr("Interval alpha"), {}, [](Measures all) { return all.alpha_interval; }),
       measure(AgreementWords::tr("Nominal alpha"), order_less, [](Measures all) { return all.alpha_nominal; }),
       measure(AgreementWords::tr("Kendall's W"),
               AgreementWords::tr("How similarly the participants order the forces or items, from 0 to 1."),
               [](Measures all) { return all.kendall_w.map([](const auto& found) { return found.w; }); }),
       measure(AgreementWords::tr("Fleiss' kappa"), order_less,
               [](Measures all) { return all.fleiss_kappa.map([](const auto& found) { return found.kappa; }); })},
      Qt::ToolTipRole, &Row::refusal);
}

std::vector<Column<UsabilityRow>> usabilityColumns() {
  using Row = UsabilityRow;
  const auto center = [](const QString& head, CellOf<Row> cell) -> Column<Row> {
    return {head, std::move(cell), Qt::AlignHCenter};
  };
  return {{AgreementWords::tr("Statement"), &Row::statement, Qt::AlignLeft, {}, {{Qt::ToolTipRole, &Row::statement}}},
          center(AgreementWords::tr("Answers"), [](const Row& row) { return QString::number(row.here.n); }),
          center(AgreementWords::tr("Mean (SD)"), [](const Row& row) { return meanText(row.here); }),
          center(AgreementWords::tr("Range"), [](const Row& row) { return spanText(row.here); }),
          center(AgreementWords::tr("Published"), [](const Row& row) { return meanText(row.published); }),
          center(AgreementWords::tr("Published range"), [](const Row& row) { return spanText(row.published); })};
}

namespace {

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
  row.interval = elicitation::alphaInterval(data->counts, elicitation::AlphaLevel::kOrdinal, {.stop = stop});
  return row;
}

}  // namespace

std::vector<AgreementRow> agreementRows(const LabStudy& study, const std::stop_token& stop) {
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : procedure::of(study.study).output.terms) ids.push_back(term.id);
  return {rowOf(AgreementWords::tr("Judged forces"),
                elicitation::agreementData(study.study.judgements, "ascending", ids), stop),
          rowOf(AgreementWords::tr("Answers to the form"),
                elicitation::agreementData(study.study.answers, {}, study.forms, ids), stop)};
}

std::vector<UsabilityRow> usabilityRows(const LabStudy& study) {
  const questionnaires::ScaleForm form = questionnaires::usabilityForm();
  const auto here = questionnaires::summarize(form, study.answers);
  const procedure::Procedure& about = procedure::of(study.study);
  const auto asked = questionnaires::questionnaire(about, form.id, "en");
  const bool of_paper = about.id == procedure::defaultProcedure()->id;
  const auto published = questionnaires::publishedUsability();
  std::vector<UsabilityRow> rows;
  for (std::size_t i = 0; i < form.items.size(); ++i) {
    UsabilityRow row{text(asked->questions[i].text), here[i], {}};
    if (of_paper && i < published.size()) row.published = published[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace tactus::workbench
