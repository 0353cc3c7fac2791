// What to look at in the data of a study before its numbers are believed.
#pragma once

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
  };

  Kind kind = Kind::kCodesAlike;
  Severity severity = Severity::kNote;
  std::string participant;  ///< code; empty where the finding is about the study
  TableCell cell;           ///< the first row concerned; the line is 0 where the data come from no table
  std::string sentence;     ///< whole, with the remedy; it says neither table nor line
  std::string found;        ///< kRefused only: for the error
  std::string wanted;       ///< kRefused only: the remedy, for the error
};

/// The id of a kind, for JSON: `speed_unit`, `rows_twice`, …
std::string_view name(DataFinding::Kind kind) noexcept;

/// `note`, `warning`, `refused`.
std::string_view name(DataFinding::Severity severity) noexcept;

/// `speeds.csv, line 12: ` and the sentence; where the data come from no table, the sentence alone.
std::string text(const DataFinding& finding);

/// A finding of kRefused of the clause `what` ("the speeds of S2 are …"), with `remedy` ("multiply … by 10").
DataFinding refusal(DataFinding::Kind kind, std::string participant, TableCell cell, const std::string& what,
                    const std::string& remedy);

/// The error of the first finding that is refused, which says how many more there are; success where there is none.
base::Result<void> refuseData(const std::vector<DataFinding>& findings);

}  // namespace tactus::study
