#include "elicitation/uncertainty/own_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {
namespace {

constexpr std::size_t kExpertPoints = 400'000;  // experts' forces of all participants: seconds at most
constexpr std::size_t kFewestPoints = 256;
constexpr std::size_t kBetweenLooks = 64;  // points

/// The terms from the judgements of one person; none if the person used no word of `output`.
std::vector<fuzzy::Term> wordsFrom(const std::vector<study::ForceJudgement>& judged, const BuildSettings& settings,
                                   fuzzy::Variable output, double end_n) {
  std::erase_if(output.terms, [&](const fuzzy::Term& term) {
    return std::none_of(judged.begin(), judged.end(), [&](const study::ForceJudgement& one) {
      return one.kind == study::ForceJudgement::Kind::kTerm && one.term == term.id;
    });
  });
  if (output.terms.empty()) return {};
  std::vector<std::string> ids;
  for (const auto& term : output.terms) ids.push_back(term.id);
  const auto counts = countVotes(judged, settings.series, ids);
  if (!counts) return {};
  auto terms = forceTermsFrom(settings.force_terms, output, judged, settings.series, vote(*counts, 1), end_n);
  return terms ? std::move(terms->output.terms) : std::vector<fuzzy::Term>();
}

std::string quotedLabels(const std::vector<std::string>& ids, const fuzzy::Variable& output) {
  std::vector<std::string> labels;
  for (const auto& id : ids) {
    const auto* const term = fuzzy::findTerm(output.terms, id);
    labels.push_back(base::quoted(term == nullptr ? id : term->label));
  }
  return base::joined(labels, ", ");
}

}  // namespace

std::vector<OwnWords> ownWords(const study::Study& study, const BuiltModel& built, const BuildSettings& settings) {
  std::vector<OwnWords> out;
  if (!built.force_terms) return out;
  const fuzzy::Variable& output = procedure::of(study).output;
  for (const auto& participant : study.participants) {
    std::vector<study::ForceJudgement> judged;
    for (const auto& one : study.judgements) {
      if (one.participant == participant.code && one.series == settings.series) judged.push_back(one);
    }
    auto& own = out.emplace_back(OwnWords{participant.code, {}, {}});
    own.terms = wordsFrom(judged, settings, output, built.model.output.max);
    for (const auto& term : built.model.output.terms) {
      if (fuzzy::findTerm(own.terms, term.id) == nullptr) own.missing.push_back(term.id);
    }
  }
  return out;
}

std::optional<fuzzy::ForceModel> underWords(const fuzzy::ForceModel& model, const OwnWords& words) {
  if (words.terms.empty()) return std::nullopt;
  fuzzy::ForceModel out = model;
  out.output.terms = words.terms;
  out.checks.clear();
  out.accepted_holes.clear();
  for (auto& expert : out.experts) {
    std::erase_if(expert.rules, [&](const fuzzy::Rule& rule) {
      return std::find(words.missing.begin(), words.missing.end(), rule.then) != words.missing.end();
    });
  }
  std::erase_if(out.experts, [](const fuzzy::Expert& expert) { return expert.rules.empty(); });
  if (std::none_of(out.experts.begin(), out.experts.end(), [](const auto& one) { return one.weight > 0; }))
    return std::nullopt;
  return out;
}

std::vector<std::string> missingWordNotes(std::span<const OwnWords> words, const fuzzy::Variable& output) {
  std::vector<std::string> notes;
  for (const auto& one : words) {
    if (one.terms.empty()) {
      notes.push_back(one.participant + " called no force by a word, so there are no own words.");
    } else if (!one.missing.empty()) {
      notes.push_back(one.participant + " called no force in the range of the model " +
                      quotedLabels(one.missing, output) + ": rules with " +
                      (one.missing.size() == 1 ? "this word" : "these words") + " give no force under the words of " +
                      one.participant + ".");
    }
  }
  return notes;
}

