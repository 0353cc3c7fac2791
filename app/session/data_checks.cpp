#include "app/session/data_checks.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "app/session/given_rule_checks.h"
#include "app/session/known_forms.h"
#include "app/session/participant_checks.h"
#include "elicitation/variables/ngt_variables.h"
#include "experiments/judgement_tables.h"
#include "experiments/stroke_copies.h"
#include "experiments/table_strokes.h"
#include "experiments/stroke_units.h"
#include "experiments/stroke_values.h"
#include "questionnaires/answer_checks.h"

namespace tactus::session {
namespace {

using Findings = std::vector<study::DataFinding>;

std::vector<std::string> termIds(const std::vector<fuzzy::Term>& terms) {
  std::vector<std::string> ids;
  for (const auto& term : terms) ids.push_back(term.id);
  return ids;
}

std::vector<std::string> speedLevels() {
  for (const auto& input : elicitation::ngtInputs()) {
    if (input.id == "speed") return termIds(input.terms);
  }
  return {};
}

Findings strokeFindings(const study::Study& study) {
  const auto strokes = experiments::tableStrokes(study.speeds);
  const auto participants = experiments::byParticipant(strokes);
  const std::size_t usual = experiments::usualStrokes(strokes);
  const auto levels = speedLevels();
  Findings out;
  for (const auto& of_one : participants) {
    append(out, experiments::levelFindings(of_one, levels, usual));
    if (auto swapped = experiments::swappedColumns(of_one)) {
      out.push_back(std::move(*swapped));
      continue;  // what the columns say under the wrong names means nothing
    }
    append(out, experiments::unitFindings(of_one));
    append(out, experiments::rowFindings(of_one));
    append(out, experiments::valueFindings(of_one));
  }
  for (auto& finding : experiments::scaleFindings(participants)) {
    // Who has another unit is of another scale for that reason.
    const bool said = std::any_of(out.begin(), out.end(), [&finding](const study::DataFinding& other) {
      return other.participant == finding.participant && other.severity == study::DataFinding::Severity::kRefused;
    });
    if (!said) out.push_back(std::move(finding));
  }
  append(out, experiments::strokeCopyFindings(strokes));
  return out;
}

}  // namespace

Findings dataFindings(const study::Study& study) {
  Findings findings = participantFindings(study);
  append(findings, strokeFindings(study));
  append(findings, experiments::judgementFindings(study.judgements, termIds(elicitation::ngtOutput().terms)));
  append(findings, questionnaires::answerFindings(study.answers, knownForms()));
  append(findings, givenRuleFindings(study.rules));

  std::unordered_map<std::string, std::size_t> place;
  for (const auto& participant : study.participants) place.try_emplace(participant.code, place.size() + 1);
  std::stable_sort(findings.begin(), findings.end(), [&place](const auto& a, const auto& b) {
    const auto at = [&place](const study::DataFinding& finding) {
      const auto found = place.find(finding.participant);
      return found == place.end() ? std::size_t{0} : found->second;
    };
    return std::pair(-static_cast<int>(a.severity), at(a)) < std::pair(-static_cast<int>(b.severity), at(b));
  });
  return findings;
}

}  // namespace tactus::session
