#include "core/study/csv_tables.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/study/record_id.h"

namespace tactus::study {

bool isSummaryWord(std::string_view word) {
  static constexpr std::array<std::string_view, 21> kWords = {
      "average", "anzahl", "count",   "durchschnitt", "gesamt",  "maximum", "mean",
      "mean_sd", "median", "minimum", "mittelwert",   "mw",      "overall", "sd",
      "stabw",   "std",    "stdev",   "sum",          "summary", "summe",   "total"};
  std::string key = base::columnKey(word);
  while (!key.empty() && (base::isDigit(key.back()) || key.back() == '_')) key.pop_back();
  // `n=4` and `N = 12`; a code `N4` is one.
  if (key == "n") return word.find('=') != std::string_view::npos;
  const bool has_number = key.size() != base::columnKey(word).size();
  return !has_number && std::find(kWords.begin(), kWords.end(), key) != kWords.end();
}

// A folder of tables becomes one study: which tables are there, and whether they speak of the same participants.

namespace {

namespace fs = std::filesystem;
using base::CsvTable;
using base::ErrorCode;
using base::Result;

/// Reads the tables of one folder and collects the notes.
class FolderReader {
 public:
  explicit FolderReader(fs::path folder) : folder_(std::move(folder)) {}

  /// Reads the table `name` with `read`. `known` are the columns that have a meaning, empty when all have.
  template <class Read>
  auto table(std::string_view name, std::span<const std::string_view> known, Read read)
      -> decltype(read(std::declval<const CsvTable&>())) {
    TACTUS_TRY(const auto path, fileOf(name));
    if (path.empty()) {
      absent_.push_back(std::string(name) + besides(name));
      return {};
    }
    if (path.filename() != name) {
      notes_.push_back(std::string(name) + ": read from " + base::quoted(path.filename().string()) + ".");
    }
    TACTUS_TRY(const auto csv, CsvTable::read(path.string()));
    if (!csv.readAs().empty()) notes_.push_back(std::string(name) + ": read with " + csv.readAs() + ".");
    noteColumns(name, csv, known);
    auto records = read(csv);
    if (!records) return records;
    return checked(csv, std::move(*records));
  }

  void setParticipants(const std::vector<Participant>& participants) {
    for (const auto& participant : participants) codes_.insert(participant.code);
  }

  std::vector<std::string> takeNotes() {
    if (!absent_.empty()) {
      const std::string one =
          absent_.size() == 1 ? "Absent table, which counts as empty: " : "Absent tables, which count as empty: ";
      notes_.insert(notes_.begin(), one + base::joined(absent_, ", ") + ".");
    }
    return std::move(notes_);
  }

 private:
  /// ` (there is 'speeds (1).csv', which is not read)` where a file's name begins like that of the absent table.
  std::string besides(std::string_view name) const {
    const std::string stem = fs::path(name).stem().string();
    std::vector<std::string> like;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
      const std::string file = entry.path().filename().string();
      if (base::lowered(file).starts_with(stem) && entry.is_regular_file(ignored)) like.push_back(base::quoted(file));
    }
    if (like.empty()) return {};
    std::sort(like.begin(), like.end());
    return " (there is " + base::joined(like, ", ") + ", which is not read)";
  }

  /// The file that holds the table `name`, empty where there is none: of this name, or the only one whose name differs
  /// in capitals or ends in .txt or .tsv.
  Result<fs::path> fileOf(std::string_view name) const {
    std::error_code ignored;
    const fs::path exact = folder_ / name;
    if (fs::exists(exact, ignored)) return exact;
    const std::string stem = fs::path(name).stem().string();
    std::vector<fs::path> like;
    for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
      const std::string ending = base::lowered(entry.path().extension().string());
      const bool is_table = ending == ".csv" || ending == ".txt" || ending == ".tsv";
      if (is_table && base::lowered(entry.path().stem().string()) == stem) like.push_back(entry.path());
    }
    if (like.empty()) {
      const fs::path published = folder_ / publishedTable(name);
      return fs::exists(published, ignored) ? published : fs::path();
    }
    if (like.size() == 1) return like.front();
    std::sort(like.begin(), like.end());
    return tl::unexpected(
        base::Error{ErrorCode::kSchema,
                    folder_.string(),
                    {},
                    base::quoted(like[0].filename().string()) + " and " + base::quoted(like[1].filename().string()),
                    "one table " + std::string(name)});
  }

