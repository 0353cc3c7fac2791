// The result of an edit of a force model: the new model, compiled, and the change in words.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

// Compares parts of a model bit for bit. The operator == treats 0 and -0 as equal; these functions do not.

bool sameBits(const fuzzy::Expert& one, const fuzzy::Expert& other);

/// The same for whole models. Undo guarantees it.
bool sameBits(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other);

/// A force model and its compiled form, which belong together. An edit makes them once; history, plots and servo share
/// them.
struct ReadyModel {
  fuzzy::ForceModel model;        ///< valid
  fuzzy::CompiledModel compiled;  ///< of `model`
};

/// Immutable, so any thread may read it. Never null, except where a comment says so.
using SharedModel = std::shared_ptr<const ReadyModel>;

/// Compiles `model`. A model that does not make sense is refused with the error of `fuzzy::validate`.
base::Result<SharedModel> ready(fuzzy::ForceModel model);

/// `model` with checks that are evaluated anew (refreshChecks); the same one if it has none.
SharedModel withFreshChecks(SharedModel model);

/// How far one press of an arrow key moves a vertex.
enum class StepSize { kFine, kCoarse };

/// Step in the unit of the variable, fine and coarse. mm and mm/s: 1 and 10; deg: 1 and 5; N: 0.01 and 0.05. Any other
/// unit: the round number (1, 2 or 5 times a power of ten) just below a hundredth and a tenth of the universe; for a
/// ratio 0.01 and 0.1.
double editStep(const fuzzy::Variable& variable, StepSize size);

/// `value` moved by `count` steps. A multiple of the step stays an exact multiple, without rounding errors.
double stepped(double value, double step, int count);

/// A finished edit. Edits are pure functions of the model before. During a drag each edit starts from the model at the
/// beginning of the gesture (EditHistory::base). So a drag into a neighbor and back leaves no trace.
struct Edit {
  fuzzy::ForceModel model;        ///< valid
  fuzzy::CompiledModel compiled;  ///< from `model`: to feel and plot it without compiling again
  std::string label;              ///< `Insertion depth / Nasopharynx: right foot 125 to 132 mm`
  std::string stopped;            ///< why the edit stopped short of the request; empty if it did not
};

/// Compiles `model`. An invalid model is refused with the error of `fuzzy::validate`.
base::Result<Edit> finished(fuzzy::ForceModel model, std::string label, std::string stopped = {});

/// Computes the expected forces of the checks in `model` again, at the same points; `compiled` is made from it. An edit
/// makes them wrong, and the reader refuses a model file with wrong checks. EditHistory does this once for each
/// gesture.
void refreshChecks(fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled);

// The names of edits, rules and values in words: labels if the model has them, ids otherwise.

std::string labelOf(const fuzzy::Variable& variable);
std::string labelOf(const fuzzy::Term& term);
std::string labelOf(const fuzzy::Expert& expert);

/// `left foot`, `left shoulder`, `right shoulder`, `right foot`; `left foot`, `peak`, `right foot`; `mean`, `sigma`.
/// `point` is below fuzzy::pointCount(shape).
std::string pointName(fuzzy::Shape shape, std::size_t point);

/// `value` to 1/10,000 of the universe or a little finer, without trailing zeros: `62.5`.
std::string numberText(const fuzzy::Variable& variable, double value);
/// The number with its unit: `62.5 mm`; a ratio has none.
std::string quantityText(const fuzzy::Variable& variable, double value);

/// `IF Tube lubrication is Well AND Insertion depth is Stomach`, with the labels of the terms of `expert`. An id that
/// the model does not have stays as it is.
std::string conditionsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule);
/// The label of an output term in the list of `expert`; `id` if there is none.
std::string consequentText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& id);

}  // namespace tactus::editing
