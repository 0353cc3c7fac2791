#include "elicitation/model/model_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/validate.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/model/model_provenance.h"
#include "elicitation/model/record_influence.h"
#include "elicitation/rules/expert_rules.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

fuzzy::Variable& wayIn(BuiltModel& built) { return built.model.inputs[built.about().way()]; }

void append(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

template <class Rows>
Result<void> checkKnown(const Rows& rows, const std::set<std::string_view>& known, std::string_view table,
                        const std::string& what) {
  for (const auto& row : rows) {
    if (known.count(row.participant) > 0) continue;
    return study::atCell(
        {ErrorCode::kReference, {}, what, "participant " + base::quoted(row.participant), "a participant of the study"},
        {table, row.line, "participant"}, base::quoted(row.participant));
  }
  return {};
}

/// Every row must belong to a participant, or it would be lost silently.
Result<void> checkParticipants(const study::Study& study) {
  std::set<std::string_view> known;
  for (const auto& participant : study.participants) {
    if (!known.insert(participant.code).second) {
      return fail(ErrorCode::kData, "participants", base::quoted(participant.code) + " twice", "each participant once");
    }
  }
  if (auto ok = checkKnown(study.speeds, known, study::kSpeedsTable, "speeds"); !ok) return ok;
  if (auto ok = checkKnown(study.judgements, known, study::kJudgementsTable, "judgements"); !ok) return ok;
  if (auto ok = checkKnown(study.answers, known, study::kAnswersTable, "answers"); !ok) return ok;
  return checkKnown(study.rules, known, study::kRulesTable, "rules");
}

/// Speeds that are computed from positions can fall below 0, which is worth knowing and no reason to refuse them.
void noteNegativeSpeeds(const study::Study& study, std::vector<std::string>& notes) {
  const auto below = std::count_if(study.speeds.begin(), study.speeds.end(),
                                   [](const study::SpeedSample& sample) { return sample.speed_mm_s < 0; });
  if (below == 0) return;
  notes.push_back(std::to_string(below) + " of " + std::to_string(study.speeds.size()) +
                  " speed samples lie below 0 mm/s; they are clustered as they are.");
}

/// Weights of the participants whose ramps are averaged; empty where they count alike.
Result<std::vector<double>> speedWeights(std::span<const ParticipantSpeeds> speeds, const study::Study& study,
                                         const BuildSettings& settings) {
  if (settings.averaging != Averaging::kWeightedMean) return std::vector<double>{};
  std::vector<study::Participant> people;
  for (const auto& one : speeds) {
    people.push_back(*std::find_if(study.participants.begin(), study.participants.end(),
                                   [&one](const study::Participant& p) { return p.code == one.participant; }));
  }
  return expertWeights(people, settings.weights);
}

std::vector<std::vector<Ramp>> rampsOf(std::span<const ParticipantSpeeds> speeds) {
  std::vector<std::vector<Ramp>> ramps;
  for (const auto& one : speeds) ramps.push_back(one.ramps);
  return ramps;
}

/// `set`, at the depths that the settings choose. The measurement was checked by buildDepth.
std::vector<fuzzy::Term> chosenDepths(const procedure::Procedure& about, const BuildSettings& settings,
                                      std::vector<fuzzy::Term> set) {
  if (settings.depths == DepthsFrom::kTemplate) return set;
  return measuredTerms(*settings.measured_depths, about.wayInput(), set).value();
}

Result<void> buildDepth(const BuildSettings& settings, BuiltModel& out) {
  if (settings.depths == DepthsFrom::kTemplate) return {};
  if (!settings.measured_depths) {
    return fail(ErrorCode::kData, "depths", "no measurement of depths in the study",
                "a measurement on an image (stage Agree, Depth), or the depths of the template");
  }
  auto& depth = wayIn(out);
  TACTUS_TRY(auto terms, measuredTerms(*settings.measured_depths, depth, depth.terms));
  depth.terms = std::move(terms);
  out.notes.push_back(measuredSentence(*settings.measured_depths));
  return {};
}

/// BuiltModel::speeds of another build of the same study whose settings cluster alike, or none.
using KnownClusters = const std::vector<ParticipantSpeeds>*;

/// Asked with the share of the whole build that is done; empty: never.
using GoOn = std::function<bool(double share)>;

// Of the time that a build of many participants takes, about.
constexpr double kClustered = 0.45;
constexpr double kWithRules = 0.55;

/// The same for a part of it.
GoOn between(const GoOn& go_on, double from, double to) {
  if (!go_on) return {};
  return [&go_on, from, to](double share) { return go_on(from + (to - from) * share); };
}

Result<void> goesOn(const GoOn& go_on, double share) {
  if (!go_on || go_on(share)) return {};
  return fail(ErrorCode::kCancelled, "model", "a request to stop", "time to end");
}

Result<void> buildSpeed(const study::Study& study, const BuildSettings& settings, KnownClusters known,
                        const GoOn& go_on, BuiltModel& out) {
  const auto rate = out.about().rate();
  if (!rate) {
    if (!study.speeds.empty()) {
      return fail(ErrorCode::kData, "speeds", std::to_string(study.speeds.size()) + " samples",
                  "none: the procedure " + base::quoted(out.about().id) + " has no input of the role 'rate'");
    }
    return {};
  }
  auto& speed = out.model.inputs[*rate];
  if (known != nullptr) {
    out.speeds = *known;
    for (auto& one : out.speeds) {
      TACTUS_TRY(auto ramps, alphaCutRamps(one.centres, one.m, settings.speed.alpha));
      one.ramps = std::move(ramps);
    }
  } else {
    TACTUS_TRY(auto participants, clusterSpeeds(study, speed, settings.speed, go_on));
    out.speeds = std::move(participants);
  }
  if (out.speeds.empty()) {
    out.notes.push_back("There are no insertion speeds: the speed has its default terms.");
    return {};
  }

  noteNegativeSpeeds(study, out.notes);

  TACTUS_TRY(auto weights, speedWeights(out.speeds, study, settings));
  out.speed_weights = std::move(weights);
  for (const auto& one : out.speeds) {
    if (one.clusters) {
      for (const auto& warning : one.clusters->warnings) {
        out.notes.push_back("Speeds of participant " + one.participant + ": " + warning);
      }
    }
    append(out.notes, one.diagnostics.warnings);
  }
  out.averaged_ramps = averageRamps(rampsOf(out.speeds), out.speed_weights, settings.averaging);
  const double default_max_mm_s = speed.max;
  speed = averagedSpeed(speed, out.speeds, out.averaged_ramps);
  if (speed.max > default_max_mm_s) {
    out.notes.push_back("The universe of the speed ends at " + base::roundedNumber(speed.max) + " mm/s instead of " +
                        base::roundedNumber(default_max_mm_s) + " mm/s: the speeds of a participant lie beyond it.");
  }
  if (settings.terms == SpeedTermsOf::kAveraged) {
    fuzzy::Variable own = speed;
    for (const auto& one : out.speeds) {
      own.terms = speedTerms(speed, one.ramps);
      if (auto note = sameTermNote(one.diagnostics.levels, speed, own, one.participant)) out.notes.push_back(*note);
    }
  }
  return {};
}

/// Which steps a reader should look at again.
std::vector<std::string> voteNotes(std::span<const VoteStep> votes, ForceTermsFrom force_terms) {
  std::vector<std::string> raised;
  std::vector<std::string> below_quorum;
  for (const auto& step : votes) {
    if (step.monotone_raised) raised.push_back(base::roundedNumber(step.force_n));
    if (step.below_quorum) below_quorum.push_back(base::roundedNumber(step.force_n));
  }
  std::vector<std::string> notes;
  if (!raised.empty() && force_terms == ForceTermsFrom::kVote) {
    notes.push_back("Vote at " + base::joined(raised, ", ") +
                    " N: raised to the level of an earlier step, because the levels must not fall.");
  }
  if (!below_quorum.empty()) {
    notes.push_back("Vote at " + base::joined(below_quorum, ", ") + " N: less than half of the participants voted.");
  }
  return notes;
}

Result<void> buildForce(const study::Study& study, const BuildSettings& settings, BuiltModel& out) {
  if (study.judgements.empty()) {
    if (settings.force_end_n) {
      return fail(ErrorCode::kData, "force-end", "no force judgements",
                  "judgements, because without them the force has its default terms and their end");
    }
    out.notes.push_back("There are no force judgements: the force has its default terms.");
    return {};
  }
  std::vector<std::string> ids;
  for (const auto& term : out.model.output.terms) ids.push_back(term.id);
  TACTUS_TRY(const auto counts, countVotes(study.judgements, settings.series, ids));
  out.votes = vote(counts, static_cast<int>(study.participants.size()));
  auto terms = forceTermsFrom(settings.force_terms, out.model.output, study.judgements, settings.series, out.votes,
                              settings.force_end_n);
  if (!terms) return study::inTable(terms.error(), study::kJudgementsTable, study.judgements.front().line);
  const fuzzy::Variable default_output = out.model.output;
  const double default_max_n = default_output.max;
  out.force_terms = std::move(*terms);
  out.model.output = out.force_terms->output;
  append(out.notes, out.force_terms->notes);
  append(out.notes, stepForceNotes(study.judgements, settings.series));
  if (std::abs(out.model.output.max - default_max_n) > kSameForceN) {
    out.notes.push_back("The universe of the force ends at " + base::roundedNumber(out.model.output.max) +
                        " N instead of " + base::roundedNumber(default_max_n) + " N: " + out.force_terms->end_reason +
                        ".");
  }
  append(out.notes, voteNotes(out.votes, settings.force_terms));
  if (settings.force_terms == ForceTermsFrom::kVote)
    append(out.notes, unsaidNotes(default_output, out.votes, settings.force_end_n));
  return {};
}

/// The set of depth terms that most experts use; on a tie the one whose first expert comes first.
std::string sharedDepthTerms(const std::vector<ExpertRules>& experts) {
  std::map<std::string, int> users;
  for (const auto& expert : experts) ++users[expert.depth_terms];
  std::string best = experts.front().depth_terms;
  for (const auto& expert : experts) {
    if (users[expert.depth_terms] > users[best]) best = expert.depth_terms;
  }
  return best;
}

std::vector<study::Participant> peopleOf(const std::vector<ExpertRules>& experts) {
  std::vector<study::Participant> people;
  people.reserve(experts.size());
  for (const auto& expert : experts) people.push_back(expert.participant);
  return people;
}

/// Rules that were given directly stand in a table of their own: what is simulated of that participant is not the
/// rules.
bool hasSimulatedRules(const ExpertRules& expert) {
  return expert.participant.simulated && expert.source == ExpertRules::Source::kAnswers;
}

Result<void> buildExperts(const study::Study& study, const BuildSettings& settings, BuiltModel& out) {
  const auto people = peopleOf(out.experts);
  TACTUS_TRY(const auto weights, expertWeights(people, settings.weights));
  append(out.notes, unusedWeightNotes(study.participants, settings.weights));
  std::vector<bool> simulated;
  for (const auto& expert : out.experts) simulated.push_back(hasSimulatedRules(expert));
  append(out.notes, weightNotes(people, weights, simulated));

  const std::string shared = sharedDepthTerms(out.experts);
  // studyRules has looked up the sets already.
  const auto depthsOf = [&](const std::string& set) {
    return chosenDepths(out.about(), settings, out.about().wayTerms(set)->terms);
  };
  wayIn(out).terms = depthsOf(shared);
  const std::vector<std::string> none;
  for (std::size_t i = 0; i < out.experts.size(); ++i) {
    const ExpertRules& rules = out.experts[i];
    const std::string& code = rules.participant.code;
    fuzzy::Expert expert{code, code + (simulated[i] ? " (simulated)" : ""), weights[i], {}, rules.rules};
    if (rules.depth_terms != shared) expert.overrides.push_back({wayIn(out).id, depthsOf(rules.depth_terms)});
    if (settings.terms == SpeedTermsOf::kOwn) {
      const auto own = std::find_if(out.speeds.begin(), out.speeds.end(),
                                    [&code](const ParticipantSpeeds& one) { return one.participant == code; });
      if (own != out.speeds.end()) {
        const fuzzy::Variable& speed = out.model.inputs[out.about().rate().value()];
        expert.overrides.push_back({speed.id, speedTerms(speed, own->ramps)});
      } else if (out.about().rate()) {
        out.notes.push_back("Participant " + code + " has no speeds of their own; the shared speed terms are used.");
      }
    }
    const auto& absent = out.force_terms ? out.force_terms->absent : none;
    if (auto ok = checkRules(expert, rules, out.model.inputs, out.model.output, absent); !ok) return ok;
    if (auto note = contradictionNote(rules)) out.notes.push_back(std::move(*note));
    out.model.experts.push_back(std::move(expert));
  }
  return {};
}

Result<BuiltModel> termsOf(const study::Study& study, const BuildSettings& settings, KnownClusters known,
                           const GoOn& go_on = {}) {
  if (auto ok = checkParticipants(study); !ok) return tl::unexpected(ok.error());
  BuiltModel out;
  out.procedure = study.procedure;
  out.model.inputs = out.about().inputs;
  out.model.output = out.about().output;
  out.model.name = settings.name.empty() ? study.name : settings.name;
  out.model.created_utc = settings.created_utc;
  out.model.generator = settings.generator;
  if (auto ok = buildDepth(settings, out); !ok) return tl::unexpected(ok.error());
  out.note_subjects.resize(out.notes.size(), out.about().wayInput().id);
  if (auto ok = buildSpeed(study, settings, known, between(go_on, 0, kClustered), out); !ok)
    return tl::unexpected(ok.error());
  const fuzzy::Variable* const rate = out.about().rateInput();
  out.note_subjects.resize(out.notes.size(), rate != nullptr ? rate->id : std::string());
  if (auto ok = buildForce(study, settings, out); !ok) return tl::unexpected(ok.error());
  out.note_subjects.resize(out.notes.size(), out.model.output.id);
  return out;
}

/// Everything of buildModel but the influences and the checks.
Result<BuiltModel> modelOf(const study::Study& study, std::span<const study::Form> forms, const BuildSettings& settings,
                           KnownClusters known, const GoOn& go_on = {}) {
  auto terms = termsOf(study, settings, known, go_on);
  if (!terms) return terms;
  if (auto ok = goesOn(go_on, kClustered); !ok) return tl::unexpected(ok.error());
  BuiltModel out = std::move(*terms);
  std::vector<std::string> answer_terms;
  for (const auto& term : out.about().output.terms) answer_terms.push_back(term.id);
  TACTUS_TRY(auto rules, studyRules(study, forms, answer_terms));
  out.experts = std::move(rules.experts);
  append(out.notes, rules.notes);
  if (auto ok = buildExperts(study, settings, out); !ok) return tl::unexpected(ok.error());
  if (auto ok = goesOn(go_on, (kClustered + kWithRules) / 2); !ok) return tl::unexpected(ok.error());

  out.model.provenance = modelProvenance(study, out.experts, settings);
  out.model.renderer = fuzzy::RendererParameters{};
  out.model.events = out.about().events;
  if (!out.model.provenance->notes.empty()) out.notes.push_back(out.model.provenance->notes);
  if (auto ok = fuzzy::validate(out.model); !ok) return tl::unexpected(ok.error());
  return out;
}

}  // namespace

