#include "app/editing/edit_history.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "app/editing/edit.h"
#include "core/base/check.h"
#include "core/base/error.h"

namespace tactus::editing {
namespace {

using Place = HistoryRow::Place;

class Rows {
 public:
  explicit Rows(const EditHistory& history)
      : history_(history), children_(history.states().size()), places_(history.states().size(), Place::kBranch) {
    const auto& states = history_.states();
    for (StateId state = 0; state < states.size(); ++state) {
      if (states[state].parent) children_[*states[state].parent].push_back(state);
    }
    Place place = Place::kDone;
    for (const StateId state : history_.line()) {
      if (state == history_.current()) {
        places_[state] = Place::kCurrent;
        place = Place::kUndone;
      } else {
        places_[state] = place;
      }
    }
  }

  std::vector<HistoryRow> all() {
    const auto& states = history_.states();
    for (StateId state = 0; state < states.size(); ++state) {
      if (!states[state].parent) add(state);
    }
    addMarks();
    return std::move(rows_);
  }

 private:
  struct Chain {
    StateId state;
    std::size_t level;
    bool starts;
  };

  // Chains wait on a stack, the one to come next on top: a history may be deeper than a call stack.
  void add(StateId root) {
    std::vector<Chain> waiting = {{root, 0, true}};
    while (!waiting.empty()) {
      const Chain chain = waiting.back();
      waiting.pop_back();
      const auto& next = history_.states()[chain.state].redo;
      HistoryRow row;
      row.state = chain.state;
      row.place = places_[chain.state];
      row.level = chain.level;
      row.starts = chain.starts;
      row.goes_on = next.has_value();
      rows_.push_back(std::move(row));
      if (next) waiting.push_back({*next, chain.level, false});
      const auto& children = children_[chain.state];
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        if (*child != next) waiting.push_back({*child, chain.level + 1, true});
      }
    }
  }

  void addMarks() {
    std::vector<std::size_t> row_of(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) row_of[rows_[row].state] = row;
    const auto& events = history_.events();
    for (std::size_t e = 0; e < events.size(); ++e) {
      const EventKind kind = events[e].kind;
      if (kind == EventKind::kSnapshot || kind == EventKind::kSignOff)
        rows_[row_of[events[e].state]].marks.push_back(e);
    }
  }

  const EditHistory& history_;
  std::vector<std::vector<StateId>> children_;
  std::vector<Place> places_;
  std::vector<HistoryRow> rows_;
};

}  // namespace

std::vector<HistoryRow> historyRows(const EditHistory& history) { return Rows(history).all(); }

namespace {

std::size_t bytesOf(const std::vector<fuzzy::Term>& terms) {
  std::size_t bytes = 0;
  for (const auto& term : terms) bytes += sizeof(fuzzy::Term) + term.points.size() * sizeof(double) + term.label.size();
  return bytes;
}

std::size_t bytesOf(const fuzzy::Expert& expert) {
  std::size_t bytes = sizeof(fuzzy::Expert);
  for (const auto& own : expert.overrides) bytes += bytesOf(own.terms);
  for (const auto& rule : expert.rules) {
    bytes += sizeof(fuzzy::Rule) + rule.conditions.size() * sizeof(fuzzy::Condition);
  }
  return bytes;
}

/// A copy without the experts, which may be many.
fuzzy::ForceModel withoutExperts(const fuzzy::ForceModel& model) {
  fuzzy::ForceModel out;
  out.name = model.name;
  out.created_utc = model.created_utc;
  out.generator = model.generator;
  out.provenance = model.provenance;
  out.inputs = model.inputs;
  out.output = model.output;
  out.implication = model.implication;
  out.default_force_n = model.default_force_n;
  out.accepted_holes = model.accepted_holes;
  out.renderer = model.renderer;
  out.checks = model.checks;
  out.contracts = model.contracts;
  out.events = model.events;
  out.extra = model.extra;
  return out;
}

}  // namespace

KeptModel::KeptModel(const fuzzy::ForceModel& model, const KeptModel* like) : rest_(withoutExperts(model)) {
  experts_.reserve(model.experts.size());
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const bool shared = like != nullptr && e < like->experts_.size() && sameBits(model.experts[e], *like->experts_[e]);
    experts_.push_back(shared ? like->experts_[e] : std::make_shared<const fuzzy::Expert>(model.experts[e]));
  }
}

