#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/expert_removal.h"
#include "core/model_io/model_file.h"

namespace tactus::model_io {
namespace {

// Repeats the reference evaluations stored in a model.

// Room for rounding of another implementation, far below anything a hand can feel.
constexpr double kTolerance = 1e-12;

std::string outcome(double force, bool fired) {
  return "force " + base::formatNumber(force) + (fired ? ", fired" : ", not fired");
}

/// Evaluates each of `model.checks`. Returns an error of kind kMismatch at `/checks/N` if a force differs by more than
/// 1e-12 of the output range, or `fired` differs. Returns the error of `fuzzy::validate` if the model is invalid.
base::Result<void> verifyChecks(const fuzzy::ForceModel& model) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  const double most = kTolerance * (model.output.max - model.output.min);
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const fuzzy::Check& check = model.checks[i];
    const auto now = compiled.evaluate(check.in);
    if (now.fired == check.fired && std::abs(now.force_n - check.force) <= most) continue;
    return base::fail(base::ErrorCode::kMismatch, "/checks/" + std::to_string(i), outcome(now.force_n, now.fired),
                      outcome(check.force, check.fired) + ", as the file says");
  }
  return {};
}

using namespace std::string_view_literals;

using base::Error;
using base::ErrorCode;
using base::JsonDocument;
using base::JsonKey;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using fuzzy::ForceModel;

// More would be one mistake repeated.
constexpr std::size_t kMostWarnings = 100;

/// Turns a document into a model. The first error is kept, what is read after it does not matter.
class ModelReader {
 public:
  explicit ModelReader(const std::string& file) : file_(file) {}

  base::Result<ReadModel> read(JsonValue root) {
    JsonMembers members(root, error_);
    members.format("tactus-force-model");
    members.version(required("version"));
    // Without an expert there is nothing to evaluate; what withdrew is not guessed at.
    if (!error_ && members.has(kRemovedKey) && !members.has("experts")) {
      error_ = Error{ErrorCode::kData,
                     {},
                     {},
                     "a model whose experts withdrew, so that nothing of it is left",
                     "a model with one expert or more"};
    }
    readModel(members);
    if (error_) return base::inFile(std::move(*error_), file_);
    if (warnings_ > kMostWarnings) {
      result_.warnings.push_back(file_ + ": " + std::to_string(warnings_ - kMostWarnings) +
                                 " more unknown keys dropped");
    }
    return std::move(result_);
  }

 private:
  void readModel(JsonMembers& members) {
    ForceModel& model = result_.model;
    members.textOrEmpty(required("name"), model.name);
    members.textOrEmpty("created_utc", model.created_utc);
    members.textOrEmpty("generator", model.generator);
    if (const auto value = members.object("provenance")) model.provenance = provenance(*value);
    for (const JsonValue value : members.elements(required("inputs"))) model.inputs.push_back(variable(value));
    if (const auto value = members.object(required("output"))) model.output = variable(*value);
    if (const auto value = members.object(required("inference"))) model.implication = inference(*value);
    members.number("default_force_n", model.default_force_n);
    members.texts("accepted_holes", model.accepted_holes);
    for (const JsonValue value : members.elements(required("experts"))) model.experts.push_back(expert(value));
    if (const auto value = members.object("renderer")) model.renderer = renderer(*value);
    for (const JsonValue value : members.elements("checks")) model.checks.push_back(check(value));
    for (const JsonValue value : members.elements("contracts")) model.contracts.push_back(contract(value));
    for (const JsonValue value : members.elements("events")) model.events.push_back(event(value));
    model.extra = named(members.others());
  }

  fuzzy::Provenance provenance(JsonValue object) {
    fuzzy::Provenance out;
    JsonMembers members(object, error_);
    members.textOrEmpty("study", out.study);
    if (const auto settings = members.object("settings")) out.settings = named(*settings);
    if (const auto sources = members.object("sources")) out.sources = named(*sources);
    members.textOrEmpty("notes", out.notes);
    warnOfOthers(members);
    return out;
  }

  fuzzy::Variable variable(JsonValue object) {
    fuzzy::Variable out;
    JsonMembers members(object, error_);
    idAndLabel(members, out);
    members.textOrEmpty(required("unit"), out.unit);
    members.number(required("min"), out.min);
    members.number(required("max"), out.max);
    if (members.has("role")) out.role = oneOf(members, "role", fuzzy::kRoles);
    out.terms = terms(members, required("terms"));
    warnOfOthers(members);
    return out;
  }

  /// Without a label people read the id.
  template <class Named>
  static void idAndLabel(JsonMembers& members, Named& out) {
    members.textOrEmpty(required("id"), out.id);
    out.label = out.id;
    members.textOrEmpty("label", out.label);
  }

  std::vector<fuzzy::Term> terms(JsonMembers& members, JsonKey key) {
    std::vector<fuzzy::Term> out;
    for (const JsonValue value : members.elements(key)) out.push_back(term(value));
    return out;
  }