std::string_view name(SpeedTermsOf terms) noexcept { return terms == SpeedTermsOf::kOwn ? "own" : "averaged"; }

bool hasRules(const study::Study& study) {
  return !study.rules.empty() || std::any_of(study.answers.begin(), study.answers.end(), [](const auto& answer) {
    return answer.status == study::Answer::Status::kAnswered;
  });
}

Result<BuiltModel> buildTerms(const study::Study& study, const BuildSettings& settings) {
  return termsOf(study, settings, nullptr);
}

Result<BuiltModel> buildModel(const study::Study& study, std::span<const study::Form> forms,
                              const BuildSettings& settings, KnownClusters clustered, const GoOn& go_on) {
  auto made = modelOf(study, forms, settings, clustered, go_on);
  if (!made) return made;
  BuiltModel out = std::move(*made);
  if (auto ok = setChecks(out.model); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(auto influences, expertInfluence(out.model, between(go_on, kWithRules, 1)));
  out.influences = std::move(influences);
  append(out.notes, influenceNotes(out.model, out.influences));
  out.note_subjects.resize(out.notes.size());
  return out;
}

Result<fuzzy::ForceModel> rebuiltModel(const BuiltModel& built, const study::Study& study,
                                       std::span<const study::Form> forms, const BuildSettings& settings,
                                       SpeedsOf speeds) {
  TACTUS_TRY(auto made, modelOf(study, forms, settings, speeds == SpeedsOf::kBuilt ? &built.speeds : nullptr));
  return std::move(made.model);
}

Result<fuzzy::ForceModel> reweightedModel(const BuiltModel& built, const study::Study& study,
                                          const BuildSettings& settings) {
  TACTUS_TRY(const auto weights, expertWeights(peopleOf(built.experts), settings.weights));
  fuzzy::ForceModel out = built.model;
  for (std::size_t e = 0; e < out.experts.size(); ++e) out.experts[e].weight = weights[e];
  if (settings.averaging == Averaging::kWeightedMean && !built.speeds.empty()) {
    TACTUS_TRY(const auto speed_weights, speedWeights(built.speeds, study, settings));
    const auto ramps = averageRamps(rampsOf(built.speeds), speed_weights, settings.averaging);
    out.inputs[built.about().rate().value()] = averagedSpeed(*built.about().rateInput(), built.speeds, ramps);
  }
  out.provenance = modelProvenance(study, built.experts, settings);
  out.checks.clear();
  if (auto ok = fuzzy::validate(out); !ok) return tl::unexpected(ok.error());
  return out;
}

Result<fuzzy::ForceModel> expertModel(const fuzzy::ForceModel& averaged, std::string_view expert_id) {
  const auto expert = std::find_if(averaged.experts.begin(), averaged.experts.end(),
                                   [expert_id](const fuzzy::Expert& e) { return e.id == expert_id; });
  if (expert == averaged.experts.end()) {
    std::vector<std::string> ids;
    for (const auto& one : averaged.experts) ids.push_back(one.id);
    return fail(ErrorCode::kReference, "experts", base::quoted(expert_id), "one of " + base::joined(ids, ", "));
  }
  fuzzy::ForceModel out = averaged;
  out.name = averaged.name + ", " + expert->label;
  out.experts = {*expert};
  out.accepted_holes.clear();
  auto& alone = out.experts.front();
  alone.weight = 1;
  for (auto& input : out.inputs) input.terms = fuzzy::termsFor(*expert, input);
  out.output.terms = fuzzy::termsFor(*expert, out.output);
  alone.overrides.clear();
  fuzzy::eraseLostEvents(out);
  if (auto ok = setChecks(out); !ok) return tl::unexpected(ok.error());
  return out;
}

}  // namespace tactus::elicitation
