#include "core/model_io/expert_removal.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/files/name_removal.h"
#include "core/base/json/json_document.h"
#include "core/base/json/json_writer.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

namespace tactus::model_io {
namespace {

using base::holdsName;
using base::JsonDocument;
using base::JsonKind;
using base::JsonValue;
using base::JsonWriter;
using base::withoutNames;
using Names = std::span<const std::string>;

constexpr std::string_view kNote = "Experts who withdrew were removed from this model.";
// A shorter name may be the id of a term or a unit by chance.
constexpr std::size_t kShortestCertain = 3;

bool isNamed(JsonValue value, Names names) {
  if (holdsName(value.key(), names) || holdsName(value.text(), names)) return true;
  if (value.kind() != JsonKind::kArray && value.kind() != JsonKind::kObject) return false;
  for (const JsonValue child : value) {
    if (isNamed(child, names)) return true;
  }
  return false;
}

/// Writes `value` without members and elements that are about a person.
void appendWithout(JsonWriter& json, JsonValue value, Names names) {
  if (!isNamed(value, names)) {
    json.raw(value.json());
  } else if (value.kind() == JsonKind::kString) {
    json.value(withoutNames(value.text(), names));
  } else if (value.kind() == JsonKind::kObject) {
    json.beginObject(JsonWriter::Layout::kInline);
    for (const JsonValue member : value) {
      if (holdsName(member.key(), names)) continue;
      appendWithout(json.key(member.key()), member, names);
    }
    json.endObject();
  } else if (value.kind() == JsonKind::kArray) {
    json.beginArray(JsonWriter::Layout::kInline);
    for (const JsonValue element : value) {
      const bool is_name = std::find(names.begin(), names.end(), element.text()) != names.end();
      if (element.kind() != JsonKind::kString || !is_name) appendWithout(json, element, names);
    }
    json.endArray();
  } else {
    json.raw(value.json());  // only its key, which the caller has dropped, holds a name
  }
}

void clean(std::vector<fuzzy::NamedJson>& members, Names names) {
  std::erase_if(members, [&](const fuzzy::NamedJson& member) { return holdsName(member.key, names); });
  for (auto& member : members) {
    const auto document = JsonDocument::parse("{\"value\": " + member.json + "}");
    if (!document) continue;  // no value of a model that was read
    const JsonValue value = *document->root().find("value");
    if (!isNamed(value, names)) continue;
    JsonWriter json;
    appendWithout(json, value, names);
    member.json = json.text();
    member.json.pop_back();  // the newline of a whole file
  }
}

void clean(std::vector<fuzzy::Term>& terms, Names names) {
  for (auto& term : terms) term.label = withoutNames(term.label, names);
}

void clean(fuzzy::Variable& variable, Names names) {
  variable.label = withoutNames(variable.label, names);
  clean(variable.terms, names);
}

/// Everything but the experts themselves.
void cleanTexts(fuzzy::ForceModel& model, Names names) {
  model.name = withoutNames(model.name, names);
  model.generator = withoutNames(model.generator, names);
  for (auto& input : model.inputs) clean(input, names);
  clean(model.output, names);
  for (auto& expert : model.experts) {
    for (auto& own : expert.overrides) clean(own.terms, names);
  }
  std::erase_if(model.accepted_holes, [&](const std::string& hole) { return holdsName(hole, names); });
  std::erase_if(model.contracts, [&](const fuzzy::Contract& contract) { return holdsName(contract.id, names); });
  clean(model.extra, names);
  if (!model.provenance) return;
  model.provenance->study = withoutNames(model.provenance->study, names);
  model.provenance->notes = withoutNames(model.provenance->notes, names);
  clean(model.provenance->settings, names);
  clean(model.provenance->sources, names);
}

void addNote(fuzzy::ForceModel& model) {
  if (!model.provenance) model.provenance.emplace();
  std::string& notes = model.provenance->notes;
  if (notes.find(kNote) != std::string::npos) return;
  if (!notes.empty()) notes += ' ';
  notes += kNote;
}

/// A mean needs a weight above 0.
void keepAMean(std::vector<fuzzy::Expert>& experts) {
  const bool has_mean = std::any_of(experts.begin(), experts.end(), [](const auto& one) { return one.weight > 0; });
  if (has_mean) return;
  for (auto& expert : experts) expert.weight = 1;
}

/// The forces that the model gives now, at the same points; none where it cannot be evaluated.
void repeatChecks(fuzzy::ForceModel& model) {
  const auto compiled = fuzzy::compile(model);
  if (!compiled) model.checks.clear();
  for (auto& check : model.checks) {
    const auto now = compiled->evaluate(check.in);
    check.force = now.force_n;
    check.fired = now.fired;
  }
}

ExpertRemoval replaced(std::vector<std::string> labels) {
  return {std::string(removedModelText()), true, std::move(labels)};
}

/// Of a text that is no readable model: whether a name stands in it, in plain or in JSON.
bool namesSomebody(std::string_view text, Names names) {
  if (holdsName(text, names)) return true;
  const auto document = JsonDocument::parse(text);
  return document && isNamed(document->root(), names);
}

}  // namespace

ExpertRemoval withoutExperts(std::string_view text, std::span<const std::string> names) {
  ExpertRemoval out{std::string(text), false, {}};
  auto read = parseModel(text, "model");
  if (!read) return namesSomebody(text, names) ? replaced({}) : out;

  fuzzy::ForceModel model = read->model;
  std::erase_if(model.experts, [&](const fuzzy::Expert& expert) {
    const bool goes = holdsName(expert.id, names) || holdsName(expert.label, names);
    if (goes && !expert.label.empty()) out.labels.push_back(expert.label);
    return goes;
  });
  if (model.experts.empty()) return replaced(std::move(out.labels));
  const bool without_some = model.experts.size() < read->model.experts.size();
  cleanTexts(model, names);
  if (without_some) {
    keepAMean(model.experts);
    repeatChecks(model);
    addNote(model);
  }
  std::vector<std::string> certain;
  std::copy_if(names.begin(), names.end(), std::back_inserter(certain),
               [](const std::string& name) { return name.size() >= kShortestCertain; });
  // A key that the reader dropped may hold a name too, so the text decides.
  if (model == read->model && !namesSomebody(text, certain)) return out;

  out.text = formatModel(model);
  out.changed = true;
  // An id of a term or a variable cannot be taken out by itself.
  if (namesSomebody(out.text, certain) || !parseModel(out.text, "model")) return replaced(std::move(out.labels));
  return out;
}

std::vector<std::string> expertIds(std::string_view text) {
  std::vector<std::string> ids;
  const auto document = JsonDocument::parse(text);
  if (!document) return ids;
  const auto experts = document->root().find("experts");
  if (!experts || experts->kind() != JsonKind::kArray) return ids;
  for (const JsonValue expert : *experts) {
    if (expert.kind() != JsonKind::kObject) continue;
    const auto id = expert.find("id");
    if (id && id->kind() == JsonKind::kString) ids.emplace_back(id->text());
  }
  return ids;
}

}  // namespace tactus::model_io
