#include "app/workbench/understand/pull/pull_controller.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "app/editing/edit.h"
#include "app/figures/force_curves.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "core/analysis/pull/pull_curve.h"
#include "core/analysis/pull/pull_text.h"
#include "core/base/error.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kBandPoints = 61;

struct PullText {
  Q_DECLARE_TR_FUNCTIONS(PullText)
};

analysis::ReferenceCurve referenceOf(const PullWish& wish, const std::vector<double>& point, std::size_t x_input,
                                     const fuzzy::Variable& x) {
  analysis::ReferenceCurve out;
  out.columns.resize(point.size());
  const auto add = [&](double at, double low_n, double high_n) {
    for (std::size_t i = 0; i < point.size(); ++i) out.columns[i].push_back(i == x_input ? at : point[i]);
    out.low_n.push_back(low_n);
    out.high_n.push_back(high_n);
  };
  if (wish.kind == PullWish::Kind::kBand) {
    for (std::size_t i = 0; i < kBandPoints; ++i) {
      const double share = static_cast<double>(i) / (kBandPoints - 1);
      add(std::clamp(wish.from + share * (wish.to - wish.from), x.min, x.max), wish.low_n, wish.high_n);
    }
    return out;
  }
  for (std::size_t i = 0; i < wish.x.size(); ++i) {
    if (wish.x[i] < x.min || wish.x[i] > x.max || std::isnan(wish.y_n[i])) continue;
    add(wish.x[i], wish.y_n[i], wish.y_n[i]);
  }
  return out;
}

/// At most as many points of a curve as a search looks at in a second.
PullWish thinned(PullWish wish) {
  constexpr std::size_t kMost = 400;
  if (wish.x.size() <= kMost) return wish;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < kMost; ++i) {
    const std::size_t from = i * (wish.x.size() - 1) / (kMost - 1);
    x.push_back(wish.x[from]);
    y.push_back(wish.y_n[from]);
  }
  wish.x = std::move(x);
  wish.y_n = std::move(y);
  return wish;
}

}  // namespace

PullController::PullController(EditController& edits, const SceneController& scene, Locks locks, QObject* parent)
    : QObject(parent),
      edits_(edits),
      scene_(scene),
      locks_(std::move(locks)),
      search_([this] { return state_ == State::kIdle ? std::nullopt : std::optional(question()); },
              [linted = std::make_shared<Linted>()](const Question& question, const RunOf<PullAnswer>& run) {
                return answerOf(question, run, *linted);
              }) {
  connect(&search_, &Search::valueChanged, this, &PullController::changed);
  connect(&scene_, &SceneController::modelChanged, this, &PullController::keepPins);
  connect(&scene_, &SceneController::modelChanged, this, &PullController::endIfMoved);
  connect(&scene_, &SceneController::modelEdited, this, &PullController::endIfMoved);
  connect(&scene_, &SceneController::xInputChanged, this, &PullController::endIfMoved);
  connect(&scene_, &SceneController::valueChanged, this, &PullController::endIfMoved);
}

std::optional<std::size_t> PullController::previewed() const {
  if (answer() == nullptr || answer()->offers.empty()) return std::nullopt;
  return std::min(previewed_.value_or(0), answer()->offers.size() - 1);
}

QStringList PullController::approvedBy() const {
  QStringList out;
  const editing::EditHistory& history = edits_.history();
  for (const editing::Event& event : history.events()) {
    if (event.kind != editing::EventKind::kSignOff || event.state != history.current()) continue;
    if (const QString who = text(event.stamp.author); !out.contains(who)) out << who;
  }
  return out;
}

void PullController::begin(const PullWish& wish, std::optional<std::size_t> expert, State state) {
  if (scene_.showsAnother()) {
    edits_.refuse(tr("The force was not pulled: the curves show another version. Go back to the open model first"));
    return;
  }
  if (edits_.inGesture()) return;
  open_ = scene_.shared();
  values_ = scene_.values();
  x_input_ = scene_.xInput();
  wish_ = thinned(wish);
  expert_ = expert;
  previewed_.reset();
  search_.forget();
  enter(state);
}

void PullController::enter(State state) {
  state_ = state;
  ask();
  search_.hold(*this, state != State::kIdle);
  emit changed();
}

void PullController::setWish(const PullWish& wish) {
  if (state_ == State::kIdle) return;
  wish_ = thinned(wish);
  previewed_.reset();
  ask();
  emit changed();
}

void PullController::ask() {
  ++asked_;
  search_.refresh();
}

void PullController::setExpert(std::optional<std::size_t> expert) {
  if (state_ == State::kIdle || expert == expert_) return;
  expert_ = expert;
  previewed_.reset();
  ++asked_;
  search_.forget();
  emit changed();
}

void PullController::choose() {
  if (state_ == State::kPulling) enter(State::kChoosing);
}

void PullController::preview(std::size_t offer) {
  if (previewed_ == offer) return;
  previewed_ = offer;
  emit changed();
}

