// One table of a study at a time: cells to records.
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/tables/odd_cell.h"
#include "core/base/text.h"
#include "core/study/csv_tables.h"

namespace tactus::study {
namespace {

using base::CsvTable;
using base::ErrorCode;
using base::Result;

constexpr std::size_t kAbsent = std::numeric_limits<std::size_t>::max();

bool mayBeAbsent(std::string_view table, std::string_view column) {
  return std::any_of(kOptionalColumns.begin(), kOptionalColumns.end(), [&](const OptionalColumn& optional) {
    return optional.table == table && optional.column == column;
  });
}

/// Indices of the columns `names` of the table `kind`, in their order, kAbsent for one that may be absent and is; or
/// the error about the first that is missing.
template <std::size_t Count>
Result<std::array<std::size_t, Count>> findColumns(const CsvTable& table, std::string_view kind,
                                                   const std::array<std::string_view, Count>& names) {
  std::array<std::size_t, Count> columns{};
  for (std::size_t i = 0; i < Count; ++i) {
    if (!table.find(names[i]) && mayBeAbsent(kind, names[i])) {
      columns[i] = kAbsent;
      continue;
    }
    TACTUS_TRY(const auto column, table.require(names[i]));
    columns[i] = column;
  }
  return columns;
}

/// Reads the cells of one row and keeps the first error, so that a row reads as one list of assignments.
class RowReader {
 public:
  RowReader(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}

  /// Empty where the column is absent.
  std::string_view text(std::size_t column) const {
    if (column == kAbsent) return {};
    const auto cell = base::trimmed(table_.cell(row_, column));
    return table_.hasMark() ? base::withoutGuard(cell) : cell;
  }

  /// A code or an id of a term, form or series, or an empty cell.
  std::string name(std::size_t column) {
    const auto cell = text(column);
    if (base::looksLikeFormula(cell)) refuse(column, ErrorCode::kValue, base::kNoFormula);
    return std::string(cell);
  }

  std::string requiredName(std::size_t column, std::string_view wanted) {
    std::string cell = name(column);
    if (cell.empty()) refuse(column, ErrorCode::kValue, std::string(wanted) + " (merged cells? fill them down)");
    return cell;
  }

  /// A term, an empty cell, or a dash in its place.
  std::string term(std::size_t column) { return text(column) == "-" ? "-" : name(column); }

  double number(std::size_t column) {
    if (base::isMissingWord(text(column)))
      refuse(column, ErrorCode::kValue, "a finite number; leave a row without one out");
    return keep(table_.number(row_, column), 0.0);
  }

  int integer(std::size_t column) {
    const long long value = keep(table_.integer(row_, column), 0LL);
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) {
      refuse(column, ErrorCode::kValue, "an integer of at most 32 bits");
      return 0;
    }
    return static_cast<int>(value);
  }

  /// A number of something that is counted from 1.
  int ordinal(std::size_t column) {
    const int value = integer(column);
    if (value < 1) refuse(column, ErrorCode::kValue, "an integer from 1");
    return value;
  }

  /// Empty, or a number from 0.
  std::optional<double> optionalAmount(std::size_t column) {
    if (text(column).empty()) return std::nullopt;
    if (base::isMissingWord(text(column))) {
      refuse(column, ErrorCode::kValue, "a number of at least 0, or an empty cell");
      return std::nullopt;
    }
    const double value = number(column);
    if (value < 0) refuse(column, ErrorCode::kValue, "a number of at least 0, or an empty cell");
    return value;
  }

  void refuse(std::size_t column, ErrorCode code, std::string wanted) {
    if (!error_) error_ = table_.refuse(row_, column, code, std::move(wanted)).value();
  }
  void refuse(std::size_t column, ErrorCode code, std::string found, std::string wanted) {
    if (!error_)
      error_ = base::Error{code, table_.file(), table_.place(row_, column), std::move(found), std::move(wanted)};
  }

  TableLine line() const { return {static_cast<std::uint32_t>(table_.line(row_))}; }

  const std::optional<base::Error>& error() const { return error_; }

 private:
  template <class T>
  T keep(Result<T> cell, T otherwise) {
    if (cell) return *cell;
    if (!error_) error_ = std::move(cell.error());
    return otherwise;
  }

