#include "app/session/simulated_nurse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "app/session/simulated_study.h"
#include "app/session/stroke_capture.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/procedure/procedure.h"
#include "experiments/published_tables.h"
#include "experiments/stroke.h"

namespace tactus::session {
namespace {

using procedure::Procedure;

// What simulated strokes can be: the speeds of Table 1, from which slower ones are stretched in time.
constexpr double kSlowestMmS = 30;
constexpr double kFastestMmS = 300;
constexpr double kOwnWords = 0.4;          // standard deviation of an answer, in words
constexpr double kLessOnTheWayOut = 0.8;   // words, an assumption
constexpr double kSpreadOfStrokes = 0.35;  // standard deviation as a share of the mean, the middle of Table 1

/// Where the word `k` of `terms` passes into the next one.
double boundaryAfter(const std::vector<fuzzy::Term>& terms, std::size_t k) {
  return (terms[k].points[2] + terms[k + 1].points[1]) / 2;
}

/// A value that everybody would call by the word: the middle of its core, of an open end a third beyond its beginning.
double typicalOf(const fuzzy::Variable& input, std::size_t k) {
  const auto& points = input.terms[k].points;
  if (points[2] >= input.max) return std::min(input.max, points[1] * 4 / 3);
  if (points[1] <= input.min) return input.min + (points[2] - input.min) * 2 / 3;
  return (points[1] + points[2]) / 2;
}

SimulatedLevel levelAt(const std::string& level, double mean_mm_s, std::uint64_t seed) {
  const double made_mm_s = std::clamp(mean_mm_s, kSlowestMmS, kFastestMmS);
  auto out = simulatedLevel({{}, level, made_mm_s, kSpreadOfStrokes * made_mm_s}, seed);
  const double stretch = std::max(1.0, made_mm_s / mean_mm_s);
  const auto slow = [stretch](Recording& recording) {
    for (double& time : recording.time_s) time *= stretch;
  };
  for (auto* const recordings : {&out.strokes, &out.practice})
    std::for_each(recordings->begin(), recordings->end(), slow);
  slow(out.too_short);
  return out;
}

/// How much each condition moves the answer, in words; for all experts alike.
std::map<std::string, std::vector<double>> effectsOf(const Procedure& procedure, double words, base::Random& random) {
  constexpr double kDeclared = 0.22;  // of all words, from the middle to an end
  constexpr double kNotDeclared = 0.08;
  std::map<std::string, std::vector<double>> out;
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    auto& effects = out[input.id];
    const auto direction = procedure.input_notes[i].direction;
    const double sign = direction == procedure::Direction::kFalls   ? -kDeclared
                        : direction == procedure::Direction::kRises ? kDeclared
                                                                    : random.uniform(-kNotDeclared, kNotDeclared);
    const auto& terms = input.terms;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const double place =
          terms.size() < 2 ? 0 : 2 * static_cast<double>(k) / static_cast<double>(terms.size() - 1) - 1;
      effects.push_back(i == procedure.way() ? random.uniform(0.25, 0.75) * words : sign * words * place);
    }
  }
  return out;
}

}  // namespace

std::vector<double> typicalSpeeds(const Procedure& procedure) {
  std::vector<double> out;
  const auto* const rate = procedure.rateInput();
  for (std::size_t k = 0; rate != nullptr && k < rate->terms.size(); ++k) out.push_back(typicalOf(*rate, k));
  return out;
}

NurseTraits simulatedExpert(const Procedure& procedure, const study::Form& form, std::uint64_t seed, double spread) {
  base::Random person(seed);
  NurseTraits out;
  out.profile.category = "expert";
  out.profile.handedness = "right";
  const auto& words = procedure.output.terms;
  const double forces = std::exp(spread * person.normal());
  out.words.clear();
  for (const auto& word : words) out.words.push_back(word.id);
  for (std::size_t k = 0; k + 1 < words.size(); ++k)
    out.responder.threshold_n.push_back(forces * boundaryAfter(words, k));
  out.responder.beyond_from_n = forces * procedure.output.max;
  out.responder.stop_from_n = 0.8 * out.responder.beyond_from_n;
  out.responder.noise = 1;
  if (const auto* const rate = procedure.rateInput()) {
    const double speeds = std::exp(spread * person.normal());
    const auto typical = typicalSpeeds(procedure);
    for (std::size_t k = 0; k < rate->terms.size(); ++k)
      out.levels[rate->terms[k].id] = levelAt(rate->terms[k].id, speeds * typical[k], seed + k + 1);
  }
  // What the procedure is like is the same for every expert; how each feels it differs.
  base::Random common(1);
  const auto highest = static_cast<double>(form.answers.size() - 1);
  const auto effects = effectsOf(procedure, highest, common);
  std::map<std::string, double> own;
  for (const auto& input : procedure.inputs) own[input.id] = std::exp(spread * person.normal());
  for (const auto& item : form.items) {
    double level = highest / 2;
    for (const auto& condition : item.conditions) {
      if (condition == study::kWayOut) {
        level -= kLessOnTheWayOut;
        continue;
      }
      const auto input = std::find_if(procedure.inputs.begin(), procedure.inputs.end(),
                                      [&](const auto& one) { return one.id == condition.input; });
      const auto term = std::find_if(input->terms.begin(), input->terms.end(),
                                     [&](const auto& one) { return one.id == condition.term; });
      // A region of another set than the first stands where the procedure is of middle force.
      if (term == input->terms.end()) continue;
      const double effect = effects.at(input->id)[static_cast<std::size_t>(term - input->terms.begin())];
      level += own[input->id] * (input->id == procedure.wayInput().id ? effect - highest / 2 : effect);
    }
    level += kOwnWords * person.normal();
    const double place = std::clamp(std::round(level), 0.0, highest);
    out.answers.push_back({{},
                           form.id,
                           item.number,
                           form.answers[static_cast<std::size_t>(place)].term,
                           study::Answer::Status::kAnswered});
  }
  return out;
}

