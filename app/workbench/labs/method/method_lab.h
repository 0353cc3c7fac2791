// The method study without widgets: on request, the averaged model under other choices of the method, and the curves of
// one choice where it moves the force most.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/base/columns.h"
#include "app/workbench/labs/data/lab_data.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {

/// A value that was tried for a choice, as the screen shows it.
struct VariantRow {
  std::size_t index = 0;  ///< in the study
  QString value, rms, noticeable, felt, largest, where;
  QString unavailable;  ///< why it has no numbers; empty if it has
};

std::vector<Column<VariantRow>> variantColumns();
/// The variants of `factor`.
std::vector<VariantRow> variantRows(const elicitation::MethodStudy& study, const std::string& factor,
                                    const fuzzy::ForceModel& model);

/// A choice of the method with one sentence: does it matter?
struct FactorRow {
  std::size_t index = 0;  ///< in the study
  QString factor, now, verdict, sentence, largest, noticeable;
};

inline constexpr int kVerdictColumn = 2;  ///< of these
std::vector<Column<FactorRow>> factorColumns();
/// The largest effect first.
std::vector<FactorRow> factorRows(const elicitation::MethodStudy& study);

/// The averaged force as it is and with another choice, along the depth through the place of the largest difference.
struct MethodCurves {
  std::size_t variant = 0;  ///< in the study
  std::size_t x_input = 0;
  std::vector<double> at;  ///< one value per input
  figures::ForceCurves now;
  figures::ForceCurves other;
};

/// Thread: gui.
class MethodLab : public QObject {
  Q_OBJECT

 public:
  /// What was compared elsewhere last; nothing: nothing.
  using Studied = std::function<std::optional<StudiedMethod>()>;

  /// `data` outlives this. `studied` is asked before choices are compared, so that it is not done twice; may be empty.
  explicit MethodLab(LabData& data, Studied studied = {}, QObject* parent = nullptr);

  /// Compares the choices for the study and the settings of this moment. Runs also while the lab is hidden.
  void compare();
  void cancel() { found_.cancel(); }
  Computation& work() { return found_; }
  bool isBusy() const { return found_.isBusy(); }
  /// A study is open and read, so that `compare` does something.
  bool isPossible() const { return data_.study() != nullptr; }

  /// What was found; null while there is nothing.
  const elicitation::MethodStudy* found() const { return found_.value() ? found_.value()->study.get() : nullptr; }
  /// Rises with each change of `found`.
  int foundNumber() const { return number_; }
  /// The model that the others were compared with. Only with `found`.
  const fuzzy::ForceModel& model() const { return found_.value()->built->model; }
  /// The study or a setting has changed since.
  bool isOld() const { return old_; }
  /// Why nothing could be compared; empty if it could.
  const QString& failure() const { return found_.failure(); }
  const LabData& data() const { return data_; }

  /// Draws the curves of a variant; nothing: none.
  void choose(std::optional<std::size_t> variant);
  const std::optional<std::size_t>& chosen() const { return chosen_; }
  /// Of the chosen variant; null while they are computed, or if there is no such model.
  const MethodCurves* curves() const { return curves_.value().get(); }

  /// They are being computed.
  bool isDrawing() const { return curves_.isBusy(); }

  /// Whether the lab is on the screen: then the study is read.
  void setWanted(bool wanted);

 signals:
  /// `found`, `isOld`, `failure`, `isPossible` or `isBusy` changed.
  void changed();
  void curvesChanged();

 private:
  struct Found {
    std::shared_ptr<const elicitation::BuiltModel> built;
    std::shared_ptr<const elicitation::MethodStudy> study;
  };
  struct Order {
    LabInputs from;
    std::optional<Found> known;  ///< it was done elsewhere for the same study and settings
  };
  struct Drawn {
    std::shared_ptr<const Order> of;
    std::shared_ptr<const Found> found;
    std::size_t variant = 0;
  };
  using FoundCell = Computed<Order, Found>;
  using CurvesCell = Computed<Drawn, MethodCurves>;
  static FoundCell::Answer compareChoices(const Order& order, const RunOf<Found>& run);
  static CurvesCell::Answer draw(const Drawn& drawn, const RunOf<MethodCurves>& run);
  std::optional<Drawn> drawn() const;
  std::optional<Order> orderNow() const;
  void markOld();

  LabData& data_;
  Studied studied_;
  std::optional<Order> order_;  ///< what is compared: the study and the settings when the button was pressed
  int number_ = 0;
  bool old_ = false;
  std::optional<std::size_t> chosen_;
  FoundCell found_;
  CurvesCell curves_;
};

/// The inputs of `at` but the one of the curves, for a caption: `Tube lubrication 1 · Neck flexion angle 60 deg`.
QString placeOfCurves(const fuzzy::ForceModel& model, const MethodCurves& curves);

}  // namespace tactus::workbench
