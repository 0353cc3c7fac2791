#include "app/editing/kept_model.h"

#include <utility>

#include "app/editing/same_bits.h"

namespace tactus::editing {
namespace {

std::size_t bytesOf(const std::vector<fuzzy::Term>& terms) {
  std::size_t bytes = 0;
  for (const auto& term : terms) bytes += sizeof(fuzzy::Term) + term.points.size() * sizeof(double) + term.label.size();
  return bytes;
}

std::size_t bytesOf(const fuzzy::Expert& expert) {
  std::size_t bytes = sizeof(fuzzy::Expert);
  for (const auto& own : expert.overrides) bytes += bytesOf(own.terms);
  for (const auto& rule : expert.rules) {
    bytes += sizeof(fuzzy::Rule) + rule.conditions.size() * sizeof(fuzzy::Condition);
  }
  return bytes;
}

/// A copy without the experts, which may be many.
fuzzy::ForceModel withoutExperts(const fuzzy::ForceModel& model) {
  fuzzy::ForceModel out;
  out.name = model.name;
  out.created_utc = model.created_utc;
  out.generator = model.generator;
  out.provenance = model.provenance;
  out.inputs = model.inputs;
  out.output = model.output;
  out.implication = model.implication;
  out.default_force_n = model.default_force_n;
  out.accepted_holes = model.accepted_holes;
  out.renderer = model.renderer;
  out.checks = model.checks;
  out.extra = model.extra;
  return out;
}

}  // namespace

KeptModel::KeptModel(const fuzzy::ForceModel& model, const KeptModel* like) : rest_(withoutExperts(model)) {
  experts_.reserve(model.experts.size());
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const bool shared = like != nullptr && e < like->experts_.size() && sameBits(model.experts[e], *like->experts_[e]);
    experts_.push_back(shared ? like->experts_[e] : std::make_shared<const fuzzy::Expert>(model.experts[e]));
  }
}

fuzzy::ForceModel KeptModel::restored() const {
  fuzzy::ForceModel out = rest_;
  out.experts.reserve(experts_.size());
  for (const auto& expert : experts_) out.experts.push_back(*expert);
  return out;
}

std::size_t KeptModel::bytes(std::unordered_set<const fuzzy::Expert*>& counted) const {
  std::size_t bytes = sizeof(KeptModel) + experts_.size() * sizeof(experts_[0]) + bytesOf(rest_.output.terms);
  for (const auto& input : rest_.inputs) bytes += sizeof(fuzzy::Variable) + bytesOf(input.terms);
  for (const auto& check : rest_.checks) bytes += sizeof(fuzzy::Check) + check.in.size() * sizeof(double);
  for (const auto& expert : experts_) {
    if (counted.insert(expert.get()).second) bytes += bytesOf(*expert);
  }
  return bytes;
}

}  // namespace tactus::editing