namespace {

constexpr std::array kParticipants = {"S1", "S2", "S3", "S4"};
constexpr int kSteps = 17;  // paper, Section 3.1.5: 0.1 N to 1.7 N in steps of 0.1 N

/// The terms that were chosen in one row, one for each vote, from the largest to the least.
std::vector<std::string> chosenTerms(const experiments::PublishedVotes& row, const std::vector<std::string>& terms) {
  std::vector<std::string> chosen;
  for (std::size_t term = terms.size(); term-- > 0;) {
    chosen.insert(chosen.end(), static_cast<std::size_t>(row.votes[term]), terms[term]);
  }
  TACTUS_CHECK(chosen.size() == kParticipants.size());
  return chosen;
}

}  // namespace

std::vector<study::ForceJudgement> simulatedJudgements() {
  using Kind = study::ForceJudgement::Kind;
  const auto terms = experiments::publishedVoteTerms();
  const auto table = experiments::publishedVotes();
  std::vector<study::ForceJudgement> judgements;
  for (std::size_t person = 0; person < kParticipants.size(); ++person) {
    for (int step = 1; step <= kSteps; ++step) {
      study::ForceJudgement judgement{kParticipants[person], "ascending", step, step / 10.0, Kind::kBeyondPractice, {}};
      if (static_cast<std::size_t>(step) <= table.size()) {
        judgement.kind = Kind::kTerm;
        judgement.term = chosenTerms(table[static_cast<std::size_t>(step) - 1], terms)[person];
      }
      judgements.push_back(std::move(judgement));
    }
  }
  return judgements;
}

namespace {

using JudgementKind = study::ForceJudgement::Kind;

constexpr double kAbsoluteN = 0.04;
constexpr double kWeber = 0.12;

/// The middle between the last force of the terms up to `term` and the first force of the higher ones, in one
/// participant's ascending series.
double thresholdAfter(std::size_t term, const std::string& code, const std::vector<std::string>& terms) {
  double last_n = 0;
  for (const auto& judgement : simulatedJudgements()) {
    if (judgement.participant != code || judgement.kind != JudgementKind::kTerm) continue;
    const auto place = static_cast<std::size_t>(std::find(terms.begin(), terms.end(), judgement.term) - terms.begin());
    if (place > term) return (last_n + judgement.force_n) / 2;
    last_n = judgement.force_n;
  }
  return last_n;
}

}  // namespace

double justNoticeableN(double force_n) { return std::hypot(kAbsoluteN, kWeber * force_n); }

std::vector<ResponderTraits> respondersOfTable2() {
  const auto terms = experiments::publishedVoteTerms();
  std::vector<ResponderTraits> responders;
  for (const auto& judgement : simulatedJudgements()) {
    const bool known = std::any_of(responders.begin(), responders.end(), [&](const ResponderTraits& responder) {
      return responder.code == judgement.participant;
    });
    if (known) continue;
    ResponderTraits traits;
    traits.code = judgement.participant;
    for (std::size_t term = 0; term + 1 < terms.size(); ++term) {
      traits.threshold_n.push_back(thresholdAfter(term, traits.code, terms));
    }
    responders.push_back(std::move(traits));
  }
  return responders;
}

SimulatedResponder::SimulatedResponder(ResponderTraits traits, std::vector<std::string> terms)
    : traits_(std::move(traits)), terms_(std::move(terms)) {
  TACTUS_CHECK(terms_.size() == traits_.threshold_n.size() + 1);
  TACTUS_CHECK(std::is_sorted(traits_.threshold_n.begin(), traits_.threshold_n.end()));
}

