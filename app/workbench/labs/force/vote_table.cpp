#include "app/workbench/labs/force/vote_table.h"

#include <QCoreApplication>
#include <numeric>
#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using elicitation::ForceTermsFrom;
using elicitation::VoteReason;

struct VoteWords {
  Q_DECLARE_TR_FUNCTIONS(VoteWords)
};

QString shortReason(VoteReason reason) {
  switch (reason) {
    case VoteReason::kMajority: return VoteWords::tr("half or more");
    case VoteReason::kTieHigher: return VoteWords::tr("tie, the higher wins");
    case VoteReason::kNextLevel: return VoteWords::tr("no half, next level");
    case VoteReason::kClamped: return VoteWords::tr("next level, limited");
    case VoteReason::kFirstMedian: return VoteWords::tr("median");
    case VoteReason::kNoVotes: return VoteWords::tr("no votes");
  }
  return {};
}

}  // namespace

QString reasonText(const elicitation::VoteStep& step) {
  QString out = shortReason(step.reason);
  if (elicitation::isUnsaid(step)) {
    out += VoteWords::tr(", nobody said it");
  } else if (!elicitation::isMostFrequent(step)) {
    out += VoteWords::tr(", not the most frequent");
  }
  if (step.monotone_raised) out += VoteWords::tr(", raised");
  if (step.below_quorum) out += VoteWords::tr(", below quorum");
  return out;
}

QString reasonRule(const elicitation::VoteStep& step) {
  QString out;
  switch (step.reason) {
    case VoteReason::kMajority: out = VoteWords::tr("One word has half of the votes or more."); break;
    case VoteReason::kTieHigher:
      out = VoteWords::tr("Two words have half of the votes each: the higher one wins.");
      break;
    case VoteReason::kNextLevel:
      out = VoteWords::tr("No word has half. The forces rise, so one word above that of the force before.");
      break;
    case VoteReason::kClamped:
      out =
          VoteWords::tr("No word has half. One word above that of the force before, moved into the words with votes.");
      break;
    case VoteReason::kFirstMedian:
      out = VoteWords::tr("No word has half and no force was decided before: the lower median.");
      break;
    case VoteReason::kNoVotes: out = VoteWords::tr("No participant chose a word."); break;
  }
  if (elicitation::isUnsaid(step)) {
    out += VoteWords::tr(" Nobody said this word here.");
  } else if (!elicitation::isMostFrequent(step)) {
    out += VoteWords::tr(" Another word was said more often.");
  }
  if (step.monotone_raised) out += VoteWords::tr(" Raised to the word of a smaller force: words must not fall.");
  if (step.below_quorum) out += VoteWords::tr(" Fewer than half of the participants voted.");
  return out;
}

QString methodName(ForceTermsFrom from) {
  switch (from) {
    case ForceTermsFrom::kVote: return VoteWords::tr("Vote");
    case ForceTermsFrom::kFrequency: return VoteWords::tr("Frequency");
    case ForceTermsFrom::kThresholds: return VoteWords::tr("Thresholds");
    case ForceTermsFrom::kProbit: return VoteWords::tr("Probit");
  }
  return {};
}

QString methodRule(ForceTermsFrom from) {
  switch (from) {
    case ForceTermsFrom::kVote: return VoteWords::tr("The winner of each force (the paper).");
    case ForceTermsFrom::kFrequency: return VoteWords::tr("The trapezoids closest to the shares of all answers.");
    case ForceTermsFrom::kThresholds: return VoteWords::tr("The mean of the participants' own limits.");
    case ForceTermsFrom::kProbit: return VoteWords::tr("Ordered probit over all answers.");
  }
  return {};
}

QString seriesText(const std::string& series) {
  if (series == "ascending") return VoteWords::tr("rising forces");
  if (series == "descending") return VoteWords::tr("falling forces");
  if (series == "random") return VoteWords::tr("random order");
  return harmless(text(series));
}

void VoteTable::setVotes(const ForceVotes& votes) {
  using Row = elicitation::VoteStep;
  words_ = votes.words;
  std::vector<Column<Row>> columns = {{VoteWords::tr("Force"),
                                       [this](const Row& row) { return quantityText(row.force_n, words_.unit); },
                                       Qt::AlignRight}};
  for (std::size_t i = 0; i < words_.terms.size(); ++i) {
    columns.push_back({initialsOf(labelOf(words_.terms[i])),
                       [i](const Row& row) { return QString::number(row.votes[i]); },
                       Qt::AlignHCenter,
                       labelOf(words_.terms[i]),
                       {{kShareRole,
                         [i](const Row& row) {
                           const int cast = std::accumulate(row.votes.begin(), row.votes.end(), 0);
                           return cast > 0 ? static_cast<double>(row.votes[i]) / cast : 0.0;
                         }},
                        {kWinsRole, [i](const Row& row) { return row.term == i; }}}});
  }
  const std::map<int, CellOf<Row>> rule = {{Qt::ToolTipRole, &reasonRule}};
  columns.push_back(
      {VoteWords::tr("Winner"),
       [this](const Row& row) { return row.term ? labelOf(words_.terms[*row.term]) : QStringLiteral("–"); },
       Qt::AlignLeft,
       {},
       rule});
  columns.push_back({VoteWords::tr("Why"), &reasonText, Qt::AlignLeft, {}, rule});
  setTable(std::move(columns), votes.steps);
}

std::string VoteTable::wordAt(int column) const {
  if (column < kFirstWord || column >= winnerColumn()) return {};
  return words_.terms[static_cast<std::size_t>(column - kFirstWord)].id;
}

}  // namespace tactus::workbench
