// The part of each input's universe that the plots show: one range per input, the same in every plot, kept by the
// input's id through edits and other models.
#pragma once

#include <QObject>
#include <map>
#include <string>

#include "app/figures/force_curves.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class ShownRanges : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The range of `input`, inside its universe; all of it unless a part was chosen.
  figures::Interval of(const fuzzy::Variable& input) const;
  bool isPart(const fuzzy::Variable& input) const;

  /// Shows [low, high], as far as it lies in the universe. At least 1/200 of the universe is shown; ignores NaN.
  void show(const fuzzy::Variable& input, figures::Interval range);
  /// Scales the range by `factor`: below 1 shows less. The value `center` stays where it is.
  void zoom(const fuzzy::Variable& input, double center, double factor);
  /// Moves the range by `distance` in the unit of the input, as far as the universe goes.
  void pan(const fuzzy::Variable& input, double distance);
  void showAll(const fuzzy::Variable& input);

 signals:
  void changed(const std::string& input_id);

 private:
  std::map<std::string, figures::Interval> parts_;
};

}  // namespace tactus::workbench
