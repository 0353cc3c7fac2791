#include "core/study/data_finding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <utility>

namespace tactus::study {
namespace {

using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;

constexpr std::size_t kKinds = static_cast<std::size_t>(Kind::kRulesCopied) + 1;

constexpr std::array<std::string_view, kKinds> kNames = {"codes_alike",         "code_like_name",
                                                         "years_unlikely",      "without_strokes",
                                                         "without_judgements",  "without_answers",
                                                         "simulated_and_real",  "virtual_device",
                                                         "setup_unchecked",     "summary_row",
                                                         "code_like_date",      "weights_mixed",
                                                         "unknown_level",       "level_without_strokes",
                                                         "strokes_missing",     "stroke_too_short",
                                                         "samples_missing",     "speed_unit",
                                                         "depth_unit",          "time_unit",
                                                         "several_units",       "columns_swapped",
                                                         "speed_sign",          "speed_against_depth",
                                                         "speed_scale",         "depth_falls",
                                                         "withdrawal",          "no_times",
                                                         "no_depths",           "rows_twice",
                                                         "rows_backwards",      "rows_unsorted",
                                                         "stroke_twice",        "stroke_copied",
                                                         "constant_speed",      "outliers",
                                                         "levels_swapped",      "unknown_series",
                                                         "unknown_force_term",  "force_unit",
                                                         "scale_reversed",      "one_word",
                                                         "terms_fall",          "beyond_too_early",
                                                         "not_felt_above_felt", "force_order",
                                                         "series_differ",       "repeats_differ",
                                                         "blanks_felt",         "judgements_copied",
                                                         "unknown_answer_term", "unknown_item",
                                                         "one_answer",          "answer_pattern",
                                                         "answers_reversed",    "answers_copied",
                                                         "answers_shifted",     "wordings_mixed",
                                                         "one_consequent",      "rules_copied"};

}  // namespace

void append(std::vector<DataFinding>& findings, std::vector<DataFinding> more) {
  findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string_view name(Kind kind) noexcept { return kNames[static_cast<std::size_t>(kind)]; }

std::string_view name(Severity severity) noexcept {
  switch (severity) {
    case Severity::kNote: return "note";
    case Severity::kWarning: return "warning";
    case Severity::kRefused: return "refused";
  }
  return "note";
}

std::string text(const DataFinding& finding) {
  if (finding.cell.line.number == 0) return finding.sentence;
  return std::string(finding.cell.table) + ", line " + std::to_string(finding.cell.line.number) + ": " +
         finding.sentence;
}

DataFinding refusal(Kind kind, std::string participant, TableCell cell, const std::string& what,
                    const std::string& remedy) {
  std::string sentence = what;
  if (!sentence.empty()) sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return {kind,  Severity::kRefused, std::move(participant), cell, sentence + ": " + remedy + ".", "that " + what,
          remedy};
}

std::optional<Kind> acceptableKind(std::string_view id) noexcept {
  const auto kind = std::find_if(kAcceptable.begin(), kAcceptable.end(), [id](Kind one) { return name(one) == id; });
  return kind == kAcceptable.end() ? std::nullopt : std::optional(*kind);
}

bool isAccepted(const DataFinding& finding, std::span<const Kind> accepted) noexcept {
  return finding.severity == Severity::kRefused &&
         std::find(accepted.begin(), accepted.end(), finding.kind) != accepted.end();
}

base::Result<void> refuseData(const std::vector<DataFinding>& findings, std::span<const Kind> accepted) {
  const auto refused = [accepted](const DataFinding& finding) {
    return finding.severity == Severity::kRefused && !isAccepted(finding, accepted);
  };
  const auto first = std::find_if(findings.begin(), findings.end(), refused);
  if (first == findings.end()) return {};
  const auto more = std::count_if(std::next(first), findings.end(), refused);
  base::Error error{base::ErrorCode::kData, {}, {}, first->found, first->wanted};
  if (acceptableKind(name(first->kind))) {
    error.wanted += ", or --accept " + std::string(name(first->kind)) + " if the data are right as they are";
  }
  if (more > 0) error.wanted += " (" + std::to_string(more) + " more: tactus study check lists them)";
  return atCell(std::move(error), first->cell, first->found);
}

}  // namespace tactus::study