  const CsvTable& table_;
  std::size_t row_;
  std::optional<base::Error> error_;
};

/// One record per row, made by `read(RowReader&)`; stops at the first row with an error.
template <class Record, class Read>
Result<std::vector<Record>> readRows(const CsvTable& table, Read read) {
  std::vector<Record> records;
  records.reserve(table.rowCount());
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    RowReader cells(table, row);
    records.push_back(read(cells));
    records.back().line = cells.line();
    if (!cells.error()) continue;
    auto error = *cells.error();
    const auto code = base::trimmed(table.cell(row, table.find("participant").value_or(0)));
    if (isSummaryWord(code)) error.wanted = "data alone: remove the line of " + base::quoted(code);
    return tl::unexpected(std::move(error));
  }
  return records;
}

bool simulatedFlag(RowReader& cells, std::size_t column) {
  const std::string text = base::lowered(cells.text(column));
  if (text == "1" || text == "true") return true;
  if (!text.empty() && text != "0" && text != "false") {
    cells.refuse(column, ErrorCode::kValue, "1 or true, 0 or false, or an empty cell");
  }
  return false;
}

std::pair<ForceJudgement::Kind, std::string> judgementOf(std::string_view text) {
  using Kind = ForceJudgement::Kind;
  if (text.empty()) return {Kind::kNoAnswer, {}};
  if (text == "not_felt") return {Kind::kNotFelt, {}};
  if (text == "beyond_practice") return {Kind::kBeyondPractice, {}};
  return {Kind::kTerm, std::string(text)};
}

Answer::Status statusOf(RowReader& cells, std::size_t column, bool has_term) {
  using Status = Answer::Status;
  if (column == kAbsent) return has_term ? Status::kAnswered : Status::kSkipped;
  const std::string text = base::lowered(cells.text(column));
  if (text == "answered") return Status::kAnswered;
  if (text == "skipped") return Status::kSkipped;
  if (text == "cant_tell") return Status::kCantTell;
  if (text == "cleared") return Status::kCleared;
  cells.refuse(column, ErrorCode::kValue, "'answered', 'skipped', 'cant_tell' or 'cleared'");
  return Status::kSkipped;
}

/// The columns of rules.csv that are inputs.
Result<std::vector<std::size_t>> inputColumns(const CsvTable& table, const std::vector<std::string>& input_ids) {
  std::vector<std::size_t> columns;
  for (const auto& id : input_ids) {
    if (const auto column = table.find(id)) columns.push_back(*column);
  }
  if (columns.empty() && !input_ids.empty()) return tl::unexpected(table.require(input_ids.front()).error());
  if (!input_ids.empty()) return columns;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if (name != "participant" && name != "form" && name != "then" && name != "weight") columns.push_back(i);
  }
  return columns;
}

/// The id of the input that a column called `name` is about.
const std::string& inputId(const std::string& name, const std::vector<std::string>& input_ids) {
  const auto id = std::find(input_ids.begin(), input_ids.end(), base::columnKey(name));
  return id == input_ids.end() ? name : *id;
}

}  // namespace

Result<std::vector<Participant>> readParticipants(const CsvTable& table) {
  TACTUS_TRY(const auto columns, findColumns(table, kParticipantsTable, kParticipantColumns));
  const auto& column = columns;

  std::set<std::string> seen;
  return readRows<Participant>(table, [&](RowReader& cells) {
    Participant participant;
    participant.code = cells.requiredName(column[0], "the code of a participant");
    if (!seen.insert(participant.code).second)
      cells.refuse(column[0], ErrorCode::kValue, base::quoted(participant.code) + " again", "each participant once");
    participant.years_experience = cells.optionalAmount(column[1]);
    participant.category = cells.text(column[2]);
    participant.handedness = cells.text(column[3]);
    participant.weight = cells.optionalAmount(column[4]);
    participant.simulated = simulatedFlag(cells, column[5]);
    return participant;
  });
}

Result<std::vector<SpeedSample>> readSpeeds(const CsvTable& table) {
  TACTUS_TRY(const auto columns, findColumns(table, kSpeedsTable, kSpeedColumns));
  const auto& column = columns;

  return readRows<SpeedSample>(table, [&column](RowReader& cells) {
    SpeedSample sample;
    sample.participant = cells.requiredName(column[0], "the code of a participant");
    sample.level = cells.requiredName(column[1], "the level that was asked for");
    sample.stroke = cells.ordinal(column[2]);
    sample.time_s = cells.number(column[3]);
    sample.depth_mm = cells.number(column[4]);
    sample.speed_mm_s = cells.number(column[5]);
    return sample;
  });
}

