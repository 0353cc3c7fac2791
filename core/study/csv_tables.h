// The CSV tables of a study: participants, speeds, judgements, answers, rules. User documentation: docs/csv-tables.md.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"

namespace tactus::study {

// Words that stand below a table of data, in the place of a code.

/// Whether `word` heads a line that sums a table up: `Mean`, `SD`, `Total`, `n=4`, `Mittelwert`, … Capitals and what is
/// neither a letter nor a digit do not count.
bool isSummaryWord(std::string_view word);

// The columns of a study's tables. Their order in a file is free.

inline constexpr std::array<std::string_view, 6> kParticipantColumns = {"participant", "years_experience", "category",
                                                                        "handedness",  "weight",           "simulated"};
inline constexpr std::array<std::string_view, 6> kSpeedColumns = {"participant", "level",    "stroke",
                                                                  "time_s",      "depth_mm", "speed_mm_s"};
inline constexpr std::array<std::string_view, 5> kJudgementColumns = {"participant", "series", "step", "force_n",
                                                                      "term"};
/// `wording` is written only where one is known.
inline constexpr std::array<std::string_view, 6> kAnswerColumns = {"participant", "form",   "item",
                                                                   "term",        "status", "wording"};
/// rules.csv also has one column per input and optionally `form`.
inline constexpr std::array<std::string_view, 3> kRuleColumns = {"participant", "then", "weight"};

/// Columns that may be absent, and the meaning of their absence; empty: as usual, and nothing is said of it. rules.csv
/// may lack some input columns, but not all.
struct OptionalColumn {
  std::string_view table, column, meaning;
};
inline constexpr std::array<OptionalColumn, 9> kOptionalColumns = {{
    {"participants.csv", "years_experience", "not known"},
    {"participants.csv", "category", "not known"},
    {"participants.csv", "handedness", "not known"},
    {"participants.csv", "weight", "not set"},
    {"participants.csv", "simulated", "the data count as given by persons"},
    {"judgements.csv", "series", "all judgements count as 'ascending'"},
    {"answers.csv", "status", "an item with a term counts as answered, others as skipped"},
    {"answers.csv", "wording", ""},
    {"rules.csv", "weight", "each rule has the weight 1"},
}};

/// A study read from a folder, with notes on everything ignored.
struct StudyTables {
  Study study;
  std::vector<std::string> notes;         ///< one sentence each: tables that are absent, columns that were ignored
  std::vector<std::string> notices = {};  ///< of the opening of a study file (store::StudyFile); none of a folder
};

/// Where a table lies below the folder of a data set for publication in the layout of Psych-DS (app/dataset):
/// `data/study-ngt_description-strokes_data.csv` for speeds.csv.
std::string publishedTable(std::string_view table);

/// Reads the tables of `folder`. The study gets the folder's name; each record keeps its line number.
/// `participants.csv` must exist; each other table may be absent. A table may also be called `Speeds.CSV`, `speeds.txt`
/// or `speeds.tsv` if it is the only one of that name, or lie at its `publishedTable`. Column names may vary in
/// spelling (base::columnKey). Optional columns may be absent (csv_tables.h), each with a note.
/// Returns an error for: a missing column, a value of the wrong kind (with file, line and column), a step or stroke
/// below 1, a force below 0, a duplicate participant, answer, judgement or rule, a row of an unknown participant. Terms
/// and levels stay text, because only elicitation knows the valid ones.
/// Columns, one table each:
///   participants.csv  participant,years_experience,category,handedness,weight,simulated
///   speeds.csv        participant,level,stroke,time_s,depth_mm,speed_mm_s
///   judgements.csv    participant,series,step,force_n,term
///   answers.csv       participant,form,item,term,status
///   rules.csv         participant, one column per input id, then,weight; optionally form
/// `input_ids`: the inputs that rules.csv may use; other columns are ignored. Empty: all columns are inputs.
base::Result<StudyTables> readStudyFolder(const std::string& folder, const std::vector<std::string>& input_ids = {});

/// The participants of one table `participants.csv`.
base::Result<std::vector<Participant>> readParticipants(const base::CsvTable& table);

/// The speeds of one table `speeds.csv`. Does not check the participants.
base::Result<std::vector<SpeedSample>> readSpeeds(const base::CsvTable& table);

/// The judgements of one table `judgements.csv`. Does not check the participants.
base::Result<std::vector<ForceJudgement>> readJudgements(const base::CsvTable& table);

/// The answers of one table `answers.csv`. Does not check the participants.
base::Result<std::vector<Answer>> readAnswers(const base::CsvTable& table);

/// The rules of one table `rules.csv`, with `input_ids` as in readStudyFolder. Does not check the participants.
base::Result<std::vector<GivenRule>> readRules(const base::CsvTable& table,
                                               const std::vector<std::string>& input_ids = {});

/// The cell `term` of judgements.csv, and the cell `status` of answers.csv.
std::string_view judgementText(const ForceJudgement& judgement);
std::string_view statusText(Answer::Status status);

/// Writes the five tables of `study` into `folder`, each completely or not at all. A table without rows has its header,
/// so that no table of an older study remains. `input_ids`: the input columns of rules.csv; a rule with another input
/// is an error. The study's name is not written.
base::Result<void> writeStudyFolder(const Study& study, const std::vector<std::string>& input_ids,
                                    const std::string& folder);

}  // namespace tactus::study
