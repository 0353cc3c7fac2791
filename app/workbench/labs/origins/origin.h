// Where a number of a model comes from: the trials and answers of the study behind it, as rows for the screen.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/workbench/labs/data/lab_study.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/record_influence.h"
#include "elicitation/tracing/sources.h"

namespace tactus::workbench {

/// Vertex `point` of a term of the shared list. `shown`: its value where it was asked about; empty: in the study's
/// model.
struct VertexQuestion {
  std::string variable;
  std::string term;
  std::size_t point = 0;
  std::optional<double> shown = {};
};

/// The votes at a force, for one word or for all of them (empty).
struct VoteQuestion {
  double force_n = 0;
  std::string word;
};

/// A rule of an expert, found by its conditions: an edited model counts its rules in another way.
struct RuleQuestion {
  std::string expert;
  fuzzy::Rule rule;
};

/// The averaged force at a point. `shown_n`: as it was asked about.
struct ForceQuestion {
  std::vector<double> inputs;
  std::optional<double> shown_n = {};
};

using OriginQuestion = std::variant<VertexQuestion, VoteQuestion, RuleQuestion, ForceQuestion>;

/// One record behind the number.
struct OriginRecord {
  enum class Kind { kStroke, kJudgement, kAnswer, kGivenRule };

  Kind kind = Kind::kStroke;
  elicitation::StrokeKey stroke;                    ///< of kStroke
  std::size_t index = 0;                            ///< in Study::judgements, answers or rules
  std::optional<elicitation::RulePlace> rule = {};  ///< that an answer or a given rule became
  QString participant;
  QString what;  ///< `fast, stroke 2`, `0.4 N, step 4`, `item 12`
  QString says;  ///< `mean 54 mm/s`, `Large`
};

struct Origin {
  QString title;      ///< the number: `Speed, Medium: left foot 51.5 mm/s`
  QStringList notes;  ///< sentences: other values on the screen, parts without records, simulated data
  std::vector<OriginRecord> records;
};

/// `built` was made from `study` with `settings`. Thread: any.
Origin originOf(const OriginQuestion& question, const elicitation::BuiltModel& built, const LabStudy& study,
                const elicitation::BuildSettings& settings);

/// What the averaged force would be without a record of an Origin. Thread: any.
base::Result<elicitation::RecordInfluence> influenceOf(const OriginRecord& record, const elicitation::BuiltModel& built,
                                                       const LabStudy& study,
                                                       const elicitation::BuildSettings& settings);

}  // namespace tactus::workbench
