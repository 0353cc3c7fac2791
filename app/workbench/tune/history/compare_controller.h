// Compares two versions of the model, A and B: how far their forces differ, and a switch that the user can see and
// feel. The open model never changes.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/model/shown_impact.h"
#include "core/analysis/force_difference.h"

namespace tactus::workbench {

class EditController;
class ModelController;

/// A version that the user can choose for a side of the comparison.
struct CompareChoice {
  enum class Kind {
    kOpen,      ///< the open model: the mean of its experts
    kPrevious,  ///< the state before the current one
    kExpert,    ///< one expert of the open model alone
    kState,     ///< a state of the history
  };
  Kind kind = Kind::kOpen;
  editing::StateId state = 0;  ///< for kState
  std::string expert;          ///< for kExpert: the id

  bool operator==(const CompareChoice&) const = default;
};

enum class CompareSide { kA, kB };

/// The difference between A and B: of their forces over the whole universe, and of what they are made of.
struct CompareResult {
  double largest_n = 0;    ///< largest |difference| found
  std::vector<double> at;  ///< its place, one value per input; empty if there is no difference
  double a_n = 0;          ///< the forces there
  double b_n = 0;
  double noticeable = 0;     ///< largest difference in just-noticeable differences around the force of A
  double rms_n = 0;          ///< over evenly spread points
  std::size_t only_one = 0;  ///< points at which only one of the two has a force
  std::vector<analysis::ModelChange> changes;  ///< terms, rules and settings that differ, as `tactus diff` lists them
};

/// Thread: gui. Computes the difference in the background; only the newest request counts.
class CompareController : public QObject {
  Q_OBJECT

 public:
  /// `curve`: the curve on the screen; the result is never less than it shows. None: the whole universe alone.
  CompareController(ModelController& models, EditController& edits, std::function<CurveSetting()> curve = {},
                    QObject* parent = nullptr);

  /// One entry of the list of choices.
  struct Option {
    CompareChoice choice;
    QString name;
  };
  /// The open model, the state before it, its experts, then snapshots, sign-offs and states, newest first.
  std::vector<Option> options() const;
  QString nameOf(const CompareChoice& choice) const;

  const CompareChoice& choice(CompareSide side) const { return sides_[index(side)]; }
  /// Chooses a version for a side. Ignores a state that the history does not have.
  void choose(CompareSide side, CompareChoice choice);

  /// The side on the screen and on the device; nothing if no comparison is active and the open model is shown.
  std::optional<CompareSide> shown() const { return shown_; }
  /// Whether another model than the open one is shown and felt.
  bool showsAnother() const;

  /// The compiled model of a side, or the reason why there is none.
  base::Result<std::shared_ptr<const OpenModel>> modelOf(CompareSide side);

  /// The result for the current sides; nothing until it is computed.
  const std::optional<CompareResult>& result() const { return result_; }
  /// Computes the result if it is not known and no gesture is in progress; ends with `resultChanged`.
  void compute();

 public slots:
  /// Shows and renders one side. Emits one sentence if that is not possible.
  void show(tactus::workbench::CompareSide side);
  /// Switches to B, and from B to A.
  void toggle();
  /// Shows and renders the open model again.
  void end();

 signals:
  /// The list of choices, or the choice itself, changed.
  void choicesChanged();
  void shownChanged();
  /// The result became known or unknown.
  void resultChanged();
  void refused(const QString& sentence);
  void said(const QString& sentence);

 private:
  static std::size_t index(CompareSide side) { return side == CompareSide::kA ? 0 : 1; }
  void reset();
  void onEdited();
  void forget();
  void include(CompareResult& result);
  base::Result<std::shared_ptr<const OpenModel>> make(const CompareChoice& choice);

  ModelController& models_;
  EditController& edits_;
  CompareChoice sides_[2];
  std::optional<CompareSide> shown_;
  std::optional<CompareResult> result_;
  const std::function<CurveSetting()> curve_;
  Background worker_;
};

}  // namespace tactus::workbench
