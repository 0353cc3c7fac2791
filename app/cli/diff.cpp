#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using base::formatNumber;

struct Difference {
  std::vector<analysis::ModelChange> changes;
  analysis::ForceDifference force;
};

/// `lubrication 1, depth 30`.
std::string placeText(const fuzzy::ForceModel& model, const std::vector<double>& at) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < at.size(); ++i) {
    parts.push_back(base::oneLine(model.inputs[i].id) + " " + base::formatFixed(at[i], 3));
  }
  return base::joined(parts, ", ");
}

std::string asText(const fuzzy::ForceModel& model, const Difference& difference) {
  std::string text;
  for (const analysis::ModelChange& change : difference.changes) {
    const std::string arrow = !change.before.empty() && !change.after.empty() ? " -> " : "";
    text += std::string(name(change.kind)) + "  " + base::oneLine(change.place) + ": " +
            base::oneLine(change.before + arrow + change.after) + '\n';
  }
  if (text.empty()) text = "no term, rule or setting differs\n";
  const analysis::ForceDifference& force = difference.force;
  if (force.at.empty()) {
    text += "force: no difference at " + std::to_string(force.points) + " points\n";
  } else {
    text += "force: at most " + base::formatFixed(force.largest_n, 6) + " N apart, " + formatNumber(force.first_n) +
            " N and " + formatNumber(force.second_n) + " N at " + placeText(model, force.at) + "\n       rms " +
            base::formatFixed(force.rms_n, 6) + " N over the universes; " + std::to_string(force.points) + " points\n";
  }
  if (force.only_one_fires > 0)
    text += "       at " + std::to_string(force.only_one_fires) + " further points only one of them has a force\n";
  return text;
}

std::string asJson(const DiffOptions& options, const fuzzy::ForceModel& model, const Difference& difference) {
  base::JsonWriter json;
  json.beginObject().key("first").value(options.first).key("second").value(options.second);
  json.key("changes").beginArray();
  for (const analysis::ModelChange& change : difference.changes) {
    json.beginObject().key("kind").value(name(change.kind)).key("place").value(change.place);
    json.key("before").value(change.before).key("after").value(change.after).endObject();
  }
  const analysis::ForceDifference& force = difference.force;
  json.endArray().key("force").beginObject().key("largest_n").value(force.largest_n);
  json.key("at").beginObject();
  for (std::size_t i = 0; i < force.at.size(); ++i) json.key(model.inputs[i].id).value(force.at[i]);
  json.endObject().key("first_n").value(force.first_n).key("second_n").value(force.second_n);
  json.key("rms_n").value(force.rms_n).key("points").value(force.points);
  json.key("only_one_fires").value(force.only_one_fires).endObject().endObject();
  return json.text();
}

/// The same inputs in the same order, or the force at a point means different things.
base::Result<void> wantSameInputs(const DiffOptions& options, const fuzzy::ForceModel& first,
                                  const fuzzy::ForceModel& second) {
  const auto ids = [](const fuzzy::ForceModel& model) {
    std::vector<std::string> out;
    for (const fuzzy::Variable& input : model.inputs) out.push_back(input.id);
    return base::joined(out, ", ");
  };
  if (ids(first) == ids(second)) return {};
  return tl::unexpected(base::Error{base::ErrorCode::kData, options.second, "/inputs", ids(second),
                                    ids(first) + ", the inputs of " + options.first});
}

}  // namespace

base::Result<Output> diff(const DiffOptions& options) {
  TACTUS_TRY(const auto first, openedModel(options.first));
  TACTUS_TRY(const auto second, openedModel(options.second));
  if (const auto same = wantSameInputs(options, first.model, second.model); !same) return tl::unexpected(same.error());
  const Difference difference{analysis::modelChanges(first.model, second.model),
                              analysis::forceDifference(first.model, first.compiled, second.model, second.compiled)};
  std::vector<std::string> warnings = first.warnings;
  warnings.insert(warnings.end(), second.warnings.begin(), second.warnings.end());
  return Output{options.json ? asJson(options, first.model, difference) : asText(first.model, difference),
                std::move(warnings)};
}

}  // namespace tactus::cli
