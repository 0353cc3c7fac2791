// What the rules of the selected expert do at the reading place. It belongs to the open model, also while a comparison
// shows another one.
#pragma once

#include <optional>
#include <string>

#include "core/analysis/explain.h"

namespace tactus::workbench {

class EditController;
class SceneController;
class Selection;

class RulesHere {
 public:
  RulesHere(const EditController& edits, const SceneController& scene, const Selection& selection);

  /// The strength of rule `rule`, in [0, 1].
  double strength(std::size_t rule) const;
  /// The membership of term `term` of an input, in [0, 1].
  double membership(const std::string& input_id, std::size_t term) const;
  /// The value of an input there.
  double value(const std::string& input_id) const;

  /// The model or the place changed.
  void forget() { own_.reset(); }

 private:
  const analysis::ExplainedExpert* expert() const;
  const analysis::Explanation& explanation() const;

  const EditController& edits_;
  const SceneController& scene_;
  const Selection& selection_;
  mutable std::optional<analysis::Explanation> own_;  ///< while another model is shown
};

}  // namespace tactus::workbench
