#include "app/session/table_words.h"

#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "core/base/tables/odd_cell.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"
#include "experiments/force_series.h"

namespace tactus::session {
namespace {

using JudgementKind = study::ForceJudgement::Kind;

/// Ids of one kind, and the words that stood for them.
class Words {
 public:
  explicit Words(std::string_view table) : table_(table) {}

  void add(const std::string& id) { ids_[base::columnKey(id)] = id; }
  /// Another word for an id.
  void add(const std::string& word, const std::string& id) { ids_[word] = id; }
  void add(const std::vector<fuzzy::Term>& terms) {
    for (const auto& term : terms) add(term.id);
  }

  /// The id that `word` stands for; `word` itself where it is one, or none.
  std::string read(const std::string& word) {
    const auto id = ids_.find(base::columnKey(word));
    if (word.empty() || id == ids_.end() || id->second == word) return word;
    ++read_[{word, id->second}];
    return id->second;
  }

  /// Whether `word` stands where there is no term; that is noted too.
  bool isMissing(const std::string& word) {
    const bool missing = base::isMissingWord(word);
    if (missing) ++read_[{word, "no answer"}];
    return missing;
  }

  void addNotes(std::vector<std::string>& notes) const {
    for (const auto& [word, rows] : read_) {
      notes.push_back(std::string(table_) + ": " + base::quoted(word.first) + " is read as " + word.second + " in " +
                      std::to_string(rows) + (rows == 1 ? " row." : " rows."));
    }
  }

 private:
  std::string_view table_;
  std::map<std::string, std::string> ids_;
  std::map<std::pair<std::string, std::string>, std::size_t> read_;
};

/// What people call a series.
constexpr std::array<std::pair<const char*, const char*>, 17> kSeriesWords = {
    {{"asc", experiments::kAscending},
     {"ascend", experiments::kAscending},
     {"ascending_series", experiments::kAscending},
     {"increasing", experiments::kAscending},
     {"rising", experiments::kAscending},
     {"up", experiments::kAscending},
     {"upward", experiments::kAscending},
     {"upwards", experiments::kAscending},
     {"aufsteigend", experiments::kAscending},
     {"desc", experiments::kDescending},
     {"descend", experiments::kDescending},
     {"descending_series", experiments::kDescending},
     {"decreasing", experiments::kDescending},
     {"falling", experiments::kDescending},
     {"down", experiments::kDescending},
     {"absteigend", experiments::kDescending},
     {"random_order", experiments::kRandom}}};

void readJudgements(study::Study& study, std::vector<std::string>& notes) {
  Words series(study::kJudgementsTable);
  for (const char* id : {experiments::kAscending, experiments::kDescending, experiments::kRandom}) series.add(id);
  for (const auto& [word, id] : kSeriesWords) series.add(word, id);
  Words terms(study::kJudgementsTable);
  terms.add(procedure::of(study).output.terms);
  terms.add("not_felt");
  terms.add("beyond_practice");
  for (auto& row : study.judgements) {
    row.series = series.read(row.series);
    if (row.kind != JudgementKind::kTerm) continue;
    if (terms.isMissing(row.term)) {
      row.kind = JudgementKind::kNoAnswer;
      row.term.clear();
      continue;
    }
    row.term = terms.read(row.term);
    if (row.term == "not_felt") row.kind = JudgementKind::kNotFelt;
    if (row.term == "beyond_practice") row.kind = JudgementKind::kBeyondPractice;
    if (row.kind != JudgementKind::kTerm) row.term.clear();
  }
  series.addNotes(notes);
  terms.addNotes(notes);
}

void readRules(study::Study& study, std::vector<std::string>& notes) {
  std::map<std::string, Words> conditions;
  const procedure::Procedure& about = procedure::of(study);
  for (const auto& input : about.inputs) {
    auto& words = conditions.try_emplace(input.id, study::kRulesTable).first->second;
    words.add(input.terms);
    if (input.id != about.wayInput().id) continue;
    for (const auto& set : about.way_terms) words.add(set.terms);
  }
  Words then(study::kRulesTable);
  then.add(about.output.terms);
  for (auto& rule : study.rules) {
    rule.then = then.read(rule.then);
    for (auto& condition : rule.conditions) {
      const auto words = conditions.find(condition.input);
      if (words != conditions.end()) condition.term = words->second.read(condition.term);
    }
  }
  for (const auto& [input, words] : conditions) words.addNotes(notes);
  then.addNotes(notes);
}

}  // namespace

std::vector<std::string> readWords(study::Study& study) {
  std::vector<std::string> notes;
  Words levels(study::kSpeedsTable);
  if (const auto* const rate = procedure::of(study).rateInput()) levels.add(rate->terms);
  for (auto& sample : study.speeds) sample.level = levels.read(sample.level);
  levels.addNotes(notes);
  readJudgements(study, notes);
  Words answers(study::kAnswersTable);
  answers.add(procedure::of(study).output.terms);
  for (auto& answer : study.answers) {
    if (answer.status == study::Answer::Status::kAnswered && answers.isMissing(answer.term)) {
      answer.status = study::Answer::Status::kSkipped;
      answer.term.clear();
    }
    answer.term = answers.read(answer.term);
  }
  answers.addNotes(notes);
  readRules(study, notes);
  return notes;
}

base::Result<std::vector<study::ForceJudgement>> readJudgementTable(const base::CsvTable& table,
                                                                    std::vector<std::string>& notes) {
  study::Study study;
  auto rows = study::readJudgements(table);
  if (!rows) return rows;
  study.judgements = std::move(*rows);
  const auto read = readWords(study);
  notes.insert(notes.end(), read.begin(), read.end());
  return std::move(study.judgements);
}

base::Result<std::vector<study::Answer>> readAnswerTable(const base::CsvTable& table, std::vector<std::string>& notes) {
  study::Study study;
  auto rows = study::readAnswers(table);
  if (!rows) return rows;
  study.answers = std::move(*rows);
  const auto read = readWords(study);
  notes.insert(notes.end(), read.begin(), read.end());
  return std::move(study.answers);
}

}  // namespace tactus::session
