#include <algorithm>
#include <utility>

#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "core/base/check.h"

namespace tactus::workbench {

RulesHere::RulesHere(const EditController& edits, const SceneController& scene, const Selection& selection)
    : edits_(edits), scene_(scene), selection_(selection) {}

double RulesHere::strength(std::size_t rule) const {
  const analysis::ExplainedExpert* const explained = expert();
  return explained != nullptr && rule < explained->rules.size() ? explained->rules[rule].strength : 0;
}

double RulesHere::membership(const std::string& input_id, std::size_t term) const {
  const analysis::ExplainedExpert* const explained = expert();
  const auto& inputs = edits_.model().inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const auto& v) { return v.id == input_id; });
  if (explained == nullptr || found == inputs.end()) return 0;
  const auto& memberships = explained->memberships[static_cast<std::size_t>(found - inputs.begin())];
  return term < memberships.size() ? memberships[term].membership : 0;
}

double RulesHere::value(const std::string& input_id) const {
  const auto& inputs = scene_.model()->model.inputs;
  const std::vector<double> point = scene_.readingPoint();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].id == input_id) return point[i];
  }
  return 0;
}

const analysis::ExplainedExpert* RulesHere::expert() const {
  if (scene_.model() == nullptr) return nullptr;
  for (const analysis::ExplainedExpert& explained : explanation().experts) {
    if (explained.id == selection_.expert()) return &explained;
  }
  return nullptr;
}

const analysis::Explanation& RulesHere::explanation() const {
  if (!scene_.showsAnother()) return scene_.explanation();
  // What is edited is the open model, also while another one is looked at.
  if (!own_) {
    auto explained = analysis::explain(edits_.model(), edits_.history().compiled(), scene_.readingPoint());
    TACTUS_CHECK(explained.has_value());
    own_ = std::move(*explained);
    scene_.countEvaluations(1 + own_->experts.size());
  }
  return *own_;
}

}  // namespace tactus::workbench