namespace {

using base::ErrorCode;
using base::Result;

/// A participant with the model under the participant's own words, and the places among the experts of both models.
struct Compared {
  std::string participant;
  std::size_t expert = 0;
  fuzzy::CompiledModel under;
  std::size_t expert_under = 0;
};

std::size_t expertPlace(const std::vector<fuzzy::Expert>& experts, const std::string& id) {
  return static_cast<std::size_t>(
      std::find_if(experts.begin(), experts.end(), [&](const fuzzy::Expert& one) { return one.id == id; }) -
      experts.begin());
}

/// Those with words and rules of their own; the others get a note.
Result<std::vector<Compared>> comparedPeople(const fuzzy::ForceModel& model, std::span<const OwnWords> words,
                                             std::vector<std::string>& notes) {
  std::vector<Compared> out;
  for (const auto& own : words) {
    const std::size_t expert = expertPlace(model.experts, own.participant);
    if (own.terms.empty()) continue;  // has a note already
    if (expert == model.experts.size() || !(model.experts[expert].weight > 0)) {
      notes.push_back(own.participant + " has words but no rules that count, and is not compared.");
      continue;
    }
    const auto under = underWords(model, own);
    const std::size_t expert_under = under ? expertPlace(under->experts, own.participant) : 0;
    if (!under || expert_under == under->experts.size()) {
      notes.push_back("No rule of " + own.participant + " has a word that " + own.participant +
                      " used for a force: not compared.");
      continue;
    }
    TACTUS_TRY(auto compiled, fuzzy::compile(*under));
    out.push_back({own.participant, expert, std::move(compiled), expert_under});
  }
  return out;
}

/// Adds one point to the sums.
class SpreadSum {
 public:
  void add(const std::vector<double>& forces) {
    const double sd_n = base::standardDeviation(forces);
    squares_ += sd_n * sd_n;
    const auto [lowest, highest] = std::minmax_element(forces.begin(), forces.end());
    largest_n_ = std::max(largest_n_, *highest - *lowest);
  }
  Disagreement over(std::size_t points) const {
    return {points > 0 ? std::sqrt(squares_ / static_cast<double>(points)) : 0, largest_n_};
  }

 private:
  double squares_ = 0;
  double largest_n_ = 0;
};

}  // namespace

Result<WordsAndRules> wordsAndRules(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                                    const WordsAndRulesSettings& how) {
  WordsAndRules out;
  const auto words = ownWords(study, built, settings);
  out.notes = missingWordNotes(words, built.model.output);
  TACTUS_TRY(const auto people, comparedPeople(built.model, words, out.notes));
  for (const auto& one : people) out.participants.push_back(one.participant);
  if (people.size() < 2) return out;
  TACTUS_TRY(const auto shared, fuzzy::compile(built.model));
  const auto points =
      how.points.empty()
          ? analysis::boxPoints(built.model,
                                std::clamp(kExpertPoints / (people.size() * (built.model.experts.size() + 2)),
                                           kFewestPoints, analysis::kBoxPoints))
          : how.points;
  out.tried = points.size();
  SpreadSum of_words, of_rules, of_both;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (p % kBetweenLooks == 0) {
      if (how.stop.stop_requested())
        return base::fail(ErrorCode::kCancelled, "words", "a request to stop", "time to end");
      if (how.progress) how.progress(static_cast<double>(p) / static_cast<double>(points.size()));
    }
    std::vector<double> own_words, own_rules, own_both;
    for (const auto& one : people) {
      const auto with_words = one.under.evaluate(points[p]);
      const auto with_rules = shared.evaluateExpert(one.expert, points[p]);
      const auto with_both = one.under.evaluateExpert(one.expert_under, points[p]);
      if (!with_words.fired || !with_rules.fired || !with_both.fired) continue;
      own_words.push_back(with_words.force_n);
      own_rules.push_back(with_rules.force_n);
      own_both.push_back(with_both.force_n);
    }
    if (own_words.size() < 2) continue;
    ++out.points;
    of_words.add(own_words);
    of_rules.add(own_rules);
    of_both.add(own_both);
  }
  out.words = of_words.over(out.points);
  out.rules = of_rules.over(out.points);
  out.both = of_both.over(out.points);
  return out;
}

std::string wordsAndRulesSentence(const WordsAndRules& found) {
  if (found.participants.size() < 2)
    return "Fewer than two participants have both words and rules of their own: nothing to compare.";
  if (found.points == 0) return "At no point do two participants have a force under their own words.";
  const auto newtons = [](double force_n) { return base::formatFixed(force_n, 3) + " N"; };
  return "With own words and own rules the participants lie " + newtons(found.both.sd_n) +
         " apart (standard deviation); " + newtons(found.words.sd_n) + " if only the words are their own, " +
         newtons(found.rules.sd_n) + " if only the rules are. The two do not add up.";
}

}  // namespace tactus::elicitation
