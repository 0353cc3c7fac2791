// What to look at in the data of a study before its numbers are believed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/table_line.h"

namespace tactus::study {

/// One thing about the data of one participant. There is at most one finding of a kind for a participant.
struct DataFinding {
  enum class Severity {
    kNote,     ///< worth knowing; can well be right
    kWarning,  ///< probably a mistake, and it changes the model
    kRefused,  ///< cannot be meant; no model is built of it
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
    // rules
    kOneConsequent,
    kRulesCopied,
  };

  Kind kind = Kind::kCodesAlike;
  Severity severity = Severity::kNote;
  std::string participant;  ///< code; empty where the finding is about the study
  TableCell cell;           ///< the first row concerned; the line is 0 where the data come from no table
  std::string sentence;     ///< whole, with the remedy; it says neither table nor line
  std::string found;        ///< kRefused only: for the error
  std::string wanted;       ///< kRefused only: the remedy, for the error
};

/// Puts `more` behind `findings`.
void append(std::vector<DataFinding>& findings, std::vector<DataFinding> more);

/// The id of a kind, for JSON: `speed_unit`, `rows_twice`, …
std::string_view name(DataFinding::Kind kind) noexcept;

/// `note`, `warning`, `refused`.
std::string_view name(DataFinding::Severity severity) noexcept;

/// `speeds.csv, line 12: ` and the sentence; where the data come from no table, the sentence alone.
std::string text(const DataFinding& finding);

/// A finding of kRefused of the clause `what` ("the speeds of S2 are …"), with `remedy` ("multiply … by 10").
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

}  // namespace tactus::study
