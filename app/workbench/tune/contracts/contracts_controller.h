// The contracts of the open model, and whether it keeps them: checked in the background while somebody looks, anew
// after each edit. Method and grammar: docs/contracts.md.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/editing/edit.h"
#include "app/workbench/base/computed.h"
#include "core/contracts/contract_check.h"
#include "core/fuzzy/force_model.h"

class QDialog;
class QWidget;

namespace tactus::workbench {

class EditController;
class SceneController;

// Contracts in words, with the labels of the model (contract_words.cpp).

/// `More Tube lubrication never raises the force`. A name that the model does not have stands as it is.
QString contractSentence(const fuzzy::ForceModel& model, const fuzzy::Contract& contract);
/// What is known beside the verdict: where a contract is violated and by how much, or why it is open, with the bound.
/// Empty for a proved one.
QString contractDetails(const fuzzy::ForceModel& model, const contracts::ContractResult& result);
/// One contract of each kind that the declared directions of the model's procedure and its inputs suggest, without
/// those that the model has.
std::vector<fuzzy::Contract> offeredContracts(const fuzzy::ForceModel& model);

enum class ContractState {
  kComputing,  ///< nothing is known yet
  kProved,
  kBroken,
  kOpen,
};

/// `proved`, `broken`, `open`, `computing…`; of an older model `was proved`, ….
QString stateText(ContractState state, bool old);

struct ShownContract {
  QString sentence;
  ContractState state = ContractState::kComputing;
  bool old = false;                         ///< the state is of an older model; the new one is computed
  QString details;                          ///< contractDetails
  std::vector<std::vector<double>> places;  ///< of a broken one: where it is felt, one or two
  std::optional<std::size_t> along;         ///< the input in which two places differ

  bool operator==(const ShownContract&) const = default;
};

/// Thread: gui.
class ContractsController : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  ContractsController(EditController& edits, SceneController& scene, QObject* parent = nullptr);

  /// The checks are kept current while a view holds them.
  void hold(QObject& holder, bool held = true) { checks_.hold(holder, held); }

  bool isOpen() const;
  /// The open model; needs one.
  const fuzzy::ForceModel& model() const;
  /// One for each contract of the open model, in its order.
  const std::vector<ShownContract>& shown() const { return shown_; }
  std::size_t count(ContractState state) const;
  /// Each state is of the open model as it is now.
  bool isCurrent() const;
  bool isBusy() const { return checks_.isBusy(); }

  /// Each is one entry of the undo list. Returns whether it was made.
  bool add(fuzzy::Contract contract);
  bool replace(std::size_t index, fuzzy::Contract contract);
  bool remove(std::size_t index);

  /// Moves the operating point to place `place` of a broken contract, and puts the input in which its places differ on
  /// the x axis.
  void feel(std::size_t index, std::size_t place);

 signals:
  void changed();
  /// The operating point is where a contract is broken, to be felt there.
  void placeShown(const std::vector<double>& point);

 private:
  struct Known {
    fuzzy::Contract contract;
    contracts::ContractResult result;
    editing::SharedModel model;
  };
  struct Question {
    editing::SharedModel model;
    std::vector<Known> known;
  };
  using Checks = Computed<Question, std::vector<Known>>;

  static Checks::Answer answerOf(const Question& question, const RunOf<std::vector<Known>>& run);
  void checkAgain();
  void onResult();
  void show();
  const Known* knownOf(const fuzzy::Contract& contract) const;

  EditController& edits_;
  SceneController& scene_;
  editing::SharedModel followed_;  ///< the open model; null before the first
  std::vector<Known> known_;       ///< the newest result of each contract
  std::vector<ShownContract> shown_;
  Checks checks_;
};

/// The list of contracts, with the menu to add one. It holds the checks while it is visible.
QWidget* makeContractsPanel(ContractsController& contracts);

/// Asks for the choices of a contract, begun with those of `contract`; puts it in the place of number `index`, or adds
/// it. The caller shows the dialog, which is deleted when it closes.
QDialog* makeContractForm(ContractsController& contracts, const fuzzy::Contract& contract,
                          std::optional<std::size_t> index, QWidget* parent);

}  // namespace tactus::workbench
