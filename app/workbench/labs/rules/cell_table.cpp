#include "app/workbench/labs/rules/cell_table.h"

#include <QCoreApplication>
#include <algorithm>

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

CellTable::CellTable(const RulesLab& lab, QObject* parent) : QAbstractTableModel(parent), lab_(lab) {}

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
      row.source = cell.given ? tr("rule given directly") : cell.item > 0 ? tr("item %1").arg(cell.item) : kNothing;
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

int CellTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant CellTable::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const std::string& unit = lab_.grids().output.unit;
  if (role == Qt::DecorationRole && index.column() == kExpert) return theme::expert(row.number);
  if (role == Qt::DecorationRole && index.column() == kWord && row.term) {
    return termFill(lab_.grids().output, lab_.grids().output.terms, *row.term);
  }
  if (role == Qt::TextAlignmentRole) {
    const bool number = index.column() >= kFelt && index.column() <= kWithout;
    return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && index.column() == kWithout) {
    const auto moved = lab_.influenceOf(static_cast<std::size_t>(index.row()));
    return moved ? QVariant(influenceText(row.expert, *moved, lab_.model())) : QVariant();
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kExpert:
      return row.expert;
    case kWord:
      return row.word;
    case kFelt:
      return row.felt_n ? quantityText(*row.felt_n, unit, 3) : kNothing;
    case kWithout: {
      const auto moved = lab_.influenceOf(static_cast<std::size_t>(index.row()));
      if (!moved && row.term && lab_.isComparing()) return QStringLiteral("…");
      return moved ? tr("%1 (%2 JND)")
                         .arg(quantityText(moved->difference.largest_n, unit, 3), numberText(moved->noticeable, 1))
                   : kNothing;
    }
    case kSource:
      return row.source;
    case kFromMean:
      return row.felt_n && mean_n_ ? signedText(*row.felt_n - *mean_n_, unit) : kNothing;
    default:
      return {};
  }
}

QVariant CellTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    const bool number = section >= kFelt && section <= kWithout;
    return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && section == kWithout) {
    return tr("How far the averaged force moves without this rule, at most, and in just-noticeable differences.");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kExpert:
      return tr("Expert");
    case kWord:
      return tr("Says");
    case kFelt:
      return tr("Would feel");
    case kFromMean:
      return tr("From the mean");
    case kWithout:
      return tr("Mean without it");
    case kSource:
      return tr("From");
    default:
      return {};
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
    out << CellTable::tr("If all said %1, the mean would move by %2, and %3 % of the disagreement would vanish.")
               .arg(middle == nullptr ? text(conflict->middle_word) : labelOf(*middle),
                    quantityText(conflict->stake_n, output.unit, 3), numberText(conflict->share * 100, 0));
  }
  return out.join(QLatin1Char(' '));
}

}  // namespace tactus::workbench