  /// Columns that are ignored, that are written another way, and optional ones that are absent.
  void noteColumns(std::string_view name, const CsvTable& csv, std::span<const std::string_view> known) {
    if (known.empty()) return;
    std::vector<bool> used(csv.columns().size());
    std::vector<std::string> other;
    for (const auto column : known) {
      const auto at = csv.find(column);
      if (!at) continue;
      used[*at] = true;
      if (csv.columns()[*at] != column)
        other.push_back(base::quoted(csv.columns()[*at]) + " as " + std::string(column));
    }
    const std::string table(name);
    if (!other.empty()) notes_.push_back(table + ": reads the columns " + base::joined(other, ", ") + ".");
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) notes_.push_back(table + ": the column " + base::quoted(csv.columns()[i]) + " is ignored.");
    }
    std::vector<std::string> absent;
    for (const auto& optional : kOptionalColumns) {
      if (optional.table != name || optional.meaning.empty() || csv.find(optional.column)) continue;
      absent.push_back(std::string(optional.column) + " (" + std::string(optional.meaning) + ")");
    }
    if (!absent.empty()) notes_.push_back(table + ": without the columns " + base::joined(absent, ", ") + ".");
  }

  Result<std::vector<Participant>> checked(const CsvTable&, std::vector<Participant> participants) const {
    return participants;
  }

  /// Every record's participant must be known. Records stand in the order of the rows, one each.
  template <class Record>
  Result<std::vector<Record>> checked(const CsvTable& csv, std::vector<Record> records) const {
    const std::string* last = nullptr;
    for (std::size_t row = 0; row < records.size(); ++row) {
      const std::string& code = records[row].participant;
      // Rows of one participant stand together, so most need no look-up.
      if (last != nullptr && *last == code) continue;
      if (!codes_.contains(code)) {
        return csv.refuse(row, *csv.find("participant"), ErrorCode::kReference,
                          "a participant of participants.csv" + meantInstead(code));
      }
      last = &code;
    }
    return records;
  }

  /// `: 'P1'?` where that participant's code differs only in capitals, spaces, dashes or zeros.
  std::string meantInstead(const std::string& code) const {
    for (const auto& known : codes_) {
      if (codeKey(known) == codeKey(code)) return ": " + base::quoted(known) + "?";
    }
    return {};
  }

  fs::path folder_;
  std::unordered_set<std::string> codes_;
  std::vector<std::string> absent_;
  std::vector<std::string> notes_;
};

Result<void> checkFolder(const std::string& folder) {
  const auto refused = [&folder](std::string found) {
    return tl::unexpected(base::Error{ErrorCode::kIo, folder, {}, std::move(found), "a folder with participants.csv"});
  };
  std::error_code ignored;
  const auto status = fs::status(folder, ignored);
  if (!fs::exists(status)) return refused("nothing of this name");
  if (!fs::is_directory(status)) return refused("a file");
  std::string spreadsheet;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = base::lowered(entry.path().filename().string());
    if (name == "participants.csv" || name == "participants.txt" || name == "participants.tsv") return {};
    if (name.ends_with(".xlsx") || name.ends_with(".xls") || name.ends_with(".ods")) spreadsheet = name;
  }
  if (fs::exists(fs::path(folder) / publishedTable(kParticipantsTable), ignored)) return {};
  if (!spreadsheet.empty()) {
    return tl::unexpected(base::Error{ErrorCode::kIo,
                                      folder,
                                      {},
                                      "no participants.csv in it, but the spreadsheet " + base::quoted(spreadsheet),
                                      "a folder with participants.csv: save each sheet as CSV"});
  }
  return refused("no participants.csv in it");
}

