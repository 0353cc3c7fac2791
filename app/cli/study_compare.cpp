// The method study: does a choice of the method matter here?
#include "app/cli/study_build.h"
#include "app/cli/study_commands.h"
#include "app/cli/terminal.h"
#include "app/session/study_source.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/model/method_study.h"

namespace tactus::cli {
namespace {

using elicitation::MethodFactor;
using elicitation::MethodStudy;
using elicitation::MethodVariant;

std::string variantLine(const MethodVariant& one, const fuzzy::ForceModel& model) {
  std::string text = "  " + padded(one.value, 14);
  if (!one.unavailable.empty()) return text + "not possible: " + base::oneLine(one.unavailable) + '\n';
  text += "rms " + base::formatFixed(one.rms_n, 4) + " N (" + base::formatFixed(one.rms_noticeable, 2) +
          " JND), felt at " + base::formatFixed(100 * one.noticeable_share, 1) + " %, largest " +
          base::formatFixed(one.largest_n, 3) + " N";
  if (!one.at.empty()) text += " at " + elicitation::pointText(model, one.at);
  if (one.only_one_share > 0) {
    text += "; at " + base::formatFixed(100 * one.only_one_share, 1) + " % only one of them has a force";
  }
  return text + '\n';
}

std::string compareText(const MethodStudy& study, const fuzzy::ForceModel& model) {
  std::string text;
  std::vector<std::string> matter;
  for (const std::size_t index : elicitation::factorsByEffect(study)) {
    const MethodFactor& factor = study.factors[index];
    text += factor.factor + ", now " + base::oneLine(factor.unchanged) + '\n';
    text += "  " + base::oneLine(elicitation::factorSentence(study, factor)) + '\n';
    for (const MethodVariant& one : study.variants) {
      if (one.factor == factor.factor) text += variantLine(one, model);
    }
    if (factor.matters) matter.push_back(factor.factor);
  }
  text += matter.empty() ? "no choice is felt at more than " : base::joined(matter, ", ") + ": felt at more than ";
  return text + base::formatFixed(100 * elicitation::kMattersShare, 0) + " % of the input space (one just-noticeable " +
         "difference, " + std::to_string(study.points) + " points)\n";
}

std::string compareJson(const StudyCompareOptions& options, const StudyBuild& made, const MethodStudy& study) {
  base::JsonWriter json;
  json.beginObject().key("study").value(options.study).key("points").value(study.points);
  json.key("experts").value(made.built.model.experts.size());
  json.key("matters_share").value(elicitation::kMattersShare).key("factors").beginArray();
  for (const MethodFactor& factor : study.factors) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("factor").value(factor.factor);
    json.key("unchanged").value(factor.unchanged).key("worst");
    factor.worst ? json.value(study.variants[*factor.worst].value) : json.null();
    json.key("matters").value(factor.matters);
    json.key("sentence").value(elicitation::factorSentence(study, factor)).endObject();
  }
  json.endArray().key("variants").beginArray();
  for (const MethodVariant& one : study.variants) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("factor").value(one.factor).key("value").value(one.value);
    json.key("available").value(one.unavailable.empty());
    if (!one.unavailable.empty()) {
      json.key("reason").value(one.unavailable).endObject();
      continue;
    }
    json.key("rms_n").value(one.rms_n).key("rms_jnd").value(one.rms_noticeable);
    json.key("largest_n").value(one.largest_n).key("largest_jnd").value(one.largest_noticeable);
    json.key("at").beginObject(base::JsonWriter::Layout::kInline);
    for (std::size_t k = 0; k < one.at.size(); ++k) json.key(made.built.model.inputs[k].id).value(one.at[k]);
    json.endObject().key("noticeable_share").value(one.noticeable_share);
    json.key("only_one_share").value(one.only_one_share).endObject();
  }
  json.endArray().key("notices").values(made.notices).endObject();
  return json.text();
}

}  // namespace

base::Result<Output> studyCompare(const StudyCompareOptions& options) {
  TACTUS_TRY(const auto made, buildStudy(options));
  const auto forms = session::knownForms(procedure::of(made.tables.study));
  const auto study = elicitation::methodStudy(made.tables.study, forms, made.settings, made.built);
  if (!study) return inFile(study.error(), options.study);
  return Output{options.json ? compareJson(options, made, *study) : compareText(*study, made.built.model),
                made.warnings()};
}

}  // namespace tactus::cli