void PullController::togglePin(const std::vector<double>& point) {
  const auto there = std::find(pins_.begin(), pins_.end(), point);
  if (there != pins_.end()) {
    pins_.erase(there);
  } else if (!scene_.model()->compiled.evaluate(point).fired) {
    edits_.refuse(tr("The force was not pinned: no rule fires here, so there is no force to keep"));
    return;
  } else {
    pins_.push_back(point);
  }
  if (state_ != State::kIdle) ask();
  emit changed();
}

void PullController::clearPins() {
  pins_.clear();
  if (state_ != State::kIdle) ask();
  emit changed();
}

void PullController::keepPins() {
  const OpenModel* const open = scene_.model();
  const auto gone = [open](const std::vector<double>& pin) {
    return open == nullptr || !analysis::checkPoint(open->model, pin) || !open->compiled.evaluate(pin).fired;
  };
  if (std::erase_if(pins_, gone) > 0) emit changed();
}

void PullController::take(std::size_t offer) {
  if (state_ != State::kChoosing || isSearching() || answer() == nullptr || offer >= answer()->offers.size()) return;
  const std::vector<analysis::PullEdit> edits = answer()->offers[offer].edits;
  cancel();
  edits_.apply(editing::finished(analysis::applied(edits_.model(), edits), analysis::editsText(edits_.model(), edits)));
}

void PullController::cancel() {
  if (state_ == State::kIdle) return;
  state_ = State::kIdle;
  search_.forget();
  search_.hold(*this, false);
  emit changed();
}

// The operating point on the x axis may move: the place of the pull is its own.
void PullController::endIfMoved() {
  if (state_ == State::kIdle) return;
  bool same = scene_.shared() == open_ && scene_.xInput() == x_input_;
  for (std::size_t i = 0; same && i < values_.size(); ++i) same = i == x_input_ || scene_.value(i) == values_[i];
  if (!same) cancel();
}

PullController::Question PullController::question() const {
  Question out{open_, wish_, values_, x_input_, {}, state_ == State::kChoosing, asked_};
  out.point[x_input_] = wish_.kind == PullWish::Kind::kBand    ? (wish_.from + wish_.to) / 2
                        : wish_.kind == PullWish::Kind::kPoint ? wish_.from
                                                               : values_[x_input_];
  out.settings.expert = expert_;
  out.settings.curve_input = x_input_;
  out.settings.pins = pins_;
  const fuzzy::ForceModel& model = open_->model;
  for (const editing::VertexPlace& place : locks_()) {
    const auto variable = place.list.variable == model.output.id ? std::optional(model.inputs.size())
                                                                 : inputNamed(model, place.list.variable);
    if (variable) out.settings.locked_vertices.push_back({{*variable, place.list.expert}, place.term, place.point});
  }
  return out;
}