Response SimulatedResponder::judge(double felt_n, base::Random& random) {
  // The same random numbers are drawn for each judgement, whatever the traits: one trait changes nothing else.
  const double noise = random.normal();
  const bool lapses = random.uniform() < traits_.lapse;
  const auto random_term = static_cast<std::size_t>(random.below(static_cast<int>(terms_.size())));

  double percept_n = felt_n + traits_.noise * noise * justNoticeableN(felt_n);
  if (before_n_) percept_n += traits_.assimilation * (*before_n_ - percept_n);
  before_n_ = percept_n;

  Response response{JudgementKind::kTerm, {}, percept_n};
  if (lapses) {
    response.term = terms_[random_term];
  } else if (percept_n < traits_.felt_from_n) {
    response.kind = JudgementKind::kNotFelt;
  } else if (percept_n >= traits_.beyond_from_n) {
    response.kind = JudgementKind::kBeyondPractice;
  } else {
    const auto above = std::upper_bound(traits_.threshold_n.begin(), traits_.threshold_n.end(), percept_n);
    response.term = terms_[static_cast<std::size_t>(above - traits_.threshold_n.begin())];
  }
  return response;
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using experiments::PositionSample;

constexpr double kTremorHz = 9;

/// A hand that moves at `speed_mm_s` for `length_s` while it feels a force; one that rests trembles only.
experiments::ForwardMotion motionOf(double speed_mm_s, double length_s, double least_mm_s) {
  experiments::ForwardMotion motion(least_mm_s);
  const int ticks = static_cast<int>(length_s * kSimulatedRateHz);
  for (int i = 0; i < ticks; ++i) {
    const double time_s = i / kSimulatedRateHz;
    motion.add({time_s, speed_mm_s * time_s + kTremorMm * std::sin(2 * std::numbers::pi * kTremorHz * time_s)});
  }
  return motion;
}

/// The choice beside `value`.
std::string neighbor(const questionnaires::Questionnaire& form, const std::string& value) {
  const auto at = std::find_if(form.choices.begin(), form.choices.end(),
                               [&](const questionnaires::Choice& choice) { return choice.value == value; });
  TACTUS_CHECK(at != form.choices.end() && form.choices.size() > 1);
  return at == form.choices.begin() ? std::next(at)->value : std::prev(at)->value;
}

/// The item whose last reply is not what the nurse thinks, or nothing.
template <class ReplyTo>
std::optional<int> itemToCorrect(const questionnaires::QuestionnaireRun& form, ReplyTo reply_to) {
  for (const auto& question : form.form().questions) {
    const auto history = form.history(question.number);
    if (history.empty()) continue;
    const questionnaires::Reply wanted = reply_to(question.number);
    if (history.back().status != wanted.status || history.back().value != wanted.value) return question.number;
  }
  return std::nullopt;
}

}  // namespace

SimulatedNurse::SimulatedNurse(NurseTraits traits, std::uint64_t seed, PassTime pass_time,
                               std::span<const study::JudgementRecord> judged)
    : traits_(std::move(traits)),
      seed_(seed),
      pass_time_(pass_time ? std::move(pass_time) : [](double) {}),
      responder_(traits_.responder, traits_.words) {
  for (const auto& record : judged) {
    auto random =
        randomFor("judge " + record.series + ' ' + std::to_string(record.step) + ' ' + std::to_string(record.attempt));
    responder_.judge(record.felt_n.value_or(record.commanded_n), random);
  }
}

base::Random SimulatedNurse::randomFor(const std::string& step) const {
  std::uint64_t hash = 0xCBF29CE484222325U ^ seed_;  // FNV-1a (Fowler, Noll, Vo)
  for (const char c : step) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return base::Random(hash);
}

Result<void> SimulatedNurse::doNext(Session& session) {
  switch (session.part()) {
    case SessionPart::kProfile: pass_time_(60); return session.tell(traits_.profile);
    case SessionPart::kSpeed: return doStroke(session);
    case SessionPart::kForce: return doJudgement(session);
    case SessionPart::kForm: return doAnswer(session);
    case SessionPart::kRating: return doRating(session);
    case SessionPart::kFinished:
    case SessionPart::kAborted: break;
  }
  return fail(ErrorCode::kValue, "session", "its end", "a session that asks for something");
}

Result<void> SimulatedNurse::finish(Session& session) {
  while (session.part() != SessionPart::kFinished) {
    if (auto ok = doNext(session); !ok) return ok;
  }
  return {};
}

