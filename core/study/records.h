// The plain records of a study that files exchange: participants, their strokes, judgements, answers and rules.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/study/table_line.h"

namespace tactus::procedure {
struct Procedure;
}

namespace tactus::study {

/// A participant: a random code, never a name.
struct Participant {
  std::string code;
  std::optional<double> years_experience;
  std::string category;    ///< e.g. beginner, intermediate, expert; may be empty
  std::string handedness;  ///< may be empty
  std::optional<double> weight;
  bool simulated = false;        ///< a program generated the data
  bool virtual_device = false;   ///< moved a device that gives no force: no judgement there counts
  bool setup_unchecked = false;  ///< moved a device whose set-up was not checked before
  TableLine line = {};

  bool operator==(const Participant&) const = default;
};

/// One sample of an insertion stroke.
struct SpeedSample {
  std::string participant;
  std::string level;  ///< term id of the requested speed
  int stroke = 0;     ///< from 1 within participant and level
  double time_s = 0;  ///< from the start of the stroke
  double depth_mm = 0;
  double speed_mm_s = 0;
  TableLine line = {};

  bool operator==(const SpeedSample&) const = default;
};

/// A participant's judgement of one force stimulus.
struct ForceJudgement {
  enum class Kind {
    kTerm,            ///< `term` holds the term id
    kNotFelt,         ///< `not_felt`
    kBeyondPractice,  ///< `beyond_practice`: larger than in real placements
    kNoAnswer,        ///< empty
  };
  std::string participant;
  std::string series;  ///< e.g. `ascending`
  int step = 0;        ///< from 1
  double force_n = 0;  ///< commanded force
  Kind kind = Kind::kNoAnswer;
  std::string term;
  TableLine line = {};

  bool operator==(const ForceJudgement&) const = default;
};

/// The answer to one item of a form.
struct Answer {
  enum class Status { kAnswered, kSkipped, kCantTell, kCleared };
  std::string participant;
  std::string form;  ///< form id
  int item = 0;      ///< the form's item number
  std::string term;  ///< term id; empty unless answered
  Status status = Status::kSkipped;
  TableLine line = {};
  std::string wording = {};  ///< id of the words in which the item was asked (questionnaires/); empty: not known

  bool operator==(const Answer&) const = default;
};

/// `input is term`, a condition of an item or rule.
struct ItemCondition {
  std::string input;
  std::string term;

  bool operator==(const ItemCondition&) const = default;
};

/// A rule given directly, as in Table A2 of the paper, instead of by answers.
struct GivenRule {
  std::string participant;
  std::string form;  ///< id of the reading or form with the rule's depth terms; empty: unknown
  std::vector<ItemCondition> conditions;
  std::string then;
  double weight = 1;
  TableLine line = {};

  bool operator==(const GivenRule&) const = default;
};

/// One item of a form: its wording and its condition.
struct FormItem {
  int number = 0;
  std::string text;  ///< verbatim; empty: composed by the wording
  std::vector<ItemCondition> conditions;

  bool operator==(const FormItem&) const = default;
};

/// The condition of an item about the tool on its way back out. No input of a model: the answer is no rule.
inline const ItemCondition kWayOut{"direction", "out"};

inline bool isWayOut(const FormItem& item) {
  return std::find(item.conditions.begin(), item.conditions.end(), kWayOut) != item.conditions.end();
}

/// One answer box of a form: its word, and the id of its output term.
struct AnswerWord {
  std::string word;  ///< verbatim
  std::string term;

  bool operator==(const AnswerWord&) const = default;
};

/// A form with answers that become rules.
struct Form {
  std::string id;
  int version = 1;
  std::string title;
  std::string source;               ///< origin of the wording
  std::string depth_terms;          ///< id of the set of terms of the way that the form knows
  std::vector<AnswerWord> answers;  ///< from the smallest force to the largest
  std::vector<FormItem> items;

  bool operator==(const Form&) const = default;
};

/// The data of one study for elicitation.
struct Study {
  std::string name;
  std::vector<Participant> participants;
  std::vector<SpeedSample> speeds;
  std::vector<ForceJudgement> judgements;
  std::vector<Answer> answers;
  std::vector<GivenRule> rules;
  /// What the study is about (core/procedure/procedure.h); null: nasogastric tube insertion.
  std::shared_ptr<const procedure::Procedure> procedure = {};

  bool operator==(const Study&) const = default;
};

}  // namespace tactus::study