Result<std::vector<ForceJudgement>> readJudgements(const CsvTable& table) {
  TACTUS_TRY(const auto columns, findColumns(table, kJudgementsTable, kJudgementColumns));
  const auto& column = columns;

  std::set<std::tuple<std::string, std::string, int>> seen;
  return readRows<ForceJudgement>(table, [&](RowReader& cells) {
    ForceJudgement judgement;
    judgement.participant = cells.requiredName(column[0], "the code of a participant");
    judgement.series = column[1] == kAbsent ? "ascending" : cells.name(column[1]);
    judgement.step = cells.ordinal(column[2]);
    judgement.force_n = cells.number(column[3]);
    if (judgement.force_n < 0) cells.refuse(column[3], ErrorCode::kValue, "a force of 0 N or more");
    std::tie(judgement.kind, judgement.term) = judgementOf(cells.term(column[4]));
    if (!seen.emplace(judgement.participant, judgement.series, judgement.step).second) {
      cells.refuse(column[2], ErrorCode::kValue, "step " + std::to_string(judgement.step) + " of this series again",
                   "each step of a series once for a participant");
    }
    return judgement;
  });
}

Result<std::vector<Answer>> readAnswers(const CsvTable& table) {
  TACTUS_TRY(const auto columns, findColumns(table, kAnswersTable, kAnswerColumns));
  const auto& column = columns;

  std::set<std::tuple<std::string, std::string, int>> seen;
  return readRows<Answer>(table, [&](RowReader& cells) {
    Answer answer;
    answer.participant = cells.requiredName(column[0], "the code of a participant");
    answer.form = cells.requiredName(column[1], "the id of a form");
    answer.item = cells.integer(column[2]);
    answer.term = cells.term(column[3]);
    answer.status = statusOf(cells, column[4], !answer.term.empty());
    answer.wording = cells.text(column[5]);
    const bool answered = answer.status == Answer::Status::kAnswered;
    if (answered && answer.term.empty()) {
      cells.refuse(column[3], ErrorCode::kValue, "a term, as the status is 'answered'");
    } else if (!answered && !answer.term.empty()) {
      cells.refuse(column[3], ErrorCode::kValue,
                   "an empty cell, as the status is " + base::quoted(cells.text(column[4])));
    }
    if (!seen.emplace(answer.participant, answer.form, answer.item).second) {
      cells.refuse(column[2], ErrorCode::kValue, "item " + std::to_string(answer.item) + " of this form again",
                   "each item of a form once for a participant");
    }
    return answer;
  });
}

Result<std::vector<GivenRule>> readRules(const CsvTable& table, const std::vector<std::string>& input_ids) {
  TACTUS_TRY(const auto columns, findColumns(table, kRulesTable, kRuleColumns));
  const auto& column = columns;
  TACTUS_TRY(const auto inputs, inputColumns(table, input_ids));
  const auto form = table.find("form");

  using Terms = std::vector<std::string>;
  std::set<std::tuple<std::string, std::string, Terms>> seen;
  return readRows<GivenRule>(table, [&](RowReader& cells) {
    GivenRule rule;
    rule.participant = cells.requiredName(column[0], "the code of a participant");
    if (form) rule.form = cells.name(*form);
    Terms terms;
    for (const std::size_t input : inputs) {
      terms.push_back(cells.name(input));
      if (!terms.back().empty()) rule.conditions.push_back({inputId(table.columns()[input], input_ids), terms.back()});
    }
    if (rule.conditions.empty()) {
      cells.refuse(inputs.empty() ? column[1] : inputs.front(), ErrorCode::kValue, "a rule without a condition",
                   "a term for one input or more");
    }
    rule.then = cells.requiredName(column[1], "the term that follows");
    terms.push_back(rule.then);
    if (!cells.text(column[2]).empty()) rule.weight = cells.number(column[2]);
    if (!(rule.weight >= 0 && rule.weight <= 1)) {
      cells.refuse(column[2], ErrorCode::kValue,
                   rule.weight >= 2 ? "a weight from 0 to 1, or an empty cell for 1 (percent? divide by 100)"
                                    : "a weight from 0 to 1, or an empty cell for 1");
    }
    if (!seen.emplace(rule.participant, rule.form, std::move(terms)).second) {
      cells.refuse(column[1], ErrorCode::kValue, "the same rule twice", "each rule once for a participant");
    }
    return rule;
  });
}

}  // namespace tactus::study
