#include "app/workbench/labs/force/vote_table.h"

#include <numeric>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/force/vote_words.h"

namespace tactus::workbench {
namespace {

int cast(const elicitation::VoteStep& step) { return std::accumulate(step.votes.begin(), step.votes.end(), 0); }

}  // namespace

void VoteTable::setVotes(const ForceVotes& votes) {
  beginResetModel();
  words_ = votes.words;
  steps_ = votes.steps;
  std::vector<LabColumn> columns = {{tr("Force"), Qt::AlignRight}};
  for (const fuzzy::Term& word : words_.terms) {
    columns.push_back({initialsOf(labelOf(word)), Qt::AlignHCenter, labelOf(word)});
  }
  columns.push_back({tr("Winner")});
  columns.push_back({tr("Why")});
  setColumns(std::move(columns));
  endResetModel();
}

std::string VoteTable::wordAt(int column) const {
  if (column < kFirstWord || column >= winnerColumn()) return {};
  return words_.terms[static_cast<std::size_t>(column - kFirstWord)].id;
}

QVariant VoteTable::cell(int row, int column, int role) const {
  const elicitation::VoteStep& at = step(row);
  const bool is_word = column >= kFirstWord && column < winnerColumn();
  const auto word = static_cast<std::size_t>(column - kFirstWord);
  switch (role) {
    case Qt::DisplayRole:
      return shown(at, column);
    case Qt::ToolTipRole:
      return is_word || column == kForce ? QVariant() : reasonRule(at);
    case kShareRole:
      return is_word && cast(at) > 0 ? static_cast<double>(at.votes[word]) / cast(at) : 0.0;
    case kWinsRole:
      return is_word && at.term == word;
    default:
      return {};
  }
}

QString VoteTable::shown(const elicitation::VoteStep& step, int column) const {
  if (column == kForce) return quantityText(step.force_n, words_.unit);
  if (column < winnerColumn()) return QString::number(step.votes[static_cast<std::size_t>(column - kFirstWord)]);
  if (column == reasonColumn()) return reasonText(step);
  return step.term ? labelOf(words_.terms[*step.term]) : QStringLiteral("–");
}

}  // namespace tactus::workbench
