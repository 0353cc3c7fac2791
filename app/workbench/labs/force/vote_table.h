// Table 2 of the study as a table: a row for each force, with the votes for each word, the winner and the reason.
#pragma once

#include <QString>
#include <string>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/force/force_lab.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::workbench {

// The reasons of the vote and the methods of the force terms, in words.

/// In a word or two: `majority`, `tie, the higher wins`; with what was done afterwards: `majority, raised`.
QString reasonText(const elicitation::VoteStep& step);
/// The rule behind it, one sentence.
QString reasonRule(const elicitation::VoteStep& step);

/// `Vote`, `Frequency`, `Thresholds`, `Probit`.
QString methodName(elicitation::ForceTermsFrom from);
/// How the method comes to its terms, one sentence.
QString methodRule(elicitation::ForceTermsFrom from);

/// `ascending`, `descending`, `random` for the screen; any other name unchanged.
QString seriesText(const std::string& series);

class VoteTable : public Columns<elicitation::VoteStep> {
 public:
  static constexpr int kForce = 0;
  static constexpr int kFirstWord = 1;
  static constexpr int kShareRole = Qt::UserRole;     ///< double: share of the votes at this force
  static constexpr int kWinsRole = Qt::UserRole + 1;  ///< bool: the word of this column won

  explicit VoteTable(QObject* parent = nullptr) : Columns(parent) {}

  void setVotes(const ForceVotes& votes);
  int words() const { return static_cast<int>(words_.terms.size()); }
  int winnerColumn() const { return kFirstWord + words(); }
  /// The id of the word of a column; empty for the other columns.
  std::string wordAt(int column) const;
  int reasonColumn() const { return winnerColumn() + 1; }

 private:
  fuzzy::Variable words_;
};

}  // namespace tactus::workbench
