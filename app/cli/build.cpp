#include <optional>

#include "app/cli/accepted_data.h"
#include "app/cli/commands.h"
#include "app/cli/data_text.h"
#include "app/cli/findings_text.h"
#include "app/cli/output_file.h"
#include "app/cli/speeds_text.h"
#include "app/cli/study_build.h"
#include "app/cli/wrapped_text.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "elicitation/model/expert_weights_compared.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::cli {
namespace {

using base::Result;

/// What a build gives besides the model file.
struct Results {
  const elicitation::BuiltModel& built;
  const std::vector<study::DataFinding>& data;
  const std::vector<std::string>& notices;
  elicitation::RuleLint lint;
  std::vector<elicitation::WeightedModel> weights;
  std::optional<elicitation::StudySpeedIntervals> speed_intervals;
  elicitation::ForceTermsFrom force_terms;
  std::vector<study::DataFinding::Kind> accepted;
};

/// `force terms from the vote: very_small 0 0 0.2 0.3; ...; the universe ends at 1.1 N`.
std::string forceAsText(const elicitation::BuiltModel& built, elicitation::ForceTermsFrom from) {
  if (!built.force_terms) return {};
  std::vector<std::string> terms;
  for (const auto& term : built.model.output.terms) {
    std::string text = term.id;
    for (const double point : term.points) text += ' ' + base::roundedNumber(point);
    terms.push_back(std::move(text));
  }
  return "force terms from the " + std::string(name(from)) + ": " + base::joined(terms, "; ") +
         " N; the universe ends at " + base::roundedNumber(built.model.output.max) + " N\n";
}

void writeForce(const elicitation::BuiltModel& built, elicitation::ForceTermsFrom from, base::JsonWriter& json) {
  json.key("force").beginObject().key("terms_from").value(built.force_terms ? name(from) : "default");
  json.key("end_n").value(built.model.output.max).key("terms").beginArray();
  for (const auto& term : built.model.output.terms) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(term.id);
    json.key("points").values(term.points).endObject();
  }
  json.endArray().endObject();
}

std::string summary(const BuildOptions& options, const Results& results) {
  const auto& built = results.built;
  std::string text = dataAsText(results.data, results.accepted);
  text += base::oneLine(options.out + ": " + built.model.name) + "; experts " +
          std::to_string(built.model.experts.size()) + '\n';
  for (const auto& expert : built.model.experts) {
    text += "  " + base::oneLine(expert.id) + ": rules " + std::to_string(expert.rules.size()) + ", weight " +
            base::formatNumber(expert.weight) + '\n';
  }
  text += speedsAsText(built, results.speed_intervals);
  text += forceAsText(built, results.force_terms);
  for (const auto& note : built.notes) text += wrapped(note, "note: ", 6);
  text += "findings " + std::to_string(results.lint.findings.size()) + '\n';
  return text + findingsAsText(results.lint.findings, built.model.output.unit);
}

/// The model under each policy as the member `weights` of the object that `json` is in.
void writeWeights(const std::vector<elicitation::WeightedModel>& models, base::JsonWriter& json) {
  json.key("weights").beginArray();
  for (const auto& one : models) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("policy").value(name(one.policy));
    if (!one.table.empty()) json.key("table").value(one.table);
    json.key("available").value(one.model.has_value());
    if (!one.model) {
      json.key("reason").value(one.unavailable).endObject();
      continue;
    }
    const auto& difference = one.from_equal;
    json.key("weights").beginArray(base::JsonWriter::Layout::kInline);
    for (const auto& expert : one.model->experts) json.value(expert.weight);
    json.endArray().key("largest_n").value(difference.largest_n).key("rms_n").value(difference.rms_n);
    json.key("at").values(difference.at).key("region");
    one.region.empty() ? json.null() : json.value(one.region);
    json.key("points").value(difference.points).key("only_one_fires").value(difference.only_one_fires).endObject();
  }
  json.endArray();
}

std::string asJson(const BuildOptions& options, const Results& results) {
  const auto& built = results.built;
  base::JsonWriter json;
  json.beginObject().key("model").value(options.out).key("name").value(built.model.name);
  writeData(results.data, json);
  json.key("accepted").beginArray(base::JsonWriter::Layout::kInline);
  for (const auto kind : results.accepted) json.value(name(kind));
  json.endArray();
  json.key("experts").beginArray();
  for (const auto& expert : built.model.experts) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(expert.id);
    json.key("rules").value(expert.rules.size()).key("weight").value(expert.weight).endObject();
  }
  json.endArray().key("notes").values(built.notes).key("notices").values(results.notices);
  writeSpeeds(built, results.speed_intervals, json);
  writeForce(built, results.force_terms, json);
  writeFindings(results.lint.findings, json);
  writeWeights(results.weights, json);
  json.endObject();
  return json.text();
}

}  // namespace

Result<Output> build(const BuildOptions& options) {
  auto made = buildStudy(options);
  if (!made) return tl::unexpected(made.error());
  auto& built = made->built;
  const auto& study = made->tables.study;
  const auto compiled = fuzzy::compile(built.model);
  if (!compiled) return inFile(compiled.error(), options.study);
  std::string no_intervals;
  const auto intervals = speedIntervals(study, built, made->settings, options.replicates, no_intervals);
  if (!no_intervals.empty()) built.notes.push_back(no_intervals);
  for (auto& note : acceptedNotes(made->data, made->accepted)) built.notes.push_back(std::move(note));
  Results results{built, made->data, made->notices,       elicitation::ruleLint(built.model, *compiled, built.experts),
                  {},    intervals,  options.force_terms, made->accepted};
  if (options.json) {
    auto weighted = elicitation::compareWeights(built, study, made->settings);
    if (!weighted) return inFile(weighted.error(), options.study);
    results.weights = std::move(*weighted);
  }
  const auto text = model_io::modelText(built.model, options.out);
  if (!text) return tl::unexpected(text.error());
  return written(options.out, *text,
                 {options.json ? asJson(options, results) : summary(options, results), made->warnings()}, options.json);
}

}  // namespace tactus::cli
