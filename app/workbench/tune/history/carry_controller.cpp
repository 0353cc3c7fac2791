#include "app/workbench/tune/history/carry_controller.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "core/base/check.h"

namespace tactus::workbench {

using editing::CarriedEdit;
using editing::EditImpact;
using editing::Rebase;
using editing::StateId;

CarryController::CarryController(EditController& edits, Locks locks, Curve curve, QObject* parent)
    : QObject(parent),
      edits_(edits),
      locks_(std::move(locks)),
      curve_(std::move(curve)),
      list_([this] { return listInputs(); },
            [](const ListInputs& in, const RunOf<List>& run) -> Computed<ListInputs, List>::Answer {
              auto found = editing::rebase(in.base->model, in.tuned->model, in.target, in.locked);
              if (!found) return tl::unexpected(text(found.error().message()));
              List list{std::make_shared<const Rebase>(std::move(*found)), {}};
              const std::vector<CarriedEdit>& found_edits = list.rebase->edits;
              list.prices.resize(found_edits.size());
              run.hand(list);
              for (std::size_t e = 0; e < found_edits.size(); ++e) {
                if (run.stop.stop_requested()) return nullptr;
                const auto alone = price(*list.rebase, std::span(&e, 1), in.curve);
                if (found_edits[e].canApply() && alone) list.prices[e] = *alone;
                run.progress(static_cast<double>(e + 1) / static_cast<double>(found_edits.size()));
              }
              return std::make_shared<const List>(std::move(list));
            }),
      sum_([this] { return sumInputs(); },
           [](const SumInputs& in, const RunOf<EditImpact>&) -> Computed<SumInputs, EditImpact>::Answer {
             const auto all = price(*in.rebase, in.chosen, in.curve);
             if (!all) return tl::unexpected(text(all.error().message()));
             return std::make_shared<const EditImpact>(*all);
           }) {
  connect(&edits_, &EditController::modelReset, this, &CarryController::end);
  connect(&edits_, &EditController::historyChanged, this, &CarryController::followHistory);
  connect(&list_, &Computation::valueChanged, this, &CarryController::takeList);
}

base::Result<EditImpact> CarryController::price(const Rebase& rebase, std::span<const std::size_t> chosen,
                                                const CurveSetting& curve) {
  TACTUS_TRY(const auto edit, editing::carryOver(rebase, chosen));
  return shownImpact(rebase.target->model, rebase.target->compiled, edit.model, edit.compiled, curve);
}

std::optional<CarryController::Earlier> CarryController::earlier() {
  if (!edits_.isOpen()) return std::nullopt;
  const editing::EditHistory& history = edits_.history();
  const auto read = [this](StateId state) { return edits_.readyOf(state); };
  auto begin = editing::firstOfBuild(history, history.current(), read);
  while (begin && history.states()[*begin].parent) {
    const StateId state = *history.states()[*begin].parent;
    begin = editing::firstOfBuild(history, state, read);
    if (!begin) break;
    const std::size_t edits = history.states()[state].edits - history.states()[*begin].edits;
    if (edits > 0) return Earlier{state, edits};
  }
  return std::nullopt;
}

void CarryController::begin(StateId tuned) {
  TACTUS_CHECK(edits_.isOpen() && tuned < edits_.history().states().size());
  edits_.commit();
  asked_.clear();
  rows_.clear();
  tuned_ = tuned;
  target_ = edits_.history().current();
  list_.forget();
  emit rowsChanged();
}

void CarryController::end() {
  if (!tuned_) return;
  preview(std::nullopt);
  tuned_.reset();
  target_.reset();
  rows_.clear();
  list_.forget();
  emit rowsChanged();
}

QString CarryController::source() const {
  return tuned_ ? harmless(text(edits_.history().nameOf(*tuned_))) : QString();
}

QStringList CarryController::signOffsOf(StateId state) const {
  QStringList out;
  for (const editing::Event& event : edits_.history().events()) {
    if (event.kind == editing::EventKind::kSignOff && event.state == state) out << harmless(text(event.stamp.author));
  }
  out.removeDuplicates();
  return out;
}

QStringList CarryController::sourceSignOffs() const { return tuned_ ? signOffsOf(*tuned_) : QStringList(); }

QStringList CarryController::targetSignOffs() const {
  return tuned_ ? signOffsOf(edits_.history().current()) : QStringList();
}

std::vector<std::size_t> CarryController::chosen() const {
  std::vector<std::size_t> out;
  for (const CarryRow& row : rows_) {
    if (row.chosen) out.push_back(row.edit);
  }
  return out;
}

std::size_t CarryController::chosenCount() const { return chosen().size(); }

void CarryController::choose(std::size_t row, bool chosen) {
  if (!rows_[row].content.canApply()) return;
  rows_[row].chosen = chosen;
  asked_[rows_[row].content.what] = chosen;
  sum_.forget();
  emit rowsChanged();
}

void CarryController::chooseAll(bool chosen) {
  for (CarryRow& row : rows_) {
    if (!row.content.canApply()) continue;
    row.chosen = chosen;
    asked_[row.content.what] = chosen;
  }
  sum_.forget();
  emit rowsChanged();
}

const EditImpact* CarryController::together() const { return sum_.value().get(); }

QString CarryController::failure() const {
  if (!unread_.isEmpty()) return unread_;
  return list_.failure().isEmpty() ? sum_.failure() : list_.failure();
}

std::string CarryController::unit() const { return edits_.isOpen() ? edits_.model().output.unit : std::string(); }

QString CarryController::placeText(const std::vector<double>& at) const {
  QStringList places;
  for (std::size_t i = 0; i < at.size() && edits_.isOpen(); ++i) {
    const fuzzy::Variable& input = edits_.model().inputs[i];
    places << labelOf(input) + QLatin1Char(' ') + workbench::placeText(input, at[i]);
  }
  return places.join(QStringLiteral(", "));
}

void CarryController::preview(std::optional<std::size_t> row) {
  std::shared_ptr<const OpenModel> shown;
  QString name;
  if (row && *row < rows_.size() && rows_[*row].content.canApply() && list_.value()) {
    auto edit = editing::carryOver(*list_.value()->rebase, std::span(&rows_[*row].edit, 1));
    if (edit) {
      name = tr("With: %1").arg(harmless(text(edit->label)));
      shown = std::make_shared<const OpenModel>(std::make_shared<const editing::ReadyModel>(
          editing::ReadyModel{std::move(edit->model), std::move(edit->compiled)}));
    }
  }
  emit previewed(shown, name);
}

bool CarryController::carry() {
  if (!tuned_ || !list_.value() || list_.value()->rebase->target != edits_.history().ready()) return false;
  const auto all = chosen();
  if (all.empty()) return false;
  auto edit = editing::carryOver(*list_.value()->rebase, all);
  if (edit) end();
  return edits_.apply(std::move(edit));
}

std::optional<CarryController::ListInputs> CarryController::listInputs() {
  unread_.clear();
  if (!tuned_ || !edits_.isOpen()) return std::nullopt;
  const editing::EditHistory& history = edits_.history();
  const auto read = [this](StateId state) { return edits_.readyOf(state); };
  const auto begin = editing::beginningOf(history, *tuned_, history.current(), read);
  const auto base = begin ? read(*begin) : base::Result<editing::SharedModel>(tl::unexpected(begin.error()));
  const auto tuned = read(*tuned_);
  if (!base || !tuned) {
    // What is still being read from the study is tried again when it is there.
    unread_ = text((base ? tuned.error() : base.error()).message());
    return std::nullopt;
  }
  return ListInputs{*base, *tuned, history.ready(), locks_(), curve_()};
}

std::optional<CarryController::SumInputs> CarryController::sumInputs() const {
  if (!tuned_ || !list_.value()) return std::nullopt;
  return SumInputs{list_.value()->rebase, chosen(), curve_()};
}

void CarryController::followHistory() {
  if (!tuned_ || (target_ == edits_.history().current() && unread_.isEmpty())) return;
  target_ = edits_.history().current();
  preview(std::nullopt);
  list_.refresh();
}

void CarryController::takeList() {
  rows_.clear();
  const auto& list = list_.value();
  for (std::size_t e = 0; list && e < list->rebase->edits.size(); ++e) {
    const CarriedEdit& edit = list->rebase->edits[e];
    const auto asked = asked_.find(edit.what);
    const bool proposed = edit.outcome == CarriedEdit::Outcome::kApplies;
    rows_.push_back({e, edit, edit.canApply() && (asked != asked_.end() ? asked->second : proposed), list->prices[e]});
  }
  std::stable_partition(rows_.begin(), rows_.end(), [](const CarryRow& row) { return row.content.canApply(); });
  sum_.refresh();
  emit rowsChanged();
}

}  // namespace tactus::workbench
