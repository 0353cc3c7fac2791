// A study becomes a folder of tables.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include "core/base/files/file.h"
#include "core/study/csv_tables.h"

namespace tactus::study {
namespace {

using base::CsvWriter;
using base::Result;

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
