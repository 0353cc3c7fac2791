#include "app/workbench/tune/contracts/contracts_controller.h"

#include <algorithm>
#include <utility>

#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

using contracts::Verdict;

ContractState stateOf(const contracts::ContractResult& result) {
  switch (result.verdict) {
    case Verdict::kProved: return ContractState::kProved;
    case Verdict::kViolated: return ContractState::kBroken;
    case Verdict::kOpen: break;
  }
  return ContractState::kOpen;
}

/// Whether the models differ in nothing but their contracts, so that what is known of one holds for the other.
bool hasSameForces(const editing::SharedModel& one, const editing::SharedModel& other) {
  if (one == other) return true;
  fuzzy::ForceModel model = one->model;
  model.contracts = other->model.contracts;
  return editing::sameBits(model, other->model);
}

/// The input in which the two places differ.
std::optional<std::size_t> alongOf(const std::vector<std::vector<double>>& places) {
  if (places.size() < 2) return std::nullopt;
  const auto [one, other] = std::mismatch(places[0].begin(), places[0].end(), places[1].begin());
  return one == places[0].end() ? std::nullopt : std::optional(static_cast<std::size_t>(one - places[0].begin()));
}

}  // namespace

ContractsController::ContractsController(EditController& edits, SceneController& scene, QObject* parent)
    : QObject(parent),
      edits_(edits),
      scene_(scene),
      checks_(
          [this]() -> std::optional<Question> {
            if (followed_ == nullptr || followed_->model.contracts.empty()) return std::nullopt;
            return Question{followed_, known_};
          },
          &ContractsController::answerOf) {
  connect(&edits_, &EditController::modelReset, this, [this] {
    known_.clear();
    checks_.forget();
    checkAgain();
  });
  connect(&edits_, &EditController::changed, this, &ContractsController::checkAgain);
  connect(&edits_, &EditController::historyChanged, this, &ContractsController::checkAgain);
  connect(&checks_, &Computation::valueChanged, this, &ContractsController::onResult);
  connect(&checks_, &Computation::changed, this, &ContractsController::changed);
  checkAgain();
}

ContractsController::Checks::Answer ContractsController::answerOf(const Question& question,
                                                                  const RunOf<std::vector<Known>>& run) {
  const editing::ReadyModel& ready = *question.model;
  std::vector<Known> out;
  for (const fuzzy::Contract& contract : ready.model.contracts) {
    const auto known = std::find_if(question.known.begin(), question.known.end(), [&](const Known& one) {
      return one.contract == contract && hasSameForces(one.model, question.model);
    });
    if (known != question.known.end()) {
      out.push_back({contract, known->result, question.model});
      continue;
    }
    auto result = contracts::checkContract(ready.model, ready.compiled, contract, {}, run.stop);
    if (run.stop.stop_requested()) return nullptr;
    out.push_back({contract, std::move(result), question.model});
    run.show(out);
  }
  return std::make_shared<const std::vector<Known>>(std::move(out));
}

bool ContractsController::isOpen() const { return edits_.isOpen(); }

const fuzzy::ForceModel& ContractsController::model() const { return edits_.model(); }

std::size_t ContractsController::count(ContractState state) const {
  return static_cast<std::size_t>(
      std::count_if(shown_.begin(), shown_.end(), [state](const auto& one) { return one.state == state; }));
}

bool ContractsController::isCurrent() const {
  return std::none_of(shown_.begin(), shown_.end(),
                      [](const auto& one) { return one.old || one.state == ContractState::kComputing; });
}

bool ContractsController::add(fuzzy::Contract contract) {
  return edits_.apply(editing::addContract(edits_.model(), std::move(contract)));
}

bool ContractsController::replace(std::size_t index, fuzzy::Contract contract) {
  return edits_.apply(editing::replaceContract(edits_.model(), index, std::move(contract)));
}

bool ContractsController::remove(std::size_t index) {
  return edits_.apply(editing::removeContract(edits_.model(), index));
}

void ContractsController::feel(std::size_t index, std::size_t place) {
  if (index >= shown_.size() || place >= shown_[index].places.size()) return;
  const std::vector<double> point = shown_[index].places[place];
  if (scene_.model() == nullptr || point.size() != scene_.model()->model.inputs.size()) return;
  if (shown_[index].along) scene_.setXInput(*shown_[index].along);
  scene_.goTo(point);
  emit placeShown(point);
}

void ContractsController::checkAgain() {
  const editing::SharedModel now = edits_.isOpen() ? edits_.history().ready() : nullptr;
  if (now == followed_) return;
  followed_ = now;
  checks_.refresh();
  show();
}

void ContractsController::onResult() {
  if (checks_.value() == nullptr) return;
  for (const Known& one : *checks_.value()) {
    const auto before =
        std::find_if(known_.begin(), known_.end(), [&](const Known& known) { return known.contract == one.contract; });
    before == known_.end() ? known_.push_back(one) : void(*before = one);
  }
  if (followed_ != nullptr) {
    const auto& there = followed_->model.contracts;
    std::erase_if(known_, [&](const Known& known) {
      return std::find(there.begin(), there.end(), known.contract) == there.end();
    });
  }
  show();
}

const ContractsController::Known* ContractsController::knownOf(const fuzzy::Contract& contract) const {
  const auto found =
      std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.contract == contract; });
  return found == known_.end() ? nullptr : &*found;
}

void ContractsController::show() {
  std::vector<ShownContract> shown;
  if (followed_ != nullptr) {
    for (const fuzzy::Contract& contract : followed_->model.contracts) {
      ShownContract one;
      one.sentence = contractSentence(followed_->model, contract);
      if (const Known* const known = knownOf(contract)) {
        one.state = stateOf(known->result);
        one.old = known->model != followed_;
        one.details = contractDetails(known->model->model, known->result);
        for (const contracts::ForcePlace& place : known->result.counterexample) one.places.push_back(place.inputs);
        one.along = alongOf(one.places);
      }
      shown.push_back(std::move(one));
    }
  }
  if (shown == shown_) return;
  shown_ = std::move(shown);
  emit changed();
}

}  // namespace tactus::workbench
