#include "app/workbench/tune/terms/terms_before.h"

namespace tactus::workbench {

std::vector<fuzzy::Term> termsBefore(const fuzzy::ForceModel& model, const editing::TermListId& list,
                                     const fuzzy::Variable& variable) {
  const fuzzy::Variable* found = &model.output;
  for (const fuzzy::Variable& input : model.inputs) {
    if (input.id == variable.id) found = &input;
  }
  if (found->id != variable.id) return {};
  for (const fuzzy::Expert& expert : model.experts) {
    if (!list.expert.empty() && expert.id == list.expert) return fuzzy::termsFor(expert, *found);
  }
  return found->terms;
}

}  // namespace tactus::workbench
