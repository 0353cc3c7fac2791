#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "core/base/files/file.h"
#include "core/base/json/json_document.h"
#include "core/base/text.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"
#include "core/model_io/removed_model.h"
#include "core/model_io/verify_checks.h"

namespace tactus::model_io {
namespace {

using namespace std::string_view_literals;

using base::Error;
using base::ErrorCode;
using base::JsonDocument;
using base::JsonKind;
using base::JsonValue;
using fuzzy::ForceModel;

constexpr std::string_view kFormat = "tactus-force-model";
// More would be one mistake repeated.
constexpr std::size_t kMostWarnings = 100;
constexpr std::array<std::string_view, 14> kTopLevelKeys = {
    "format",    "version",         "name",           "created_utc", "generator", "provenance", "inputs", "output",
    "inference", "default_force_n", "accepted_holes", "experts",     "renderer",  "checks"};

template <class Keys>
bool isAmong(std::string_view key, const Keys& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Turns a document into a model. The first error is kept, what is read after it does not matter.
class ModelReader {
 public:
  explicit ModelReader(const std::string& file) : file_(file) {}

  base::Result<ReadModel> read(JsonValue root) {
    readHeader(root);
    if (!error_) readModel(root);
    if (error_) return base::inFile(std::move(*error_), file_);
    if (warnings_ > kMostWarnings) {
      result_.warnings.push_back(file_ + ": " + std::to_string(warnings_ - kMostWarnings) +
                                 " more unknown keys dropped");
    }
    return std::move(result_);
  }

 private:
  void readHeader(JsonValue root) {
    only(root, "format", std::array{kFormat});
    if (error_) return;
    checkVersion(number(root, "version"), "/version");
    // Without an expert there is nothing to evaluate; what withdrew is not guessed at.
    if (root.find(kRemovedKey) && !root.find("experts")) {
      refuse(ErrorCode::kData, {}, "a model whose experts withdrew, so that nothing of it is left",
             "a model with one expert or more");
    }
  }

  void checkVersion(double version, std::string place) {
    if (version == 1) return;
    const bool newer = version > 1;
    refuse(newer ? ErrorCode::kVersion : ErrorCode::kValue, std::move(place),
           "version " + base::formatNumber(version) + (newer ? ", newer than this program" : ""),
           newer ? "at most version 1" : "version 1");
  }

  void readModel(JsonValue root) {
    ForceModel& model = result_.model;
    model.name = text(root, "name");
    model.created_utc = text(root, "created_utc");
    model.generator = text(root, "generator");
    if (const auto value = optional(root, "provenance", JsonKind::kObject)) model.provenance = provenance(*value);
    if (const auto values = required(root, "inputs", JsonKind::kArray)) {
      for (const JsonValue value : *values) model.inputs.push_back(variable(value));
    }
    if (const auto value = required(root, "output", JsonKind::kObject)) model.output = variable(*value);
    if (const auto value = required(root, "inference", JsonKind::kObject)) model.implication = inference(*value);
    model.default_force_n = number(root, "default_force_n", 0);
    if (const auto values = optional(root, "accepted_holes", JsonKind::kArray)) {
      for (const JsonValue value : *values) {
        if (expect(value, JsonKind::kString)) model.accepted_holes.emplace_back(value.text());
      }
    }
    if (const auto values = required(root, "experts", JsonKind::kArray)) {
      for (const JsonValue value : *values) model.experts.push_back(expert(value));
    }
    if (const auto value = optional(root, "renderer", JsonKind::kObject)) model.renderer = renderer(*value);
    if (const auto values = optional(root, "checks", JsonKind::kArray)) {
      for (const JsonValue value : *values) model.checks.push_back(check(value));
    }
    for (const JsonValue value : root) {
      if (!isAmong(value.key(), kTopLevelKeys)) model.extra.push_back(named(value));
    }
  }

  fuzzy::Provenance provenance(JsonValue object) {
    fuzzy::Provenance out;
    warnUnknown(object, {"study", "settings", "sources", "notes"});
    out.study = text(object, "study");
    out.settings = openObject(object, "settings");
    out.sources = openObject(object, "sources");
    out.notes = text(object, "notes");
    return out;
  }

  fuzzy::Variable variable(JsonValue object) {
    fuzzy::Variable out;
    if (!expect(object, JsonKind::kObject)) return out;
    warnUnknown(object, {"id", "label", "unit", "min", "max", "terms"});
    out.id = text(object, "id");
    out.label = text(object, "label");
    out.unit = text(object, "unit");
    out.min = number(object, "min");
    out.max = number(object, "max");
    if (const auto values = required(object, "terms", JsonKind::kArray)) out.terms = terms(*values);
    return out;
  }

  std::vector<fuzzy::Term> terms(JsonValue array) {
    std::vector<fuzzy::Term> out;
    if (!expect(array, JsonKind::kArray)) return out;
    for (const JsonValue value : array) out.push_back(term(value));
    return out;
  }

  fuzzy::Term term(JsonValue object) {
    using fuzzy::Shape;
    fuzzy::Term out;
    if (!expect(object, JsonKind::kObject)) return out;
    warnUnknown(object, {"id", "label", "shape", "points"});
    out.id = text(object, "id");
    out.label = text(object, "label");
    std::vector<std::string_view> shapes;
    for (const Shape one : fuzzy::kShapes) shapes.push_back(name(one));
    const std::string shape = only(object, "shape", shapes);
    for (const Shape one : fuzzy::kShapes) {
      if (shape == name(one)) out.shape = one;
    }
    out.points = numbers(object, "points");
    return out;
  }

  fuzzy::Implication inference(JsonValue object) {
    using fuzzy::Implication;
    warnUnknown(object, {"conjunction", "implication", "aggregation", "defuzzification"});
    only(object, "conjunction", std::array{"min"sv});
    const std::string implication =
        only(object, "implication", std::array{name(Implication::kClip), name(Implication::kScale)});
    only(object, "aggregation", std::array{"max"sv});
    only(object, "defuzzification", std::array{"centroid"sv});
    return implication == name(Implication::kScale) ? Implication::kScale : Implication::kClip;
  }

  fuzzy::Expert expert(JsonValue object) {
    fuzzy::Expert out;
    if (!expect(object, JsonKind::kObject)) return out;
    warnUnknown(object, {"id", "label", "weight", "terms", "rules"});
    out.id = text(object, "id");
    out.label = text(object, "label");
    out.weight = number(object, "weight");
    if (const auto lists = optional(object, "terms", JsonKind::kObject)) {
      for (const JsonValue list : *lists) out.overrides.push_back({std::string(list.key()), terms(list)});
    }
    if (const auto values = required(object, "rules", JsonKind::kArray)) {
      for (const JsonValue value : *values) out.rules.push_back(rule(value));
    }
    return out;
  }

  fuzzy::Rule rule(JsonValue object) {
    fuzzy::Rule out;
    if (!expect(object, JsonKind::kObject)) return out;
    warnUnknown(object, {"if", "then", "weight", "enabled"});
    if (const auto conditions = required(object, "if", JsonKind::kObject)) {
      for (const JsonValue term : *conditions) {
        if (expect(term, JsonKind::kString))
          out.conditions.push_back({std::string(term.key()), std::string(term.text())});
      }
    }
    out.then = text(object, "then");
    out.weight = number(object, "weight", 1);
    if (const auto value = object.find("enabled")) out.enabled = flag(*value);
    return out;
  }

  fuzzy::RendererParameters renderer(JsonValue object) {
    fuzzy::RendererParameters out;
    checkVersion(number(object, "version", out.version), "/renderer/version");
    for (const auto& field : fuzzy::kRendererFields) out.*field.member = number(object, field.key, out.*field.member);
    for (const JsonValue value : object) {
      const bool known =
          value.key() == "version" || std::any_of(std::begin(fuzzy::kRendererFields), std::end(fuzzy::kRendererFields),
                                                  [&value](const auto& field) { return value.key() == field.key; });
      if (!known) warn(value);
    }
    return out;
  }

  fuzzy::Check check(JsonValue object) {
    fuzzy::Check out;
    if (!expect(object, JsonKind::kObject)) return out;
    warnUnknown(object, {"in", "force", "fired"});
    out.in = numbers(object, "in");
    out.force = number(object, "force");
    if (const auto value = member(object, "fired", "true or false")) out.fired = flag(*value);
    return out;
  }

  static fuzzy::NamedJson named(JsonValue value) { return {std::string(value.key()), value.json()}; }

  std::vector<fuzzy::NamedJson> openObject(JsonValue object, std::string_view key) {
    std::vector<fuzzy::NamedJson> out;
    if (const auto values = required(object, key, JsonKind::kObject)) {
      for (const JsonValue value : *values) out.push_back(named(value));
    }
    return out;
  }

  std::string text(JsonValue object, std::string_view key) {
    const auto value = required(object, key, JsonKind::kString);
    return value ? std::string(value->text()) : std::string();
  }

  double number(JsonValue object, std::string_view key) {
    const auto value = required(object, key, JsonKind::kNumber);
    return value ? value->number() : 0;
  }

  double number(JsonValue object, std::string_view key, double otherwise) {
    const auto value = optional(object, key, JsonKind::kNumber);
    return value ? value->number() : otherwise;
  }

  std::vector<double> numbers(JsonValue object, std::string_view key) {
    std::vector<double> out;
    if (const auto values = required(object, key, JsonKind::kArray)) {
      for (const JsonValue value : *values) {
        if (expect(value, JsonKind::kNumber)) out.push_back(value.number());
      }
    }
    return out;
  }

  bool flag(JsonValue value) {
    if (value.kind() == JsonKind::kTrue) return true;
    if (value.kind() != JsonKind::kFalse) refuse(ErrorCode::kSchema, value, "true or false");
    return false;
  }

  /// The string under `key`, which must be one of `known`.
  std::string only(JsonValue object, std::string_view key, std::span<const std::string_view> known) {
    std::string wanted;
    for (const auto word : known) {
      if (!wanted.empty()) wanted += word == known.back() ? " or " : ", ";
      wanted += base::quoted(word);
    }
    const auto value = member(object, key, wanted);
    if (!value) return {};
    if (value->kind() != JsonKind::kString || !isAmong(value->text(), known)) {
      refuse(value->kind() == JsonKind::kString ? ErrorCode::kValue : ErrorCode::kSchema, *value, wanted);
    }
    return std::string(value->text());
  }

  static std::string_view wanted(JsonKind kind) {
    switch (kind) {
      case JsonKind::kNumber:
        return "a number";
      case JsonKind::kString:
        return "a string";
      case JsonKind::kArray:
        return "an array";
      default:
        return "an object";
    }
  }

  bool expect(JsonValue value, JsonKind kind) {
    if (value.kind() == kind) return true;
    refuse(ErrorCode::kSchema, value, std::string(wanted(kind)));
    return false;
  }

  /// The value under `key`, which must be there.
  std::optional<JsonValue> member(JsonValue object, std::string_view key, std::string_view wanted_value) {
    const auto value = object.find(key);
    if (!value && !error_) {
      refuse(ErrorCode::kSchema, object.pointer(), "no key " + base::quoted(key),
             "a key " + base::quoted(key) + " with " + std::string(wanted_value));
    }
    return value;
  }

  std::optional<JsonValue> required(JsonValue object, std::string_view key, JsonKind kind) {
    const auto value = member(object, key, wanted(kind));
    return value && expect(*value, kind) ? value : std::nullopt;
  }

  std::optional<JsonValue> optional(JsonValue object, std::string_view key, JsonKind kind) {
    const auto value = object.find(key);
    return value && expect(*value, kind) ? value : std::nullopt;
  }

  void refuse(ErrorCode code, std::string place, std::string found, std::string wanted_value) {
    if (!error_) error_ = Error{code, {}, std::move(place), std::move(found), std::move(wanted_value)};
  }

  void refuse(ErrorCode code, JsonValue value, std::string wanted_value) {
    if (!error_) refuse(code, value.pointer(), value.description(), std::move(wanted_value));
  }

  void warnUnknown(JsonValue object, std::initializer_list<std::string_view> known) {
    for (const JsonValue value : object) {
      if (!isAmong(value.key(), known)) warn(value);
    }
  }

  void warn(JsonValue value) {
    if (warnings_++ < kMostWarnings) {
      result_.warnings.push_back(base::oneLine(file_ + ": " + value.pointer() + ": unknown key, dropped"));
    }
  }

  const std::string& file_;
  ReadModel result_;
  std::optional<Error> error_;
  std::size_t warnings_ = 0;
};

}  // namespace

base::Result<ReadModel> parseModel(std::string_view text, const std::string& file) {
  if (text.size() > kMostModelFileBytes) {
    return base::inFile({ErrorCode::kLimit,
                         {},
                         {},
                         std::to_string(text.size()) + " bytes",
                         "at most " + std::to_string(kMostModelFileBytes) + " bytes"},
                        file);
  }
  const auto document = JsonDocument::parse(text);
  if (!document) return base::inFile(document.error(), file);
  auto read = ModelReader(file).read(document->root());
  if (!read) return read;
  if (const auto ok = fuzzy::validate(read->model); !ok) return base::inFile(ok.error(), file);
  if (read->model.checks.empty()) return read;
  if (const auto ok = verifyChecks(read->model); !ok) return base::inFile(ok.error(), file);
  return read;
}

base::Result<ReadModel> readModel(const std::string& path) {
  const auto text = base::readFile(path, kMostModelFileBytes);
  if (!text) return tl::unexpected(text.error());
  return parseModel(*text, path);
}

}  // namespace tactus::model_io
