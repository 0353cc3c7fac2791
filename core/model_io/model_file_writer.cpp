#include "core/base/json/json_writer.h"
#include "core/model_io/model_file.h"

namespace tactus::model_io {
namespace {

using base::JsonWriter;
using Layout = base::JsonWriter::Layout;

void append(JsonWriter& json, const std::vector<fuzzy::NamedJson>& members) {
  for (const auto& member : members) json.key(member.key).raw(member.json);
}

void append(JsonWriter& json, const fuzzy::Provenance& provenance) {
  json.beginObject().key("study").value(provenance.study);
  json.key("settings").beginObject();
  append(json, provenance.settings);
  json.endObject().key("sources").beginObject();
  append(json, provenance.sources);
  json.endObject().key("notes").value(provenance.notes).endObject();
}

void append(JsonWriter& json, const std::vector<fuzzy::Term>& terms) {
  json.beginArray();
  for (const auto& term : terms) {
    json.beginObject(Layout::kInline).key("id").value(term.id).key("label").value(term.label);
    json.key("shape").value(name(term.shape)).key("points").values(term.points).endObject();
  }
  json.endArray();
}

void append(JsonWriter& json, const fuzzy::Variable& variable) {
  json.beginObject().key("id").value(variable.id).key("label").value(variable.label).key("unit").value(variable.unit);
  json.key("min").value(variable.min).key("max").value(variable.max);
  if (variable.role != fuzzy::Role::kUnsaid) json.key("role").value(name(variable.role));
  append(json.key("terms"), variable.terms);
  json.endObject();
}

void append(JsonWriter& json, const fuzzy::Rule& rule) {
  json.beginObject(Layout::kInline).key("if").beginObject();
  for (const auto& condition : rule.conditions) json.key(condition.input).value(condition.term);
  json.endObject().key("then").value(rule.then).key("weight").value(rule.weight);
  json.key("enabled").value(rule.enabled).endObject();
}

void append(JsonWriter& json, const fuzzy::Expert& expert) {
  json.beginObject().key("id").value(expert.id).key("label").value(expert.label).key("weight").value(expert.weight);
  if (!expert.overrides.empty()) {
    json.key("terms").beginObject();
    for (const auto& own : expert.overrides) append(json.key(own.variable), own.terms);
    json.endObject();
  }
  json.key("rules").beginArray();
  for (const auto& rule : expert.rules) append(json, rule);
  json.endArray().endObject();
}

void append(JsonWriter& json, const fuzzy::RendererParameters& renderer) {
  json.beginObject().key("version").value(renderer.version);
  for (const auto& field : fuzzy::kRendererFields) json.key(field.key).value(renderer.*field.member);
  json.endObject();
}

void append(JsonWriter& json, const fuzzy::Check& check) {
  json.beginObject(Layout::kInline).key("in").values(check.in).key("force").value(check.force);
  json.key("fired").value(check.fired).endObject();
}

void append(JsonWriter& json, const fuzzy::Contract& contract) {
  const auto has = fuzzy::membersOf(contract.kind);
  json.beginObject(Layout::kInline).key("id").value(contract.id).key("kind").value(name(contract.kind));
  if (has.input) json.key("input").value(contract.input);
  if (has.words) json.key("word").value(contract.word).key("than").value(contract.than);
  if (has.limit) json.key("limit").value(contract.limit);
  if (has.within) json.key("limit_in_jnd").value(contract.limit_in_jnd).key("within").value(contract.within);
  if (!contract.where.empty()) {
    json.key("where").beginObject();
    for (const auto& condition : contract.where) json.key(condition.input).value(condition.term);
    json.endObject();
  }
  json.endObject();
}

}  // namespace

std::string formatModel(const fuzzy::ForceModel& model) {
  JsonWriter json;
  json.beginObject().key("format").value("tactus-force-model").key("version").value(1);
  json.key("name").value(model.name).key("created_utc").value(model.created_utc);
  json.key("generator").value(model.generator);
  if (model.provenance) append(json.key("provenance"), *model.provenance);
  json.key("inputs").beginArray();
  for (const auto& input : model.inputs) append(json, input);
  json.endArray();
  append(json.key("output"), model.output);
  json.key("inference").beginObject(Layout::kInline).key("conjunction").value("min");
  json.key("implication").value(name(model.implication)).key("aggregation").value("max");
  json.key("defuzzification").value("centroid").endObject();
  if (model.default_force_n != 0) json.key("default_force_n").value(model.default_force_n);
  if (!model.accepted_holes.empty()) json.key("accepted_holes").values(model.accepted_holes);
  json.key("experts").beginArray();
  for (const auto& expert : model.experts) append(json, expert);
  json.endArray();
  if (model.renderer) append(json.key("renderer"), *model.renderer);
  if (!model.checks.empty()) {
    json.key("checks").beginArray();
    for (const auto& check : model.checks) append(json, check);
    json.endArray();
  }
  if (!model.contracts.empty()) {
    json.key("contracts").beginArray();
    for (const auto& contract : model.contracts) append(json, contract);
    json.endArray();
  }
  if (!model.events.empty()) {
    json.key("events").beginArray();
    for (const auto& event : model.events)
      json.beginObject(Layout::kInline).key("term").value(event.term).key("share").value(event.share).endObject();
    json.endArray();
  }
  append(json, model.extra);
  json.endObject();
  return json.text();
}

}  // namespace tactus::model_io