std::string nameOf(const fs::path& folder) {
  // `.` and `..` have no name of their own; where the path cannot be made absolute it stays as it was given.
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error);
  const fs::path plain = (error ? folder : whole).lexically_normal();
  return (plain.has_filename() ? plain : plain.parent_path()).filename().string();
}

/// The columns of rules.csv that have a meaning; empty: all.
std::vector<std::string_view> knownRuleColumns(const std::vector<std::string>& input_ids) {
  if (input_ids.empty()) return {};
  std::vector<std::string_view> columns(kRuleColumns.begin(), kRuleColumns.end());
  columns.push_back("form");
  columns.insert(columns.end(), input_ids.begin(), input_ids.end());
  return columns;
}

}  // namespace

std::string publishedTable(std::string_view table) {
  // `study` and `description` are keys that Psych-DS knows.
  const std::string word = table == kSpeedsTable ? "strokes" : fs::path(table).stem().string();
  return "data/study-ngt_description-" + word + "_data.csv";
}

Result<StudyTables> readStudyFolder(const std::string& folder, const std::vector<std::string>& input_ids) {
  if (const auto there = checkFolder(folder); !there) return tl::unexpected(there.error());

  FolderReader reader(folder);
  StudyTables tables;
  Study& study = tables.study;
  study.name = nameOf(folder);
  TACTUS_TRY(auto participants, reader.table(kParticipantsTable, kParticipantColumns, readParticipants));
  study.participants = std::move(participants);
  reader.setParticipants(study.participants);

  TACTUS_TRY(auto speeds, reader.table(kSpeedsTable, kSpeedColumns, readSpeeds));
  study.speeds = std::move(speeds);
  TACTUS_TRY(auto judgements, reader.table(kJudgementsTable, kJudgementColumns, readJudgements));
  study.judgements = std::move(judgements);
  TACTUS_TRY(auto answers, reader.table(kAnswersTable, kAnswerColumns, readAnswers));
  study.answers = std::move(answers);
  auto rules = reader.table(kRulesTable, knownRuleColumns(input_ids),
                            [&input_ids](const CsvTable& csv) { return readRules(csv, input_ids); });
  if (!rules) return tl::unexpected(rules.error());
  study.rules = std::move(*rules);

  tables.notes = reader.takeNotes();
  return tables;
}

// A study becomes a folder of tables.

