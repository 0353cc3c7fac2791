#include "app/workbench/labs/force/judgement_grid.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "elicitation/force/force_voting.h"

namespace tactus::workbench {
namespace {

using Judged = study::ForceJudgement::Kind;

struct GridWords {
  Q_DECLARE_TR_FUNCTIONS(GridWords)
};

/// What was measured beside a judgement, a line each.
QString measured(const session::JudgedForce& judged) {
  const study::JudgementRecord& record = judged.record;
  QStringList lines;
  if (record.felt_n)
    lines << GridWords::tr("Felt, with the friction of the device: %1").arg(quantityText(*record.felt_n, "N"));
  if (record.delivered_share) {
    lines << GridWords::tr("Least share of the force in the hand: %1 %")
                 .arg(numberText(*record.delivered_share * 100, 0));
  }
  if (record.forward_mm > 0) {
    lines << GridWords::tr("Moved forward: %1 at %2")
                 .arg(quantityText(record.forward_mm, "mm", 0), quantityText(record.forward_speed_mm_s, "mm/s", 0));
  }
  if (record.response_s > 0) lines << GridWords::tr("Answer after %1").arg(quantityText(record.response_s, "s", 1));
  if (record.feel_again > 0) lines << GridWords::tr("Felt again: %1 times").arg(record.feel_again);
  if (record.catch_trial) lines << GridWords::tr("A hidden check; it is not counted.");
  if (!judged.counts && !record.catch_trial) lines << GridWords::tr("Not counted for the terms.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

QString judgedText(const fuzzy::Variable& words, const session::JudgedWord& word) {
  switch (word.kind) {
    case Judged::kTerm:
      for (const fuzzy::Term& term : words.terms) {
        if (term.id == word.term) return labelOf(term);
      }
      return harmless(text(word.term));
    case Judged::kNotFelt:
      return GridWords::tr("not felt");
    case Judged::kBeyondPractice:
      return GridWords::tr("beyond practice");
    case Judged::kNoAnswer:
      return GridWords::tr("no answer");
  }
  return {};
}

session::JudgedWord judgedWord(const study::JudgementRecord& record) { return {record.kind, record.term}; }

std::vector<session::JudgedWord> offeredWords(const fuzzy::Variable& words,
                                              const std::vector<session::JudgedForce>& all,
                                              const session::JudgedForce& judged) {
  std::vector<session::JudgedWord> out;
  for (const fuzzy::Term& term : words.terms) out.push_back({Judged::kTerm, term.id});
  out.push_back({Judged::kNotFelt, {}});
  const bool goes_on = std::any_of(all.begin(), all.end(), [&](const session::JudgedForce& other) {
    return other.record.entry.session == judged.record.entry.session && other.record.series == judged.record.series &&
           other.record.step > judged.record.step;
  });
  if (!goes_on) out.push_back({Judged::kBeyondPractice, {}});
  out.push_back({Judged::kNoAnswer, {}});
  std::erase(out, judgedWord(judged.record));
  return out;
}

void JudgementGrid::setJudgements(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& all,
                                  const std::string& series) {
  beginResetModel();
  words_ = words;
  judgements_.clear();
  rows_.clear();
  columns_.clear();
  for (const session::JudgedForce& one : all) {
    if (one.record.series != series) continue;
    judgements_.push_back(one);
    if (rows_.empty() || rows_.back() != one.participant) rows_.push_back(one.participant);
    columns_.push_back(one.record.commanded_n);
  }
  std::sort(columns_.begin(), columns_.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < elicitation::kSameForceN; };
  columns_.erase(std::unique(columns_.begin(), columns_.end(), same), columns_.end());
  cells_.assign(rows_.size(), std::vector<std::vector<std::size_t>>(columns_.size()));
  std::size_t row = 0;
  for (std::size_t i = 0; i < judgements_.size(); ++i) {
    if (judgements_[i].participant != rows_[row]) ++row;
    cells_[row][static_cast<std::size_t>(columnOf(judgements_[i].record.commanded_n))].push_back(i);
  }
  endResetModel();
}

int JudgementGrid::columnOf(double force_n) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (std::abs(columns_[i] - force_n) < elicitation::kSameForceN) return static_cast<int>(i);
  }
  return -1;
}

std::vector<const session::JudgedForce*> JudgementGrid::at(const QModelIndex& index) const {
  std::vector<const session::JudgedForce*> out;
  if (!index.isValid()) return out;
  for (const std::size_t i : cells_[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())]) {
    out.push_back(&judgements_[i]);
  }
  return out;
}

int JudgementGrid::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int JudgementGrid::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant JudgementGrid::data(const QModelIndex& index, int role) const {
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
  QStringList parts;
  for (const session::JudgedForce* judged : at(index)) {
    QString part = judgedText(words_, judgedWord(judged->record));
    if (role != Qt::ToolTipRole) {
      parts << part;
      continue;
    }
    for (const session::JudgedWord& before : judged->before) {
      part += QLatin1Char('\n') + tr("Corrected; before: %1").arg(judgedText(words_, before));
    }
    const QString rest = measured(*judged);
    parts << (rest.isEmpty() ? part : part + QLatin1Char('\n') + rest);
  }
  return parts.join(role == Qt::ToolTipRole ? QStringLiteral("\n\n") : QStringLiteral(", "));
}

QVariant JudgementGrid::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return harmless(text(participant(section)));
  return quantityText(forceN(section), words_.unit);
}

}  // namespace tactus::workbench