namespace {

/// What of `candidate` is said besides its words.
QStringList notesOf(const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate,
                    const std::optional<std::size_t>& expert) {
  QStringList out;
  for (const std::string& id : analysis::contradicted(candidate)) {
    out << PullText::tr("Contradicts the answer of %1.").arg(labelOf(model.experts[analysis::expertIndex(model, id)]));
  }
  std::size_t readers = 0;
  for (const analysis::PullEdit& edit : candidate.edits) {
    if (!analysis::editsRule(edit.gesture)) readers = std::max(readers, analysis::readersOf(model, edit.list).size());
  }
  if (expert && readers > 1)
    out << PullText::tr("These words belong to %n experts: the forces of all of them move.", nullptr,
                        static_cast<int>(readers));
  return out;
}

/// `Elsewhere 0.090 JND (RMS), at most 0.159 N`.
QString priceOf(const analysis::Elsewhere& elsewhere, const std::string& unit) {
  const QString most = forceText(elsewhere.largest_n, unit);
  if (unit != "N") return PullText::tr("Elsewhere the force moves by at most %1.").arg(most);
  return PullText::tr("Elsewhere the force moves by %1 JND (RMS), at most %2.").arg(numberText(elsewhere.k, 2), most);
}

PullOffer offerOf(const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate, const std::string& words,
                  const std::optional<std::size_t>& expert) {
  PullOffer out;
  out.edits = candidate.edits;
  out.what = text(words);
  out.price = priceOf(candidate.elsewhere, model.output.unit);
  out.notes = notesOf(model, candidate, expert);
  out.folded = candidate.folded;
  return out;
}

/// The line of `expert` or of the mean after the edits of `offer`.
void addCurve(PullOffer& offer, const fuzzy::ForceModel& after, const std::vector<double>& point, std::size_t x_input,
              const std::optional<std::size_t>& expert) {
  const auto compiled = fuzzy::compile(after);
  if (!compiled) return;
  figures::ForceCurves curves = figures::computeCurves(after, *compiled, x_input, point);
  offer.x = std::move(curves.x);
  offer.curve = std::move(expert ? curves.experts[*expert] : curves.mean);
}

QString sentenceOf(const fuzzy::ForceModel& model, const analysis::Pull& found) {
  const std::string& unit = model.output.unit;
  if (!found.before_n) return PullText::tr("No rule fires here, so no edit of what is there gives a force.");
  const QString reach = PullText::tr("One edit reaches %1 to %2.")
                            .arg(forceText(found.reachable->min_n, {}), forceText(found.reachable->max_n, unit));
  if (!found.blocker) {
    return found.candidates.empty() ? PullText::tr("The force is there already.") + QLatin1Char(' ') + reach : reach;
  }
  return PullText::tr("No edit gives %1: %2.")
             .arg(forceText(found.target_n, unit), text(analysis::blockerText(model, found))) +
         QLatin1Char(' ') + reach;
}

QString sentenceOf(const fuzzy::ForceModel& model, const PullWish& wish, const analysis::CurvePull& found) {
  const QString off = forceText(found.residual_n, model.output.unit);
  QString out = wish.kind == PullWish::Kind::kBand ? PullText::tr("The force is %1 (RMS) outside the band.").arg(off)
                                                   : PullText::tr("The force is %1 (RMS) from the curve.").arg(off);
  if (found.candidates.empty() && found.close) out += QLatin1Char(' ') + PullText::tr("Nothing has to change.");
  if (const std::string blocker = analysis::blockerText(found); !blocker.empty())
    out += QLatin1Char(' ') + PullText::tr("Out of reach: %1.").arg(text(blocker));
  return out;
}

/// The places of the offers in the list: the best plausible ones of different kinds, then those that are not plausible.
std::vector<std::size_t> offered(const std::vector<analysis::PullCandidate>& candidates) {
  std::vector<std::size_t> out = analysis::bestOfEachKind(candidates);
  constexpr std::size_t kMostFolded = 3;
  std::size_t folded = 0;
  for (std::size_t i = 0; i < candidates.size() && folded < kMostFolded; ++i) {
    if (!candidates[i].folded) continue;
    ++folded;
    if (std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
  }
  return out;
}

/// What a search found, of a point or of a curve.
struct Found {
  PullAnswer answer;
  std::vector<analysis::PullCandidate> candidates;
  std::vector<std::string> words;
};

template <class Candidates>
void addWords(Found& found, const fuzzy::ForceModel& model, const Candidates& candidates) {
  for (const auto& one : candidates) found.words.push_back(analysis::outcomeText(model, one));
}

}  // namespace

PullController::Search::Answer PullController::answerOf(const Question& question, const RunOf<PullAnswer>& run,
                                                        Linted& linted) {
  const OpenModel& open = *question.open;
  const fuzzy::ForceModel& model = open.model;
  const auto& expert = question.settings.expert;
  Found found;
  if (question.wish.kind == PullWish::Kind::kPoint) {
    auto pull = analysis::pull(model, question.point, question.wish.force_n, elicitation::justNoticeableDifference,
                               question.settings);
    if (!pull) return tl::unexpected(text(pull.error().message()));
    found.answer = {pull->before_n, pull->reachable, sentenceOf(model, *pull), {}};
    addWords(found, model, pull->candidates);
    found.candidates = std::move(pull->candidates);
  } else {
    const auto reference = referenceOf(question.wish, question.point, question.x_input, model.inputs[question.x_input]);
    auto pull = analysis::pullToCurve(model, question.point, reference, elicitation::justNoticeableDifference,
                                      question.settings);
    if (!pull) return tl::unexpected(text(pull.error().message()));
    found.answer.sentence = sentenceOf(model, question.wish, *pull);
    addWords(found, model, pull->candidates);
    for (auto& one : pull->candidates) found.candidates.push_back(std::move(one.candidate));
  }
  std::vector<std::size_t> places = offered(found.candidates);
  if (!question.whole) places.resize(std::min<std::size_t>(places.size(), 1));
  std::vector<PullOffer>& offers = found.answer.offers;
  for (const std::size_t place : places) {
    if (run.stop.stop_requested()) return nullptr;
    offers.push_back(offerOf(model, found.candidates[place], found.words[place], expert));
    addCurve(offers.back(), analysis::applied(model, offers.back().edits), question.point, question.x_input, expert);
  }
  if (question.whole && !offers.empty()) {
    run.hand(found.answer);
    if (linted.of.lock() != question.open) {
      const auto findings = std::make_shared<const analysis::NewFindings>(model, open.compiled, run.stop);
      if (run.stop.stop_requested()) return nullptr;
      linted = {question.open, findings};
    }
    for (PullOffer& offer : offers) {
      const auto sentences = linted.findings->of(analysis::applied(model, offer.edits), run.stop);
      if (run.stop.stop_requested()) return nullptr;
      for (const std::string& one : sentences) offer.notes << tr("New finding: %1").arg(text(one));
    }
  } else if (!question.whole) {
    run.show(std::move(found.answer));
    return nullptr;
  }
  return std::make_shared<const PullAnswer>(std::move(found.answer));
}

}  // namespace tactus::workbench