namespace {

using base::CsvWriter;

CsvWriter& amount(CsvWriter& csv, const std::optional<double>& value) {
  return value ? csv.cell(*value) : csv.cell(std::string_view());
}

std::string participantsText(const std::vector<Participant>& participants) {
  CsvWriter csv({"participant", "years_experience", "category", "handedness", "weight", "simulated"});
  for (const auto& participant : participants) {
    csv.cell(participant.code);
    amount(csv, participant.years_experience).cell(participant.category).cell(participant.handedness);
    amount(csv, participant.weight).cell(participant.simulated ? 1 : 0).endRow();
  }
  return csv.text();
}

std::string speedsText(const std::vector<SpeedSample>& speeds) {
  CsvWriter csv({"participant", "level", "stroke", "time_s", "depth_mm", "speed_mm_s"});
  for (const auto& sample : speeds) {
    csv.cell(sample.participant).cell(sample.level).cell(sample.stroke);
    csv.cell(sample.time_s).cell(sample.depth_mm).cell(sample.speed_mm_s).endRow();
  }
  return csv.text();
}

std::string judgementsText(const std::vector<ForceJudgement>& judgements) {
  CsvWriter csv({"participant", "series", "step", "force_n", "term"});
  for (const auto& judgement : judgements) {
    csv.cell(judgement.participant).cell(judgement.series).cell(judgement.step);
    csv.cell(judgement.force_n).cell(judgementText(judgement)).endRow();
  }
  return csv.text();
}

std::string answersText(const std::vector<Answer>& answers) {
  const bool worded = std::any_of(answers.begin(), answers.end(), [](const auto& one) { return !one.wording.empty(); });
  std::vector<std::string> columns(kAnswerColumns.begin(), kAnswerColumns.end());
  if (!worded) columns.pop_back();
  CsvWriter csv{std::span<const std::string>(columns)};
  for (const auto& answer : answers) {
    csv.cell(answer.participant).cell(answer.form).cell(answer.item);
    csv.cell(answer.term).cell(statusText(answer.status));
    if (worded) csv.cell(answer.wording);
    csv.endRow();
  }
  return csv.text();
}

std::string_view termOf(const GivenRule& rule, const std::string& input) {
  const auto it = std::find_if(rule.conditions.begin(), rule.conditions.end(),
                               [&input](const ItemCondition& condition) { return condition.input == input; });
  return it == rule.conditions.end() ? std::string_view() : std::string_view(it->term);
}

Result<std::string> rulesText(const std::vector<GivenRule>& rules, const std::vector<std::string>& input_ids) {
  std::vector<std::string> columns = {"participant", "form"};
  columns.insert(columns.end(), input_ids.begin(), input_ids.end());
  columns.insert(columns.end(), {"then", "weight"});
  CsvWriter csv{std::span<const std::string>(columns)};
  for (const auto& rule : rules) {
    for (const auto& condition : rule.conditions) {
      if (std::find(input_ids.begin(), input_ids.end(), condition.input) == input_ids.end()) {
        return base::fail(base::ErrorCode::kReference, "a rule of participant " + base::quoted(rule.participant),
                          "a condition on " + base::quoted(condition.input), "an input of the study");
      }
    }
    csv.cell(rule.participant).cell(rule.form);
    for (const auto& input : input_ids) csv.cell(termOf(rule, input));
    csv.cell(rule.then).cell(rule.weight).endRow();
  }
  return csv.text();
}

}  // namespace

std::string_view judgementText(const ForceJudgement& judgement) {
  switch (judgement.kind) {
    case ForceJudgement::Kind::kTerm: return judgement.term;
    case ForceJudgement::Kind::kNotFelt: return "not_felt";
    case ForceJudgement::Kind::kBeyondPractice: return "beyond_practice";
    case ForceJudgement::Kind::kNoAnswer: return {};
  }
  return {};
}

std::string_view statusText(Answer::Status status) {
  switch (status) {
    case Answer::Status::kAnswered: return "answered";
    case Answer::Status::kSkipped: return "skipped";
    case Answer::Status::kCantTell: return "cant_tell";
    case Answer::Status::kCleared: return "cleared";
  }
  return {};
}

Result<void> writeStudyFolder(const Study& study, const std::vector<std::string>& input_ids,
                              const std::string& folder) {
  // Everything that can be refused is refused before the first file appears.
  const auto rules = rulesText(study.rules, input_ids);
  if (!rules) return base::inFile(rules.error(), folder);
  if (auto made = base::makeFolder(folder); !made) return made;

  const std::pair<std::string_view, std::string> tables[] = {
      {"participants.csv", participantsText(study.participants)},
      {"speeds.csv", speedsText(study.speeds)},
      {"judgements.csv", judgementsText(study.judgements)},
      {"answers.csv", answersText(study.answers)},
      {"rules.csv", *rules},
  };
  for (const auto& [name, text] : tables) {
    auto written = base::writeFileAtomically((std::filesystem::path(folder) / name).string(), text);
    if (!written) return written;
  }
  return {};
}

}  // namespace tactus::study
