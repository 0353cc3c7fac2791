#include "questionnaires/survey_responses.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::questionnaires {
namespace {

using base::CsvTable;
using base::ErrorCode;
using base::Result;

/// A column of the table, and the item whose answers it holds.
struct ItemColumn {
  std::size_t column = 0;
  int item = 0;
};

std::string comparable(std::string_view text) { return base::lowered(base::trimmed(text)); }

/// The columns by name; nothing if no item has one.
Result<std::vector<ItemColumn>> columnsByName(const CsvTable& table, const Survey& survey) {
  std::vector<ItemColumn> out;
  std::string absent;
  for (const SurveyMatrix& matrix : survey.matrices) {
    for (const SurveyField& field : matrix.fields) {
      auto column = table.find(field.name);
      if (!column) column = table.find(matrix.name + "_" + field.name);  // the key of `m01[q01]`
      if (column) out.push_back({*column, field.item});
      if (!column && absent.empty()) absent = field.name;
    }
  }
  if (out.empty() || absent.empty()) return out;
  return tl::unexpected(base::Error{ErrorCode::kSchema, table.file(), "header", "no column " + base::quoted(absent),
                                    "a column for each of the items"});
}

/// The columns by the items' texts in one language; nothing unless each is there once.
std::vector<ItemColumn> columnsByText(const CsvTable& table, const Survey& survey) {
  std::vector<ItemColumn> out;
  for (const SurveyMatrix& matrix : survey.matrices) {
    for (const SurveyField& field : matrix.fields) {
      const auto is_it = [&](const std::string& name) { return comparable(name) == comparable(field.text); };
      const auto& names = table.columns();
      const auto found = std::find_if(names.begin(), names.end(), is_it);
      if (found == names.end() || std::count_if(names.begin(), names.end(), is_it) != 1) return {};
      out.push_back({static_cast<std::size_t>(found - names.begin()), field.item});
    }
  }
  return out;
}

Result<std::vector<ItemColumn>> itemColumns(const CsvTable& table, std::span<const Survey> languages) {
  auto out = columnsByName(table, languages.front());
  if (!out || !out->empty()) return out;
  for (const Survey& survey : languages) {
    if (auto by_text = columnsByText(table, survey); !by_text.empty()) return by_text;
  }
  return tl::unexpected(base::Error{ErrorCode::kSchema, table.file(), "header",
                                    "no column 'q01', and not each item's text once",
                                    "an export with raw data and field names"});
}

/// `record_id`, or the question about the code in a LimeSurvey export, or the first column.
std::size_t recordColumn(const CsvTable& table) {
  for (const char* name : {"record_id", "code"}) {
    if (const auto column = table.find(name)) return *column;
  }
  return 0;
}

/// What a cell may say, in every language.
class Choices {
 public:
  explicit Choices(std::span<const Survey> languages) {
    for (const Survey& survey : languages) {
      for (const SurveyChoice& choice : survey.choices) {
        known_.try_emplace(comparable(choice.code), choice);
        known_.try_emplace(comparable(choice.label), choice);
      }
    }
    std::vector<std::string> codes;
    for (const SurveyChoice& choice : languages.front().choices) codes.push_back(choice.code);
    wanted_ = "a code (" + base::joined(codes, ", ") + "), its label, or an empty cell";
  }

  const SurveyChoice* find(std::string_view cell) const {
    const auto it = known_.find(comparable(cell));
    return it == known_.end() ? nullptr : &it->second;
  }
  const std::string& wanted() const { return wanted_; }

 private:
  std::map<std::string, SurveyChoice> known_;
  std::string wanted_;
};

class Reader {
 public:
  Reader(const CsvTable& table, std::span<const Survey> languages, const ResponseSettings& settings)
      : table_(table), survey_(languages.front()), settings_(settings), choices_(languages), languages_(languages) {}

  Result<SurveyResponses> read(std::vector<ItemColumn> columns) {
    columns_ = std::move(columns);
    record_ = recordColumn(table_);
    for (std::size_t row = 0; row < table_.rowCount(); ++row) {
      if (auto ok = addRow(row); !ok) return tl::unexpected(ok.error());
    }
    noteWhatIsLeftOut();
    return std::move(out_);
  }

 private:
  bool isMissing(std::string_view cell) const {
    const auto text = base::trimmed(cell);
    return text.empty() ||
           std::find(settings_.missing.begin(), settings_.missing.end(), text) != settings_.missing.end();
  }

