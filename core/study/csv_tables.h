// The CSV tables of a study: participants, speeds, judgements, answers, rules. For people: docs/csv-tables.md.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"

namespace tactus::study {

/// A study read from a folder, and what was passed over.
struct StudyTables {
  Study study;
  std::vector<std::string> notes;         ///< one sentence each: tables that are absent, columns that were ignored
  std::vector<std::string> notices = {};  ///< of the opening of a study file (store::StudyFile); none of a folder
};

/// Reads the tables of `folder`; the study takes the folder's name, each record keeps its line. `participants.csv` must
/// be there; each other table may be absent. A table may also be called `Speeds.CSV`, `speeds.txt` or `speeds.tsv`
/// where it is the only one of that name; columns may be written as people do (base::columnKey), and optional ones may
/// be absent (csv_columns.h), each with a note. Refused: a missing column, a value of the wrong kind (with file, line
/// and column), a step or stroke below 1, a force below 0, a participant, an answer, a judgement or a rule twice, a row
/// of an unknown participant. Terms and levels are kept as text: elicitation knows which there are. Columns, one table
/// each:
///   participants.csv  participant,years_experience,category,handedness,weight,simulated
///   speeds.csv        participant,level,stroke,time_s,depth_mm,speed_mm_s
///   judgements.csv    participant,series,step,force_n,term
///   answers.csv       participant,form,item,term,status
///   rules.csv         participant, one column per input id, then,weight; and, if it likes, form
/// `input_ids` are the inputs that rules.csv may use, its other columns are ignored; empty: all its columns are inputs.
base::Result<StudyTables> readStudyFolder(const std::string& folder, const std::vector<std::string>& input_ids = {});

/// The participants of one table `participants.csv`.
base::Result<std::vector<Participant>> readParticipants(const base::CsvTable& table);

/// The speeds of one table `speeds.csv`. Participants are not looked up.
base::Result<std::vector<SpeedSample>> readSpeeds(const base::CsvTable& table);

/// The judgements of one table `judgements.csv`. Participants are not looked up.
base::Result<std::vector<ForceJudgement>> readJudgements(const base::CsvTable& table);

/// The answers of one table `answers.csv`. Participants are not looked up.
base::Result<std::vector<Answer>> readAnswers(const base::CsvTable& table);

/// The rules of one table `rules.csv`, with `input_ids` as above. Participants are not looked up.
base::Result<std::vector<GivenRule>> readRules(const base::CsvTable& table,
                                               const std::vector<std::string>& input_ids = {});

/// Writes the five tables of `study` into `folder`, each whole or not at all; a table without rows holds its header, so
/// that nothing of an older study stays. `input_ids` are the input columns of rules.csv; a rule about another input is
/// an error. The study's name is not written.
base::Result<void> writeStudyFolder(const Study& study, const std::vector<std::string>& input_ids,
                                    const std::string& folder);

}  // namespace tactus::study
