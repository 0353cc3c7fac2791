#include "app/editing/hole_acceptance.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "core/analysis/coverage.h"
#include "core/base/text.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;
using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void drop(Names& names, const Names& away) {
  std::erase_if(names, [&](const std::string& name) { return contains(away, name); });
}

}  // namespace

std::optional<Names> holeNames(const ForceModel& model) {
  std::set<std::string> names;
  bool complete = true;
  const auto look = [&](std::span<const std::size_t> experts) {
    if (experts.empty()) return;
    const auto found = analysis::coverage(model, experts);
    complete = complete && found.complete;
    for (const auto& hole : found.holes) names.insert(analysis::describe(hole, model));
  };
  std::vector<std::size_t> weighty;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].weight > 0) weighty.push_back(e);
    look(std::span(&e, 1));
  }
  look(weighty);
  if (!complete) return std::nullopt;
  return Names(names.begin(), names.end());
}

Names lapsedAcceptances(const ForceModel& model) {
  if (model.accepted_holes.empty()) return {};
  const auto names = holeNames(model);
  if (!names) return {};
  Names out = model.accepted_holes;
  drop(out, *names);
  return out;
}

Result<Edit> acceptHole(const ForceModel& model, const std::string& name) {
  if (contains(model.accepted_holes, name)) {
    return fail(ErrorCode::kValue, "accepted holes", name + " already", "a hole that is not accepted yet");
  }
  const Names lapsed = lapsedAcceptances(model);
  ForceModel out = model;
  drop(out.accepted_holes, lapsed);
  out.accepted_holes.push_back(name);
  std::string label = "Hole accepted: " + name;
  if (!lapsed.empty()) label += ", in the place of " + base::joined(lapsed, " and ");
  return finished(std::move(out), std::move(label));
}

Result<Edit> withdrawAcceptance(const ForceModel& model, const std::string& name) {
  if (!contains(model.accepted_holes, name)) {
    return fail(ErrorCode::kValue, "accepted holes", "no " + name, "a hole that is accepted");
  }
  ForceModel out = model;
  drop(out.accepted_holes, {name});
  return finished(std::move(out), "Acceptance withdrawn: " + name);
}

Result<Edit> forgetLapsed(const ForceModel& model) {
  const Names lapsed = lapsedAcceptances(model);
  if (lapsed.empty()) {
    return fail(ErrorCode::kValue, "accepted holes", "no lapsed acceptance", "an acceptance whose hole is gone");
  }
  ForceModel out = model;
  drop(out.accepted_holes, lapsed);
  return finished(std::move(out), "Lapsed acceptance removed: " + base::joined(lapsed, " and "));
}

}  // namespace tactus::editing