Result<void> SimulatedNurse::doStroke(Session& session) const {
  const auto plan = session.speed()->next();
  const auto level = traits_.levels.find(plan.level);
  if (level == traits_.levels.end()) {
    return fail(ErrorCode::kReference, "simulated nurse", "the speed " + base::quoted(plan.level), "one with strokes");
  }
  auto random = randomFor("stroke " + plan.level + (plan.practice ? " practice " : " ") + std::to_string(plan.number));
  const bool too_short = plan.attempt == 1 && random.uniform() < traits_.stops_early;
  const auto& good = plan.practice ? level->second.practice : level->second.strokes;
  const auto place = static_cast<std::size_t>(plan.number - 1) % good.size();
  const Recording& stream = too_short ? level->second.too_short : good[place];

  StrokeCapture capture(session.settings().speed.stroke);
  for (std::size_t i = 0; i < stream.time_s.size(); ++i) capture.add({stream.time_s[i], stream.depth_mm[i]});
  capture.finish();
  pass_time_(3 + stream.time_s.back());
  auto found = capture.take();
  if (!found) return fail(ErrorCode::kData, "simulated nurse", "no stroke in its recording", "one");
  return session.addStroke(found->stroke, std::move(found->recording), found->recording_first);
}

Response SimulatedNurse::responseTo(const experiments::SeriesStep& step, int attempt, const Session& session) {
  auto random = randomFor("judge " + step.series + ' ' + std::to_string(step.step) + ' ' + std::to_string(attempt));
  return responder_.judge(step.force_n + session.settings().force.device_friction_n.value_or(0), random);
}

Result<void> SimulatedNurse::doJudgement(Session& session) {
  const auto plan = session.force()->next();
  const auto response = responseTo(plan.step, plan.attempt, session);
  auto random = randomFor("feel " + plan.step.series + ' ' + std::to_string(plan.step.step));
  const double length_s = random.uniform(1, 2);
  const double speed_mm_s = random.uniform(30, 80);
  const bool still = plan.attempt == 1 && random.uniform() < traits_.holds_still;
  const auto motion = motionOf(still ? 0 : speed_mm_s, length_s, plan.forward_least_mm_s);

  experiments::ForceAnswer answer;
  answer.forward_mm = motion.wayMm();
  answer.forward_speed_mm_s = motion.speedMmS();
  answer.response_s = length_s;
  if (!plan.question.answers.empty()) {
    answer.kind = response.kind;
    answer.term = response.term;
    if (session.settings().about().stop_question)
      answer.would_stop = response.percept_n >= traits_.responder.stop_from_n;
  }
  pass_time_(plan.pause_before_s + plan.ramp_s + length_s);
  return session.judge(answer);
}

questionnaires::Reply SimulatedNurse::replyTo(int item) const {
  const auto answer = std::find_if(traits_.answers.begin(), traits_.answers.end(),
                                   [item](const study::Answer& one) { return one.item == item; });
  if (answer == traits_.answers.end()) return {};
  return {answer->status, answer->term};
}

/// Goes back to an answer that was another choice at first, at most one a call. Returns whether there was one.
Result<bool> SimulatedNurse::correct(Session& session) const {
  const auto& form = *session.form();
  const auto item = itemToCorrect(form, [this](int number) { return replyTo(number); });
  if (!item) return false;
  do {
    session.back();
  } while (form.page()->question->number != *item && form.page()->position > 1);
  pass_time_(4);
  if (const auto replied = session.reply(replyTo(*item), 4); !replied) return tl::unexpected(replied.error());
  return true;
}

Result<void> SimulatedNurse::doAnswer(Session& session) const {
  TACTUS_TRY(const auto corrected, correct(session));
  if (corrected) return {};
  const auto page = session.form()->page();
  if (!page) return fail(ErrorCode::kValue, "simulated nurse", "a form without a page", "an open page");
  const int item = page->question->number;
  auto random = randomFor("item " + std::to_string(item));
  const double response_s = random.uniform(3, 9);
  auto reply = replyTo(item);
  const bool otherwise = random.uniform() < traits_.second_thoughts;
  if (otherwise && page->last_answer == nullptr && reply.status == study::Answer::Status::kAnswered) {
    reply.value = neighbor(session.form()->form(), reply.value);
  }
  pass_time_(response_s);
  return session.reply(reply, response_s);
}

Result<void> SimulatedNurse::doRating(Session& session) const {
  if (session.block() == Block::kForm) {
    TACTUS_TRY(const auto corrected, correct(session));
    if (corrected) return {};
  }
  auto random = randomFor("rating " + std::string(name(*session.block())));
  const int effort = 1 + random.below(4);
  const int comfort = 4 + random.below(4);
  pass_time_(15);
  return session.rate(effort, comfort);
}

}  // namespace tactus::session