  Result<void> addRow(std::size_t row) {
    const auto is_missing = [&](const ItemColumn& one) { return isMissing(table_.cell(row, one.column)); };
    if (std::all_of(columns_.begin(), columns_.end(), is_missing)) {
      ++without_answers_;
      return {};
    }
    TACTUS_TRY(const auto participant, participantOf(row));
    if (!seen_.insert(participant).second) {
      return table_.refuse(row, record_, ErrorCode::kSchema,
                           "one row for each participant; export one event and no repeats");
    }
    out_.participants.push_back(participant);
    if (auto ok = addProfile(row, participant); !ok) return ok;
    for (const ItemColumn& one : columns_) {
      study::Answer answer{participant, survey_.form, one.item, {}, study::Answer::Status::kSkipped, {}};
      if (!is_missing(one)) {
        const SurveyChoice* const choice = choices_.find(table_.cell(row, one.column));
        if (choice == nullptr) return table_.refuse(row, one.column, ErrorCode::kValue, choices_.wanted());
        answer.term = choice->term;
        const bool is_answered = choice->status == "answered";
        answer.status = is_answered ? study::Answer::Status::kAnswered : study::Answer::Status::kCantTell;
      }
      out_.answers.push_back(std::move(answer));
    }
    noteCompletion(row);
    return {};
  }

  /// The column of a field of the profile; LimeSurvey's names have no `_`.
  std::optional<std::size_t> profileColumn(const std::string& name) const {
    std::string plain = name;
    std::erase(plain, '_');
    const auto column = table_.find(name);
    return column ? column : table_.find(plain);
  }

  /// Cells hold the stored value (REDCap), the number of the answer (LimeSurvey), or its label in any language.
  Result<void> addProfile(std::size_t row, const std::string& participant) {
    if (!survey_.opening) return {};
    for (std::size_t asked = 0; asked < survey_.opening->profile.size(); ++asked) {
      const SurveyOpening::Question& question = survey_.opening->profile[asked];
      const auto column = profileColumn(question.name);
      if (!column || isMissing(table_.cell(row, *column))) continue;
      const std::string cell = comparable(table_.cell(row, *column));
      const std::string* found = nullptr;
      std::string wanted;
      for (std::size_t offer = 0; offer < question.offers.size(); ++offer) {
        bool fits = cell == comparable(question.offers[offer].code) || cell == std::to_string(offer + 1);
        for (const Survey& language : languages_) {
          fits = fits || (language.opening && cell == comparable(language.opening->profile[asked].offers[offer].label));
        }
        if (fits) found = &question.offers[offer].code;
        wanted += (offer == 0 ? "" : ", ") + question.offers[offer].code;
      }
      if (found == nullptr) return table_.refuse(row, *column, ErrorCode::kValue, "one of " + wanted);
      out_.profiles[participant][question.name] = *found;
    }
    return {};
  }

  Result<std::string> participantOf(std::size_t row) const {
    const std::string record(base::trimmed(table_.cell(row, record_)));
    if (record.empty()) return table_.refuse(row, record_, ErrorCode::kSchema, "the participant's code");
    if (settings_.participants.empty()) {
      if (base::looksLikeFormula(record)) return table_.refuse(row, record_, ErrorCode::kValue, base::kNoFormula);
      return record;
    }
    const auto it = settings_.participants.find(record);
    if (it == settings_.participants.end())
      return table_.refuse(row, record_, ErrorCode::kReference, "a record of the table of participants");
    return it->second;
  }

  /// REDCap: 0 or Incomplete in `<form>_complete`.
  void noteCompletion(std::size_t row) {
    const auto column = table_.find(survey_.name + "_complete");
    if (!column) return;
    const std::string state = comparable(table_.cell(row, *column));
    if (state == "0" || state == "incomplete") ++incomplete_;
  }

  void noteWhatIsLeftOut() {
    std::set<std::size_t> used = {record_};
    for (const ItemColumn& one : columns_) used.insert(one.column);
    if (survey_.opening) {
      for (const auto& question : survey_.opening->profile) {
        if (const auto column = profileColumn(question.name)) used.insert(*column);
      }
    }
    std::vector<std::string> ignored;
    for (std::size_t column = 0; column < table_.columns().size(); ++column) {
      if (!used.contains(column)) ignored.push_back(table_.columns()[column]);
    }
    if (!ignored.empty()) out_.notes.push_back("Ignored columns: " + base::joined(ignored, ", ") + ".");
    if (without_answers_ > 0)
      out_.notes.push_back("Rows without any answer, left out: " + std::to_string(without_answers_) + ".");
    if (incomplete_ > 0)
      out_.notes.push_back("Marked as incomplete, and read all the same: " + std::to_string(incomplete_) + ".");
  }

  const CsvTable& table_;
  const Survey& survey_;
  const ResponseSettings& settings_;
  Choices choices_;
  std::span<const Survey> languages_;
  std::vector<ItemColumn> columns_;
  std::size_t record_ = 0;
  std::set<std::string> seen_;
  std::size_t without_answers_ = 0;
  std::size_t incomplete_ = 0;
  SurveyResponses out_;
};

}  // namespace

Result<SurveyResponses> surveyResponses(const CsvTable& table, std::span<const Survey> languages,
                                        const ResponseSettings& settings) {
  TACTUS_TRY(auto columns, itemColumns(table, languages));
  return Reader(table, languages, settings).read(std::move(columns));
}

}  // namespace tactus::questionnaires
