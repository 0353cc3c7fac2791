#include "app/workbench/labs/rules/cell_table.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/labs/data/influence_text.h"
#include "app/workbench/plot/term_colors.h"

namespace tactus::workbench {
namespace {

const QString kNothing = QStringLiteral("–");

// With its sign, so that more and less are seen at once.
QString signedText(double force_n, const std::string& unit) {
  const QString number = quantityText(std::abs(force_n), unit, 3);
  return (force_n < 0 ? QStringLiteral("−") : QStringLiteral("+")) + number;
}

}  // namespace

CellTable::CellTable(const RulesLab& lab, QObject* parent)
    : LabTableModel({{tr("Expert")},
                     {tr("Says")},
                     {tr("Would feel"), Qt::AlignRight},
                     {tr("From the mean"), Qt::AlignRight},
                     {tr("Mean without it"), Qt::AlignRight,
                      tr("How far the averaged force moves without this rule, at most, and in just-noticeable "
                         "differences.")},
                     {tr("From")}},
                    parent),
      lab_(lab) {}

void CellTable::follow() {
  beginResetModel();
  rows_.clear();
  mean_n_.reset();
  const ExpertGrids& grids = lab_.grids();
  if (lab_.chosen()) {
    const GridPlace place = *lab_.chosen();
    const elicitation::CellConflict* const conflict = lab_.conflictAt(place);
    double sum = 0;
    double weights = 0;
    for (std::size_t e = 0; e < grids.experts.size(); ++e) {
      const AskedCell& cell = grids.at(e, place.row, place.column);
      Row row{harmless(grids.experts[e].label), grids.experts[e].number, kNothing, cell.word, {}, {}};
      if (cell.word) row.word = labelOf(grids.output.terms[*cell.word]);
      if (!cell.asked) row.word = tr("not asked");
      if (cell.asked && !cell.word && !cell.without.isEmpty()) row.word = cell.without;
      row.source = cell.given ? tr("given directly") : cell.item > 0 ? tr("item %1").arg(cell.item) : kNothing;
      if (cell.corrected) row.source += tr(", corrected");
      if (cell.word && conflict != nullptr && e < conflict->felt_n.size()) {
        row.felt_n = conflict->felt_n[e];
        sum += grids.experts[e].weight * *row.felt_n;
        weights += grids.experts[e].weight;
      }
      rows_.push_back(row);
    }
    if (weights > 0) mean_n_ = sum / weights;
  }
  endResetModel();
}

void CellTable::followInfluences() {
  if (!rows_.empty()) emit dataChanged(index(0, kWithout), index(rows() - 1, kWithout));
}

int CellTable::rows() const { return static_cast<int>(rows_.size()); }

QString CellTable::withoutText(std::size_t row) const {
  const auto moved = lab_.influenceOf(row);
  if (!moved) return rows_[row].term && lab_.isComparing() ? QStringLiteral("…") : kNothing;
  return movedText(*moved);
}

QVariant CellTable::orderOf(std::size_t row, int column) const {
  const Row& at = rows_[row];
  switch (column) {
    case kWord:
      return at.term ? static_cast<int>(*at.term) : -1;
    case kFelt:
      return at.felt_n.value_or(-1);
    case kFromMean:
      return at.felt_n && mean_n_ ? std::abs(*at.felt_n - *mean_n_) : -1;
    case kWithout: {
      const auto moved = lab_.influenceOf(row);
      return moved ? moved->difference.largest_n : -1;
    }
    case kSource:
      return at.source;
    default:
      return static_cast<int>(row);
  }
}

QVariant CellTable::cell(int row, int column, int role) const {
  const auto expert = static_cast<std::size_t>(row);
  const Row& at = rows_[expert];
  const std::string& unit = lab_.grids().output.unit;
  if (role == kOrderRole) return orderOf(expert, column);
  if (role == Qt::DecorationRole && column == kExpert) return theme::expert(at.number);
  if (role == Qt::DecorationRole && column == kWord && at.term) {
    return termFill(lab_.grids().output, lab_.grids().output.terms, *at.term);
  }
  if (role == Qt::ToolTipRole && column == kWithout) {
    const auto moved = lab_.influenceOf(expert);
    return moved ? QVariant(influenceText(at.expert, *moved, lab_.model())) : QVariant();
  }
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kExpert:
      return at.expert;
    case kWord:
      return at.word;
    case kFelt:
      return at.felt_n ? quantityText(*at.felt_n, unit, 3) : kNothing;
    case kFromMean:
      return at.felt_n && mean_n_ ? signedText(*at.felt_n - *mean_n_, unit) : kNothing;
    case kWithout:
      return withoutText(expert);
    default:
      return at.source;
  }
}

QString cellSummary(const RulesLab& lab) {
  if (!lab.chosen()) return {};
  const elicitation::CellConflict* const conflict = lab.conflictAt(*lab.chosen());
  if (conflict == nullptr) return CellTable::tr("No expert has a rule here.");
  const fuzzy::Variable& output = lab.grids().output;
  const QString apart = quantityText(conflict->rms_n, output.unit, 3);
  const QString times = numberText(conflict->rms_noticeable, 1);
  QStringList out;
  if (conflict->rms_n == 0) {
    out << CellTable::tr("All say the same here.");
  } else if (conflict->rms_noticeable > 1) {
    out << CellTable::tr(
               "With each other's word the experts would feel %1 more or less: %2 just-noticeable differences.")
               .arg(apart, times);
  } else {
    out << CellTable::tr("With each other's word the experts would feel %1 more or less: not noticeable (%2).")
               .arg(apart, times);
  }
  if (conflict->rms_n > 0) {
    const fuzzy::Term* const middle = fuzzy::findTerm(output.terms, conflict->middle_word);
    const double percent = std::round(conflict->share * 100);
    const QString said =
        percent < 0
            ? CellTable::tr("If all said %1, the mean would move by %2, and the disagreement would grow by %3 %.")
            : CellTable::tr("If all said %1, the mean would move by %2, and %3 % of the disagreement would vanish.");
    out << said.arg(middle == nullptr ? text(conflict->middle_word) : labelOf(*middle),
                    quantityText(conflict->stake_n, output.unit, 3), numberText(std::abs(percent), 0));
  }
  return out.join(QLatin1Char(' '));
}

}  // namespace tactus::workbench
