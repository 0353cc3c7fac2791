// Two versions of the model side by side: how far their forces are apart, and a switch between them that can be seen
// and felt. The open model is never changed by it.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/background.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/model/shown_impact.h"

namespace tactus::workbench {

class EditController;
class ModelController;

/// What can stand on a side of the comparison.
struct CompareChoice {
  enum class Kind {
    kOpen,      ///< the open model as it stands: the mean of its experts
    kPrevious,  ///< the state before the current one
    kExpert,    ///< one expert of the open model alone
    kState,     ///< a state of the history
  };
  Kind kind = Kind::kOpen;
  editing::StateId state = 0;  ///< of kState
  std::string expert;          ///< of kExpert: the id

  bool operator==(const CompareChoice&) const = default;
};

enum class CompareSide { kA, kB };

/// How far the force of A and the force of B are apart, over the whole universe.
struct CompareResult {
  double largest_n = 0;    ///< largest |difference| seen
  std::vector<double> at;  ///< where, one value per input; empty where no difference was seen
  double a_n = 0;          ///< the forces there
  double b_n = 0;
  double noticeable = 0;     ///< largest difference in just-noticeable ones around the force of A
  double rms_n = 0;          ///< over points spread evenly
  std::size_t only_one = 0;  ///< points at which only one of them has a force
};

/// Thread: gui. The difference is computed in the background; what is asked last counts.
class CompareController : public QObject {
  Q_OBJECT

 public:
  CompareController(ModelController& models, EditController& edits, QObject* parent = nullptr);

  /// One line of what can be chosen.
  struct Option {
    CompareChoice choice;
    QString name;
  };
  /// The open model, the state before it, its experts, then snapshots, sign-offs and states, the newest first.
  std::vector<Option> options() const;
  QString nameOf(const CompareChoice& choice) const;

  const CompareChoice& choice(CompareSide side) const { return sides_[index(side)]; }
  /// A state that the history does not have is not chosen.
  void choose(CompareSide side, CompareChoice choice);

  /// The side that is shown and felt; nothing where nobody compares and the open model is shown.
  std::optional<CompareSide> shown() const { return shown_; }
  /// Whether what is shown and felt is not the open model.
  bool showsAnother() const;

  /// The model of a side, compiled, or why there is none.
  base::Result<std::shared_ptr<const OpenModel>> modelOf(CompareSide side);

  /// Of the sides as they are, once it is known.
  const std::optional<CompareResult>& result() const { return result_; }
  /// What the screen shows as a curve: the result is at least what it shows.
  void setCurve(std::function<CurveSetting()> curve) { curve_ = std::move(curve); }
  /// Has the result computed where it is not known and no gesture goes on; ends with `resultChanged`.
  void compute();

 public slots:
  /// Shows and lets feel one side; what cannot be shown is refused with a sentence.
  void show(tactus::workbench::CompareSide side);
  /// B, and A after B.
  void toggle();
  /// The open model is shown and felt again.
  void end();

 signals:
  /// What can be chosen, or what is chosen.
  void choicesChanged();
  void shownChanged();
  /// The result became known, or is not known any more.
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
  std::function<CurveSetting()> curve_;
  Background worker_;
};

}  // namespace tactus::workbench
