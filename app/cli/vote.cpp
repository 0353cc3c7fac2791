#include <cmath>
#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/cli/terminal.h"
#include "app/session/study_source.h"
#include "app/session/table_words.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_frequency.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/force/force_voting.h"

namespace tactus::cli {
namespace {

using base::JsonWriter;
using base::Result;
using elicitation::VoteStep;

struct Count {
  std::vector<elicitation::VoteCounts> steps;
  std::vector<study::ForceJudgement> judgements;  ///< empty from a table of counts
  std::optional<int> enrolled;                    ///< known from judgements, not from a table of counts
  std::vector<std::string> warnings;
};

Result<Count> counted(const VoteOptions& options, const std::vector<std::string>& terms, Count count,
                      std::vector<study::ForceJudgement> judgements) {
  auto steps = elicitation::countVotes(judgements, options.series, terms);
  if (!steps) {
    auto error = steps.error();
    error.file = options.judgements;
    return tl::unexpected(std::move(error));
  }
  count.steps = std::move(*steps);
  count.enrolled = elicitation::countParticipants(judgements);
  count.judgements = std::move(judgements);
  return count;
}

/// A study file, or a folder with the tables of a study.
bool isStudy(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) || isDatabase(path);
}

/// The force of the procedure.
Result<fuzzy::Variable> outputOf(const VoteOptions& options) {
  if (!isStudy(options.judgements)) {
    TACTUS_TRY(const auto about, session::procedureOfTable(options.judgements, options.pack));
    return about->output;
  }
  if (!options.pack.empty()) {
    return base::fail(base::ErrorCode::kValue, "--pack", "a study, which keeps its procedure",
                      "--pack only with a single table");
  }
  TACTUS_TRY(const auto study, session::readStudy(options.judgements));
  return procedure::of(study.study).output;
}

Result<Count> countFile(const VoteOptions& options, const std::vector<std::string>& terms) {
  if (isStudy(options.judgements)) {
    TACTUS_TRY(auto study, session::readStudy(options.judgements));
    Count count;
    for (const auto& notice : study.notices) count.warnings.push_back(options.judgements + ": " + notice);
    return counted(options, terms, std::move(count), std::move(study.study.judgements));
  }
  TACTUS_TRY(const auto table, base::CsvTable::read(options.judgements));
  Count count;
  if (auto note = table.note()) count.warnings.push_back(std::move(*note));
  if (elicitation::isVoteTable(table, terms)) {
    TACTUS_TRY(auto votes, elicitation::readVoteTable(table, terms));
    count.steps = std::move(votes.steps);
    for (const auto& column : votes.ignored) {
      count.warnings.push_back(options.judgements + ": column " + base::quoted(column) + " is ignored");
    }
    return count;
  }
  TACTUS_TRY(auto judgements, session::readJudgementTable(table, count.warnings));
  return counted(options, terms, std::move(count), std::move(judgements));
}

/// Why the step has its term, in words; `--json` has the codes.
std::string why(const VoteStep& step) {
  std::string text;
  switch (step.reason) {
    case elicitation::VoteReason::kMajority: text = "half of the votes or more"; break;
    case elicitation::VoteReason::kTieHigher: text = "two have half of the votes each: the higher"; break;
    case elicitation::VoteReason::kNextLevel: text = "no half: one above the last force's own term"; break;
    case elicitation::VoteReason::kClamped: text = "no half: one above, kept within the terms voted for"; break;
    case elicitation::VoteReason::kFirstMedian: text = "no half, no force decided before: the lower median"; break;
    case elicitation::VoteReason::kNoVotes: return "no participant chose a term";
  }
  if (elicitation::isUnsaid(step)) {
    text += "; nobody said it";
  } else if (!elicitation::isMostFrequent(step)) {
    text += "; not the most frequent";
  }
  if (step.monotone_raised) text += "; raised, because terms never fall";
  if (step.below_quorum) text += "; less than half of the participants voted";
  return text;
}

std::string votesText(const VoteStep& step) {
  std::vector<std::string> counts;
  for (const int votes : step.votes) counts.push_back(std::to_string(votes));
  return base::joined(counts, " ");
}

std::string termsText(const std::vector<fuzzy::Term>& terms) {
  std::string text;
  for (const auto& term : terms) {
    text += padded(term.id, 13);
    for (const double point : term.points) text += ' ' + base::formatNumber(std::round(point * 1e3) / 1e3);
    text += '\n';
  }
  return text;
}

/// The terms by the way that was asked for. An error about the end names its option.
Result<elicitation::ForceTerms> termsOf(const VoteOptions& options, const fuzzy::Variable& output, const Count& count,
                                        const std::vector<VoteStep>& steps) {
  if (options.force_terms == elicitation::ForceTermsFrom::kThresholds && !count.enrolled) {
    return base::fail(base::ErrorCode::kValue, "--force-terms", "thresholds with a table of counts",
                      "a table of judgements, because thresholds are those of each participant");
  }
  return elicitation::forceTermsFrom(options.force_terms, output, count.judgements, options.series, steps,
                                     options.force_end_n);
}

std::string asText(const VoteOptions& options, const std::vector<VoteStep>& steps, const elicitation::ForceTerms& terms,
                   const elicitation::FrequencyTerms& frequency, const std::vector<std::string>& ids) {
  std::string text = "votes for " + base::oneLine(base::joined(ids, ", ")) + ":\n" + padded("force_n", 9) +
                     padded("votes", 14) + padded("term", 14) + "why\n";
  for (const auto& step : steps) {
    text += padded(base::formatNumber(step.force_n), 9) + padded(votesText(step), 14) +
            padded(step.term ? ids[*step.term] : "-", 14) + why(step) + '\n';
  }
  text += "\nterms of the force from the " + std::string(name(options.force_terms)) + " (corners in N)\n" +
          termsText(terms.output.terms) + "the universe ends at " + base::roundedNumber(terms.output.max) +
          " N: " + terms.end_reason + '\n';
  return text + "\nfor comparison, from all answers (frequency curve, corners in N, rms error " +
         base::formatFixed(frequency.rms_error, 3) + ")\n" + termsText(frequency.output.terms);
}

void writeTerms(JsonWriter& json, const std::vector<fuzzy::Term>& terms) {
  json.key("terms").beginArray();
  for (const auto& term : terms) {
    json.beginObject(JsonWriter::Layout::kInline)
        .key("id")
        .value(term.id)
        .key("points")
        .values(term.points)
        .endObject();
  }
  json.endArray();
}

/// The frequency curve as the member `frequency`, to set beside the vote.
void writeFrequency(JsonWriter& json, const elicitation::FrequencyTerms& frequency) {
  json.key("frequency").beginObject().key("shares").beginArray();
  for (const auto& step : frequency.steps) {
    json.beginObject(JsonWriter::Layout::kInline).key("force_n").value(step.force_n).key("votes").value(step.votes);
    json.key("shares");
    step.votes > 0 ? json.values(step.shares) : json.null();
    json.endObject();
  }
  json.endArray();
  writeTerms(json, frequency.output.terms);
  json.key("interpolated").values(frequency.interpolated).key("absent").values(frequency.absent);
  json.key("rms_error").value(frequency.rms_error).endObject();
}

std::string asJson(const VoteOptions& options, const std::vector<VoteStep>& steps, const elicitation::ForceTerms& terms,
                   const elicitation::FrequencyTerms& frequency, const std::vector<std::string>& ids,
                   const std::vector<std::string>& warnings) {
  JsonWriter json;
  json.beginObject().key("steps").beginArray();
  for (const auto& step : steps) {
    json.beginObject(JsonWriter::Layout::kInline).key("force_n").value(step.force_n).key("term");
    step.term ? json.value(ids[*step.term]) : json.null();
    json.key("reason").value(std::string(name(step.reason)));
    json.key("monotone_raised").value(step.monotone_raised).key("below_quorum").value(step.below_quorum);
    json.key("unsaid").value(elicitation::isUnsaid(step));
    json.key("most_frequent").value(elicitation::isMostFrequent(step));
    json.key("votes").beginArray();
    for (const int votes : step.votes) json.value(votes);
    json.endArray().endObject();
  }
  json.endArray().key("terms_from").value(name(options.force_terms)).key("end_n").value(terms.output.max);
  writeTerms(json, terms.output.terms);
  json.key("interpolated").values(terms.interpolated).key("absent").values(terms.absent);
  writeFrequency(json, frequency);
  json.key("warnings").values(warnings).endObject();
  return json.text();
}

}  // namespace

Result<Output> vote(const VoteOptions& options) {
  TACTUS_TRY(const auto output, outputOf(options));
  std::vector<std::string> ids;
  for (const auto& term : output.terms) ids.push_back(term.id);
  TACTUS_TRY(auto count, countFile(options, ids));
  const auto steps = elicitation::vote(count.steps, count.enrolled);
  const auto terms = termsOf(options, output, count, steps);
  if (!terms) return inFile(terms.error(), options.judgements);
  const auto frequency = elicitation::frequencyTerms(output, steps, options.force_end_n);
  if (!frequency) return inFile(frequency.error(), options.judgements);
  auto& warnings = count.warnings;
  warnings.insert(warnings.end(), terms->notes.begin(), terms->notes.end());
  if (options.force_terms == elicitation::ForceTermsFrom::kVote) {
    const auto unsaid = elicitation::unsaidNotes(output, steps, options.force_end_n);
    warnings.insert(warnings.end(), unsaid.begin(), unsaid.end());
  }
  if (options.json) return Output{asJson(options, steps, *terms, *frequency, ids, warnings), {}};
  return Output{asText(options, steps, *terms, *frequency, ids), warnings};
}

}  // namespace tactus::cli
