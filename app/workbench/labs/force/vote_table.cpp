#include "app/workbench/labs/force/vote_table.h"

#include <numeric>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/initials.h"
#include "app/workbench/labs/force/vote_words.h"

namespace tactus::workbench {
namespace {

int cast(const elicitation::VoteStep& step) { return std::accumulate(step.votes.begin(), step.votes.end(), 0); }

}  // namespace

void VoteTable::setVotes(const ForceVotes& votes) {
  beginResetModel();
  words_ = votes.words;
  steps_ = votes.steps;
  endResetModel();
}

std::string VoteTable::wordAt(int column) const {
  if (column < kFirstWord || column >= winnerColumn()) return {};
  return words_.terms[static_cast<std::size_t>(column - kFirstWord)].id;
}

int VoteTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(steps_.size());
}

int VoteTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : reasonColumn() + 1; }

QVariant VoteTable::data(const QModelIndex& index, int role) const {
  const elicitation::VoteStep& at = step(index.row());
  const int column = index.column();
  const bool is_word = column >= kFirstWord && column < winnerColumn();
  const auto word = static_cast<std::size_t>(column - kFirstWord);
  switch (role) {
    case Qt::DisplayRole:
      return shown(at, column);
    case Qt::ToolTipRole:
      return is_word || column == kForce ? QVariant() : reasonRule(at);
    case Qt::TextAlignmentRole:
      if (column == kForce) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
      return static_cast<int>(is_word ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter);
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

QVariant VoteTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const bool is_word = section >= kFirstWord && section < winnerColumn();
  if (is_word && (role == Qt::DisplayRole || role == Qt::ToolTipRole)) {
    const QString word = labelOf(words_.terms[static_cast<std::size_t>(section - kFirstWord)]);
    return role == Qt::DisplayRole ? initialsOf(word) : word;
  }
  if (role == Qt::TextAlignmentRole && section == reasonColumn())
    return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  if (section == kForce) return tr("Force");
  return section == winnerColumn() ? tr("Winner") : tr("Why");
}

}  // namespace tactus::workbench