fuzzy::ForceModel KeptModel::restored() const {
  fuzzy::ForceModel out = rest_;
  out.experts.reserve(experts_.size());
  for (const auto& expert : experts_) out.experts.push_back(*expert);
  return out;
}

std::size_t KeptModel::bytes(std::unordered_set<const fuzzy::Expert*>& counted) const {
  std::size_t bytes = sizeof(KeptModel) + experts_.size() * sizeof(experts_[0]) + bytesOf(rest_.output.terms);
  for (const auto& input : rest_.inputs) bytes += sizeof(fuzzy::Variable) + bytesOf(input.terms);
  for (const auto& check : rest_.checks) bytes += sizeof(fuzzy::Check) + check.in.size() * sizeof(double);
  for (const auto& expert : experts_) {
    if (counted.insert(expert.get()).second) bytes += bytesOf(*expert);
  }
  return bytes;
}

namespace {

constexpr auto kFelt = "feels right";
constexpr auto kUnfelt = "approved without feeling";

std::string counted(std::size_t number, const std::string& what) {
  return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

}  // namespace

std::string signOffText(std::size_t edits, const Felt& felt) {
  const std::string after = ", after " + counted(edits, "edit");
  if (felt.strokes == 0) return kUnfelt + after;
  std::string out = kFelt + after + ": " + counted(felt.strokes, "stroke") + " on " + felt.device;
  if (felt.simulated) out += " (simulated)";
  if (!felt.regions.empty()) out += ", " + felt.regions.front();
  if (felt.regions.size() > 1) out += " to " + felt.regions.back();
  return out;
}

bool saysFelt(const std::string& label) { return label.starts_with(kFelt); }

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;

std::string_view name(EventKind kind) noexcept {
  switch (kind) {
    case EventKind::kOpened: return "opened";
    case EventKind::kEdit: return "edit";
    case EventKind::kUndo: return "undo";
    case EventKind::kRedo: return "redo";
    case EventKind::kReturn: return "return";
    case EventKind::kSnapshot: return "snapshot";
    case EventKind::kSignOff: return "sign-off";
  }
  return "";
}

Result<EditHistory> EditHistory::open(const ForceModel& model, const std::string& label, const Stamp& stamp,
                                      study::RecordIds ids) {
  TACTUS_TRY(auto ready, editing::ready(model));
  return open(std::move(ready), label, stamp, ids);
}

EditHistory EditHistory::open(SharedModel model, const std::string& label, const Stamp& stamp, study::RecordIds ids) {
  EditHistory out(ids);
  State opened;
  opened.kept = std::make_shared<const KeptModel>(model->model, nullptr);
  out.states_.push_back(std::move(opened));
  out.enter(0, std::move(model));
  out.record(EventKind::kOpened, label, stamp, {});
  return out;
}

void EditHistory::begin() {
  in_gesture_ = true;
  shown_.reset();
}

void EditHistory::update(Edit edit) {
  in_gesture_ = true;
  shown_ = Shown{std::make_shared<const ReadyModel>(ReadyModel{std::move(edit.model), std::move(edit.compiled)}),
                 std::move(edit.label)};
}

void EditHistory::cancel() {
  in_gesture_ = false;
  shown_.reset();
}

std::optional<StateId> EditHistory::commit(const Stamp& stamp) {
  in_gesture_ = false;
  auto shown = std::exchange(shown_, std::nullopt);
  if (!shown || sameBits(shown->ready->model, ready_->model)) return std::nullopt;
  SharedModel made = withFreshChecks(std::move(shown->ready));
  const StateId before = current_;
  const StateId after = states_.size();
  State state;
  state.parent = before;
  state.event = events_.size();
  state.edits = states_[before].edits + 1;
  state.kept = std::make_shared<const KeptModel>(made->model, states_[before].kept.get());
  states_.push_back(std::move(state));
  states_[before].redo = after;
  const study::RecordId parent = versionOf(before);
  enter(after, std::move(made));
  record(EventKind::kEdit, std::move(shown->label), stamp, parent);
  return after;
}

std::optional<StateId> EditHistory::apply(Edit edit, const Stamp& stamp) {
  if (in_gesture_) commit(stamp);
  update(std::move(edit));
  return commit(stamp);
}

void EditHistory::enter(StateId state, SharedModel model) {
  current_ = state;
  before_ = std::exchange(ready_, std::move(model));
  states_[state].ready = ready_;
}

void EditHistory::record(EventKind kind, std::string label, const Stamp& stamp, std::optional<study::RecordId> parent) {
  events_.push_back({ids_.next(), parent, kind, std::move(label), stamp, current_, false});
}

Result<void> EditHistory::moveTo(StateId state, EventKind kind, const Stamp& stamp) {
  TACTUS_TRY(auto model, readyOf(state));
  const std::string label = labelOf(kind == EventKind::kUndo ? current_ : state);
  enter(state, std::move(model));
  record(kind, label, stamp, versionOf(state));
  return {};
}

Result<void> EditHistory::undo(const Stamp& stamp) {
  commit(stamp);
  if (!canUndo()) return fail(ErrorCode::kValue, "undo", "the model that was opened", "an edit to undo");
  return moveTo(*states_[current_].parent, EventKind::kUndo, stamp);
}

Result<void> EditHistory::redo(const Stamp& stamp) {
  commit(stamp);
  if (!canRedo()) return fail(ErrorCode::kValue, "redo", "the last edit", "an edit to redo");
  return moveTo(*states_[current_].redo, EventKind::kRedo, stamp);
}

Result<void> EditHistory::returnTo(StateId state, const Stamp& stamp) {
  commit(stamp);
  if (state >= states_.size()) {
    return fail(ErrorCode::kReference, "state", std::to_string(state), "one of " + std::to_string(states_.size()));
  }
  if (state == current_) return {};
  if (auto ok = moveTo(state, EventKind::kReturn, stamp); !ok) return ok;
  // From here undo and redo go along the line on which the state lies.
  for (StateId s = state; states_[s].parent; s = *states_[s].parent) states_[*states_[s].parent].redo = s;
  return {};
}

void EditHistory::snapshot(const std::string& name, const Stamp& stamp) {
  commit(stamp);
  record(EventKind::kSnapshot, name, stamp, versionOf(current_));
}

void EditHistory::signOff(const Stamp& stamp, const Felt& felt) {
  commit(stamp);
  repeatSignOff(stamp, signOffText(states_[current_].edits, felt));
}

void EditHistory::repeatSignOff(const Stamp& stamp, const std::string& label) {
  commit(stamp);
  record(EventKind::kSignOff, label, stamp, versionOf(current_));
}

const std::string& EditHistory::nameOf(StateId state) const {
  const auto named = std::find_if(events_.rbegin(), events_.rend(), [&](const Event& event) {
    return event.kind == EventKind::kSnapshot && event.state == state;
  });
  return named != events_.rend() ? named->label : labelOf(state);
}

std::vector<StateId> EditHistory::line() const {
  std::vector<StateId> out = {current_};
  while (states_[out.back()].parent) out.push_back(*states_[out.back()].parent);
  std::reverse(out.begin(), out.end());
  while (states_[out.back()].redo) out.push_back(*states_[out.back()].redo);
  return out;
}

Result<ForceModel> EditHistory::modelOf(StateId state) const {
  if (state >= states_.size()) {
    return fail(ErrorCode::kReference, "state", std::to_string(state), "one of " + std::to_string(states_.size()));
  }
  if (state == current_) return ready_->model;
  if (states_[state].kept) return states_[state].kept->restored();
  return fail(ErrorCode::kData, "model version " + study::toText(versionOf(state)), "a state that is not in memory",
              "its text from the study file");
}

Result<SharedModel> EditHistory::readyOf(StateId state) const {
  if (state == current_) return ready_;
  if (state < states_.size() && states_[state].kept) {
    if (auto held = states_[state].ready.lock()) return held;
  }
  TACTUS_TRY(auto model, modelOf(state));
  auto made = editing::ready(std::move(model));
  // Every state was compiled when it was made.
  TACTUS_CHECK(made.has_value());
  states_[state].ready = *made;
  return *made;
}

std::optional<EditImpact> EditHistory::impact(StateId state) {
  if (state >= states_.size() || !states_[state].parent) return std::nullopt;
  if (!states_[state].impact) {
    const auto found = compare(*states_[state].parent, state);
    if (!found) return std::nullopt;
    states_[state].impact = *found;
  }
  return states_[state].impact;
}

bool EditHistory::include(StateId state, const GhostCurve& curve, std::size_t input, std::span<const double> point) {
  return impact(state) && editing::include(*states_[state].impact, curve, input, point);
}

Result<EditImpact> EditHistory::compare(StateId before, StateId after) const {
  TACTUS_TRY(const auto one, readyOf(before));
  TACTUS_TRY(const auto other, readyOf(after));
  return editImpact((one)->model, (one)->compiled, (other)->model, (other)->compiled);
}

void EditHistory::markStored(const study::RecordId& id) {
  // What is stored last is asked for first.
  const auto event = std::find_if(events_.rbegin(), events_.rend(), [&](const Event& e) { return e.id == id; });
  if (event != events_.rend()) event->stored = true;
}

std::size_t EditHistory::trim(std::size_t most_bytes) {
  std::vector<bool> pinned(states_.size());
  pinned[current_] = true;
  for (const auto& event : events_) {
    if (event.kind == EventKind::kSnapshot || event.kind == EventKind::kSignOff) pinned[event.state] = true;
  }
  std::unordered_set<const fuzzy::Expert*> counted;
  std::size_t bytes = 0;
  for (StateId s = states_.size(); s-- > 0;) {
    if (!states_[s].kept) continue;
    if (bytes > most_bytes && events_[states_[s].event].stored && !pinned[s]) {
      states_[s].kept.reset();
    } else {
      bytes += states_[s].kept->bytes(counted);
    }
  }
  return bytes;
}

std::optional<study::RecordId> EditHistory::missing(StateId state) const {
  if (state >= states_.size() || states_[state].kept || state == current_) return std::nullopt;
  return versionOf(state);
}

Result<void> EditHistory::provide(StateId state, const study::RecordId& version, const ForceModel& model) {
  if (state >= states_.size() || versionOf(state) != version) {
    return fail(ErrorCode::kMismatch, "state " + std::to_string(state), "model version " + study::toText(version),
                "the version of that state");
  }
  const auto& parent = states_[state].parent;
  states_[state].kept = std::make_shared<const KeptModel>(model, parent ? states_[*parent].kept.get() : nullptr);
  return {};
}

namespace {

// No edit changes what a model says of its build.
bool sameBuild(const ForceModel& one, const ForceModel& other) {
  return one.created_utc == other.created_utc && one.generator == other.generator && one.provenance == other.provenance;
}

/// From the state to the model that was opened.
std::vector<StateId> wayFrom(const EditHistory& history, StateId state) {
  std::vector<StateId> out = {state};
  while (history.states()[out.back()].parent) out.push_back(*history.states()[out.back()].parent);
  return out;
}

}  // namespace

Result<StateId> firstOfBuild(const EditHistory& history, StateId state, const StateReader& read) {
  TACTUS_TRY(const auto last, read(state));
  const std::vector<StateId> way = wayFrom(history, state);
  // A build is one run of the way, so its beginning is found by halves: states may have to be read from a file.
  std::size_t same = 0;
  std::size_t end = way.size();
  while (end - same > 1) {
    const std::size_t middle = same + (end - same) / 2;
    TACTUS_TRY(const auto earlier, read(way[middle]));
    (sameBuild(earlier->model, last->model) ? same : end) = middle;
  }
  return way[same];
}

Result<StateId> beginningOf(const EditHistory& history, StateId tuned, StateId target, const StateReader& read) {
  TACTUS_TRY(const auto last, read(tuned));
  TACTUS_TRY(const auto now, read(target));
  if (!sameBuild(last->model, now->model)) return firstOfBuild(history, tuned, read);
  const std::vector<StateId> other = wayFrom(history, target);
  const std::unordered_set<StateId> there(other.begin(), other.end());
  const std::vector<StateId> way = wayFrom(history, tuned);
  const auto common = std::find_if(way.begin(), way.end(), [&](StateId state) { return there.contains(state); });
  return common == way.end() ? way.back() : *common;
}

}  // namespace tactus::editing
