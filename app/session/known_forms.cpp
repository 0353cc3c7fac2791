#include "app/session/known_forms.h"

#include "questionnaires/form_file.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

std::vector<study::Form> knownForms() {
  std::vector<study::Form> forms = {questionnaires::ngtForceForm()};
  for (const auto& reading : questionnaires::s4Readings()) {
    study::Form form;
    form.id = reading.id;
    form.title = reading.title;
    form.depth_terms = reading.depth_terms;
    forms.push_back(std::move(form));
  }
  return forms;
}

}  // namespace tactus::session
