#include "app/workbench/model/shown_procedure.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

/// Whether `procedure` has every input of `model`.
bool hasInputsOf(const procedure::Procedure& procedure, const fuzzy::ForceModel& model) {
  return std::all_of(model.inputs.begin(), model.inputs.end(), [&procedure](const fuzzy::Variable& input) {
    return std::any_of(procedure.inputs.begin(), procedure.inputs.end(),
                       [&input](const fuzzy::Variable& known) { return known.id == input.id; });
  });
}

ProcedurePtr& shown() {
  static ProcedurePtr procedure = procedure::defaultProcedure();
  return procedure;
}

}  // namespace

ProcedurePtr procedureFor(const fuzzy::ForceModel& model, const ProcedurePtr& of_study) {
  const std::string id = procedure::procedureOf(model).id;
  if (of_study != nullptr && of_study->id == id && hasInputsOf(*of_study, model)) return of_study;
  const ProcedurePtr& usual = procedure::defaultProcedure();
  if (id != usual->id) return procedure::builtIn(id);
  return hasInputsOf(*usual, model) ? usual : nullptr;
}

QString inProgramLanguage(const procedure::Texts& texts) {
  return text(procedure::textIn(texts, programLanguage().toStdString()));
}

void showProcedure(ProcedurePtr procedure) { shown() = std::move(procedure); }

const ProcedurePtr& shownProcedure() { return shown(); }

std::optional<std::size_t> posedInput(const procedure::Procedure* procedure, const fuzzy::ForceModel& model) {
  if (procedure == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < procedure->inputs.size(); ++i) {
    const std::string& id = procedure->inputs[i].id;
    if (procedure->input_notes[i].picture != procedure::LevelPicture::kPose) continue;
    if (!procedure->words.contains("pose." + id + ".on") || !procedure->words.contains("pose." + id + ".off")) continue;
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      if (model.inputs[k].id == id && model.inputs[k].terms.size() > 1) return k;
    }
  }
  return std::nullopt;
}

}  // namespace tactus::workbench
