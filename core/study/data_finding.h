// Findings in the data of a study, for review before use.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "core/study/table_line.h"

namespace tactus::study {

/// One finding about the data of one participant. Each kind occurs at most once per participant.
struct DataFinding {
  enum class Severity {
    kNote,     ///< worth knowing; may well be right
    kWarning,  ///< probably a mistake that changes the model
    kRefused,  ///< certainly a mistake; no model is built from the data
  };
  enum class Kind {
    // participants
    kCodesAlike,
    kCodeLikeName,
    kYearsUnlikely,
    kWithoutStrokes,
    kWithoutJudgements,
    kWithoutAnswers,
    kSimulatedAndReal,
    kVirtualDevice,
    kSetupUnchecked,
    kSummaryRow,
    kCodeLikeDate,
    kWeightsMixed,
    // strokes
    kUnknownLevel,
    kLevelWithoutStrokes,
    kStrokesMissing,
    kStrokeTooShort,
    kSamplesMissing,
    kSpeedUnit,
    kDepthUnit,
    kTimeUnit,
    kSeveralUnits,
    kColumnsSwapped,
    kSpeedSign,
    kSpeedAgainstDepth,
    kSpeedScale,
    kDepthFalls,
    kWithdrawal,
    kNoTimes,
    kNoDepths,
    kRowsTwice,
    kRowsBackwards,
    kRowsUnsorted,
    kStrokeTwice,
    kStrokeCopied,
    kConstantSpeed,
    kOutliers,
    kLevelsSwapped,
    // judgements
    kUnknownSeries,
    kUnknownForceTerm,
    kForceUnit,
    kScaleReversed,
    kOneWord,
    kTermsFall,
    kBeyondTooEarly,
    kNotFeltAboveFelt,
    kForceOrder,
    kSeriesDiffer,
    kRepeatsDiffer,
    kBlanksFelt,
    kJudgementsCopied,
    // answers
    kUnknownAnswerTerm,
    kUnknownItem,
    kOneAnswer,
    kAnswerPattern,
    kAnswersReversed,
    kAnswersCopied,
    kAnswersShifted,
    kWordingsMixed,
    // rules
    kOneConsequent,
    kRulesCopied,
  };

  Kind kind = Kind::kCodesAlike;
  Severity severity = Severity::kNote;
  std::string participant;  ///< code; empty if the finding concerns the study
  TableCell cell;           ///< the first affected row; line 0 if the data do not come from a table
  std::string sentence;     ///< complete, with the remedy; without table and line
  std::string found;        ///< kRefused only: for the error
  std::string wanted;       ///< kRefused only: the remedy, for the error
};

/// Puts `more` behind `findings`.
void append(std::vector<DataFinding>& findings, std::vector<DataFinding> more);

/// The id of a kind, for JSON: `speed_unit`, `rows_twice`, …
std::string_view name(DataFinding::Kind kind) noexcept;

/// `note`, `warning`, `refused`.
std::string_view name(DataFinding::Severity severity) noexcept;

/// `speeds.csv, line 12: ` and the sentence. Only the sentence if the data do not come from a table.
std::string text(const DataFinding& finding);

/// Makes a kRefused finding. `what`: a clause ("the speeds of S2 are …"). `remedy`: an instruction ("multiply … by
/// 10").
DataFinding refusal(DataFinding::Kind kind, std::string participant, TableCell cell, const std::string& what,
                    const std::string& remedy);

/// The kinds that can be refused though the data are right: an unusual unit, an unusual person. Words that the study
/// does not have are none of them, because no model can be built of those.
inline constexpr std::array<DataFinding::Kind, 8> kAcceptable = {
    DataFinding::Kind::kSpeedUnit,    DataFinding::Kind::kDepthUnit,      DataFinding::Kind::kTimeUnit,
    DataFinding::Kind::kSeveralUnits, DataFinding::Kind::kColumnsSwapped, DataFinding::Kind::kSpeedSign,
    DataFinding::Kind::kForceUnit,    DataFinding::Kind::kYearsUnlikely};

/// The one of kAcceptable with this id, or nothing.
std::optional<DataFinding::Kind> acceptableKind(std::string_view id) noexcept;

/// Whether a person said of a refused finding that the data are right as they are: its kind is in `accepted`.
bool isAccepted(const DataFinding& finding, std::span<const DataFinding::Kind> accepted) noexcept;

/// The error of the first finding that is refused and not accepted, which says how many more there are; success where
/// there is none.
base::Result<void> refuseData(const std::vector<DataFinding>& findings,
                              std::span<const DataFinding::Kind> accepted = {});

// Findings about a record of a study: where it stands in its table, and whose it is.

inline TableCell cellOf(const Participant& record, std::string_view column) {
  return {kParticipantsTable, record.line, column};
}
inline TableCell cellOf(const SpeedSample& record, std::string_view column) {
  return {kSpeedsTable, record.line, column};
}
inline TableCell cellOf(const ForceJudgement& record, std::string_view column) {
  return {kJudgementsTable, record.line, column};
}
inline TableCell cellOf(const Answer& record, std::string_view column) { return {kAnswersTable, record.line, column}; }
inline TableCell cellOf(const GivenRule& record, std::string_view column) { return {kRulesTable, record.line, column}; }

inline const std::string& codeOf(const Participant& record) { return record.code; }
template <class Record>
const std::string& codeOf(const Record& record) {
  return record.participant;
}

/// A note or a warning about `record`; for what is refused: `refusal`.
template <class Record>
DataFinding remark(DataFinding::Kind kind, DataFinding::Severity severity, const Record& record,
                   std::string_view column, std::string sentence) {
  return {kind, severity, codeOf(record), cellOf(record, column), std::move(sentence), {}, {}};
}

}  // namespace tactus::study