  fuzzy::Term term(JsonValue object) {
    fuzzy::Term out;
    JsonMembers members(object, error_);
    idAndLabel(members, out);
    out.shape = oneOf(members, "shape", fuzzy::kShapes);
    members.numbers(required("points"), out.points);
    warnOfOthers(members);
    return out;
  }

  fuzzy::Implication inference(JsonValue object) {
    using fuzzy::Implication;
    JsonMembers members(object, error_);
    members.word(required("conjunction"), std::array{"min"sv});
    const auto implication = oneOf(members, "implication", {Implication::kClip, Implication::kScale});
    members.word(required("aggregation"), std::array{"max"sv});
    members.word(required("defuzzification"), std::array{"centroid"sv});
    warnOfOthers(members);
    return implication;
  }

  fuzzy::Expert expert(JsonValue object) {
    fuzzy::Expert out;
    JsonMembers members(object, error_);
    idAndLabel(members, out);
    members.number(required("weight"), out.weight);
    if (const auto lists = members.object("terms")) {
      JsonMembers own(*lists, error_);
      for (const JsonValue list : *lists) out.overrides.push_back({std::string(list.key()), terms(own, list.key())});
    }
    for (const JsonValue value : members.elements(required("rules"))) out.rules.push_back(rule(value));
    warnOfOthers(members);
    return out;
  }

  fuzzy::Rule rule(JsonValue object) {
    fuzzy::Rule out;
    JsonMembers members(object, error_);
    std::vector<JsonMembers::NamedText> conditions;
    members.texts(required("if"), conditions);
    for (auto& [input, term] : conditions) out.conditions.push_back({std::move(input), std::move(term)});
    members.textOrEmpty(required("then"), out.then);
    members.number("weight", out.weight);
    members.flag("enabled", out.enabled);
    warnOfOthers(members);
    return out;
  }

  fuzzy::RendererParameters renderer(JsonValue object) {
    fuzzy::RendererParameters out;
    JsonMembers members(object, error_);
    members.version("version");
    for (const auto& field : fuzzy::kRendererFields) members.number(field.key, out.*field.member);
    warnOfOthers(members);
    return out;
  }

  fuzzy::Check check(JsonValue object) {
    fuzzy::Check out;
    JsonMembers members(object, error_);
    members.numbers(required("in"), out.in);
    members.number(required("force"), out.force);
    members.flag(required("fired"), out.fired);
    warnOfOthers(members);
    return out;
  }

  fuzzy::Contract contract(JsonValue object) {
    fuzzy::Contract out;
    JsonMembers members(object, error_);
    members.textOrEmpty(required("id"), out.id);
    out.kind = oneOf(members, "kind", fuzzy::kContractKinds);
    const auto has = fuzzy::membersOf(out.kind);
    if (has.input) members.textOrEmpty(required("input"), out.input);
    if (has.words) {
      members.textOrEmpty(required("word"), out.word);
      members.textOrEmpty(required("than"), out.than);
    }
    if (has.limit) members.number(required("limit"), out.limit);
    if (has.within) {
      members.flag("limit_in_jnd", out.limit_in_jnd);
      members.number(required("within"), out.within);
    }
    std::vector<JsonMembers::NamedText> where;
    members.texts("where", where);
    for (auto& [input, term] : where) out.where.push_back({std::move(input), std::move(term)});
    warnOfOthers(members);
    return out;
  }

  fuzzy::TubeEvent event(JsonValue object) {
    fuzzy::TubeEvent out;
    JsonMembers members(object, error_);
    members.textOrEmpty(required("term"), out.term);
    members.number(required("share"), out.share);
    warnOfOthers(members);
    return out;
  }

  template <class Values>
  static std::vector<fuzzy::NamedJson> named(const Values& values) {
    std::vector<fuzzy::NamedJson> out;
    for (const JsonValue value : values) out.push_back({std::string(value.key()), value.json()});
    return out;
  }

  /// The one of `all` whose name stands under `key`.
  template <class Enum, std::size_t count>
  static Enum oneOf(JsonMembers& members, std::string_view key, const Enum (&all)[count]) {
    std::array<std::string_view, count> names;
    std::transform(std::begin(all), std::end(all), names.begin(), [](Enum one) { return name(one); });
    return all[members.word(required(key), names).value_or(0)];
  }

  void warnOfOthers(const JsonMembers& members) {
    for (const JsonValue value : members.others()) {
      if (warnings_++ < kMostWarnings) {
        result_.warnings.push_back(base::oneLine(file_ + ": " + value.pointer() + ": unknown key, dropped"));
      }
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
  TACTUS_TRY(const auto text, base::readFile(path, kMostModelFileBytes));
  return parseModel(text, path);
}

}  // namespace tactus::model_io
