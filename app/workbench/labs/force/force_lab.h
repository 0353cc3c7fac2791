// The force lab without widgets: votes, words and checks of the open study, computed again when the study or a setting
// changes, and corrections of judgements.
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"
#include "elicitation/force/word_intervals.h"

namespace tactus::workbench {

// What the force lab shows of the vote: Table 2 with its winners, and the force terms by each method.

inline constexpr std::array kForceMethods = {
    elicitation::ForceTermsFrom::kVote, elicitation::ForceTermsFrom::kFrequency,
    elicitation::ForceTermsFrom::kThresholds, elicitation::ForceTermsFrom::kProbit};

/// One way from the judgements to the terms.
struct ForceMethod {
  elicitation::ForceTermsFrom from = elicitation::ForceTermsFrom::kVote;
  std::optional<elicitation::ForceTerms> terms;
  QString refusal;  ///< why there are no terms; empty if there are
};

struct ForceVotes {
  fuzzy::Variable words;  ///< the force with all its words, in order; its terms are the defaults
  std::vector<elicitation::VoteStep> steps;
  int enrolled = 0;  ///< participants of the study
  std::array<ForceMethod, kForceMethods.size()> methods;
  std::vector<elicitation::WordInterval> intervals;  ///< the forces that each participant called by each word
  QString refusal;                                   ///< why there is no vote; empty if there is one
};

/// The votes of `series`, as elicitation::buildModel counts them. `end_n`: end of the force universe, if it is given.
/// Thread: any.
ForceVotes forceVotes(const study::Study& study, const std::string& series, std::optional<double> end_n);

/// The series in `study`, by name; `ascending` first.
std::vector<std::string> seriesOf(const study::Study& study);

/// Thread: gui.
class ForceLab : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  ForceLab(LabData& data, LabModel& model, Corrections& corrections, QObject* parent = nullptr);

  const ForceVotes& votes() const { return found().votes; }
  const std::vector<ParticipantChecks>& checks() const { return found().checks; }
  /// Every judgement behind them.
  const std::vector<session::JudgedForce>& judgements() const;
  /// The series that can vote.
  const std::vector<std::string>& series() const { return found().series; }
  const elicitation::BuildSettings& settings() const { return data_.settings(); }
  Computation& work() { return found_; }
  const LabData& data() const { return data_; }

  /// Computes while wanted.
  void setWanted(bool wanted);

  void setMethod(elicitation::ForceTermsFrom from);
  /// The series that votes.
  void setSeries(const std::string& series);
  /// What taking the words of the force from `from` instead does to the averaged force: at most so many N. Empty for
  /// the present method, for one without words, and while it is not computed.
  QString effectOf(elicitation::ForceTermsFrom from) const;
  /// `effectOf` is being computed.
  bool isComparing() const { return effects_.isBusy(); }
  /// Asks how far the averaged force moves without `judged`; `influenceChanged` tells the answer, and again when the
  /// model has changed.
  void askInfluence(const session::JudgedForce& judged);
  /// The answer, one sentence; empty while there is none.
  QString influence() const { return influence_.value() ? *influence_.value() : QString(); }
  /// Stores another word for a judgement.
  void correct(const session::JudgedForce& judged, const session::JudgedWord& word);

 signals:
  /// What was computed, or a setting, is another one.
  void changed();
  void influenceChanged();
  void effectsChanged();

 private:
  struct Found {
    ForceVotes votes;
    std::vector<ParticipantChecks> checks;
    std::vector<std::string> series;
  };
  /// A judgement by its index in the study.
  struct Asked {
    BuiltStudy built;
    std::size_t index = 0;
    QString who;
  };
  const Found& found() const;
  std::optional<Asked> asked() const;

  LabData& data_;
  LabModel& model_;
  Corrections& corrections_;
  std::optional<session::JudgedForce> asked_;
  Computed<LabInputs, Found> found_;
  Computed<Asked, QString> influence_;
  Computed<BuiltStudy, std::map<elicitation::ForceTermsFrom, double>> effects_;  ///< N
};

// Table 2 of the study as a table: a row for each force, with the votes for each word, the winner and the reason.

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
  static constexpr int kShareRole = kOrderRole + 1;  ///< double: share of the votes at this force
  static constexpr int kWinsRole = kOrderRole + 2;   ///< bool: the word of this column won

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
