// Models of the C interface: reading them, and what they declare.
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/model_io/model_file.h"
#include "core/runtime/handles.h"
#include "core/runtime/message.h"

namespace tactus::runtime {
namespace {

/// The model in `text`, and a warning of its reader if there is one. `file`: its name in errors.
tactus_status load(std::string_view text, const std::string& file, tactus_model** model, Message& message) {
  auto read = model_io::parseModel(text, file);
  if (!read) return message.fail(TACTUS_BAD_FILE, read.error().message());
  auto compiled = fuzzy::compile(read->model);
  if (!compiled) return message.fail(TACTUS_BAD_FILE, compiled.error().message());
  const auto loaded = std::make_shared<LoadedModel>();
  loaded->compiled = std::move(*compiled);
  loaded->name = std::move(read->model.name);
  loaded->sha256 = base::sha256(text);
  loaded->inputs = std::move(read->model.inputs);
  loaded->output = std::move(read->model.output);
  loaded->output.terms.clear();
  loaded->experts = std::move(read->model.experts);
  for (fuzzy::Expert& expert : loaded->experts) expert.rules = {};
  loaded->events = std::move(read->model.events);
  loaded->renderer = read->model.renderer.value_or(fuzzy::RendererParameters{});
  *model = new tactus_model{loaded};
  if (!read->warnings.empty()) message.say(read->warnings.front());
  return TACTUS_OK;
}

const LoadedModel* of(const tactus_model* model) noexcept { return model != nullptr ? model->loaded.get() : nullptr; }

const fuzzy::Variable* inputOf(const tactus_model* model, std::size_t input) noexcept {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr && input < loaded->inputs.size() ? &loaded->inputs[input] : nullptr;
}

const fuzzy::Expert* expertOf(const tactus_model* model, std::size_t expert) noexcept {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr && expert < loaded->experts.size() ? &loaded->experts[expert] : nullptr;
}

const fuzzy::Term* termOf(const tactus_model* model, std::size_t input, std::size_t term) noexcept {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr && term < variable->terms.size() ? &variable->terms[term] : nullptr;
}

const char* labelOf(const std::string& label, const std::string& id) noexcept {
  return label.empty() ? id.c_str() : label.c_str();
}

}  // namespace
}  // namespace tactus::runtime

using namespace tactus;  // NOLINT(google-build-using-namespace): the functions below are outside all namespaces
using namespace tactus::runtime;  // NOLINT(google-build-using-namespace)

const char* tactus_version(void) { return TACTUS_VERSION; }

int tactus_interface(void) { return TACTUS_INTERFACE; }

tactus_status tactus_model_open(const char* path, tactus_model** model, char* message, size_t message_size) {
  Message said(message, message_size);
  if (model == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "model: found a null pointer, wanted a place for the model");
  *model = nullptr;
  if (path == nullptr) return said.fail(TACTUS_BAD_ARGUMENT, "path: found a null pointer, wanted the name of a file");
  return guarded(said, [&] {
    const auto text = base::readFile(path, model_io::kMostModelFileBytes);
    return text ? load(*text, path, model, said) : said.fail(TACTUS_BAD_FILE, text.error().message());
  });
}

tactus_status tactus_model_read(const void* text, size_t size, tactus_model** model, char* message,
                                size_t message_size) {
  Message said(message, message_size);
  if (model == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "model: found a null pointer, wanted a place for the model");
  *model = nullptr;
  if (text == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "text: found a null pointer, wanted the text of a model file");
  return guarded(said, [&] { return load({static_cast<const char*>(text), size}, "model", model, said); });
}

void tactus_model_free(tactus_model* model) { delete model; }

const char* tactus_model_name(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->name.c_str() : nullptr;
}

const char* tactus_model_sha256(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->sha256.c_str() : nullptr;
}

size_t tactus_model_inputs(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->inputs.size() : 0;
}

const char* tactus_model_input_id(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->id.c_str() : nullptr;
}

const char* tactus_model_input_label(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? labelOf(variable->label, variable->id) : nullptr;
}

const char* tactus_model_input_unit(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->unit.c_str() : nullptr;
}

double tactus_model_input_min(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->min : 0;
}

double tactus_model_input_max(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->max : 0;
}

const char* tactus_model_input_role(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? fuzzy::name(fuzzy::roleOf(*variable)).data() : nullptr;
}

size_t tactus_model_input_terms(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->terms.size() : 0;
}

const char* tactus_model_term_id(const tactus_model* model, size_t input, size_t term) {
  const fuzzy::Term* const found = termOf(model, input, term);
  return found != nullptr ? found->id.c_str() : nullptr;
}

const char* tactus_model_term_label(const tactus_model* model, size_t input, size_t term) {
  const fuzzy::Term* const found = termOf(model, input, term);
  return found != nullptr ? labelOf(found->label, found->id) : nullptr;
}

double tactus_model_membership(const tactus_model* model, size_t expert, size_t input, size_t term, double x) {
  const fuzzy::Expert* const of_expert = expertOf(model, expert);
  const fuzzy::Term* const shared = termOf(model, input, term);
  if (of_expert == nullptr || shared == nullptr) return 0;
  if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
  const fuzzy::Term* const own = fuzzy::findTerm(fuzzy::termsFor(*of_expert, *inputOf(model, input)), shared->id);
  return own != nullptr ? fuzzy::MembershipFunction::of(*own)(of(model)->compiled.clampInput(input, x)) : 0;
}

double tactus_model_output_min(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->output.min : 0;
}

double tactus_model_output_max(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->output.max : 0;
}

size_t tactus_model_experts(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->experts.size() : 0;
}

const char* tactus_model_expert_id(const tactus_model* model, size_t expert) {
  const fuzzy::Expert* const found = expertOf(model, expert);
  return found != nullptr ? found->id.c_str() : nullptr;
}

const char* tactus_model_expert_label(const tactus_model* model, size_t expert) {
  const fuzzy::Expert* const found = expertOf(model, expert);
  return found != nullptr ? labelOf(found->label, found->id) : nullptr;
}

double tactus_model_expert_weight(const tactus_model* model, size_t expert) {
  return expertOf(model, expert) != nullptr ? of(model)->compiled.weight(expert) : 0;
}

void tactus_model_renderer(const tactus_model* model, tactus_renderer* renderer) {
  // The struct has the parameters in the order of the model file.
  constexpr std::size_t kFirst = offsetof(tactus_renderer, stiffness_n_mm);
  static_assert(sizeof(tactus_renderer) == kFirst + std::size(fuzzy::kRendererFields) * sizeof(double));
  const LoadedModel* const loaded = of(model);
  if (loaded == nullptr || renderer == nullptr) return;
  std::size_t at = kFirst;
  for (const fuzzy::RendererField& field : fuzzy::kRendererFields) {
    if (renderer->size < at + sizeof(double)) return;
    std::memcpy(reinterpret_cast<char*>(renderer) + at, &(loaded->renderer.*field.member), sizeof(double));
    at += sizeof(double);
  }
}
