// Models of the C interface: reading them, and what they declare.
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/model_io/model_file.h"
#include "core/runtime/handles.h"
#include "core/runtime/message.h"

namespace tactus::runtime {
namespace {

fuzzy::Variable withoutTerms(fuzzy::Variable variable) {
  variable.terms.clear();
  return variable;
}

/// The model that was read, and a warning of its reader if there is one.
tactus_status load(base::Result<model_io::ReadModel> read, tactus_model** model, Message& message) {
  if (!read) return message.fail(TACTUS_BAD_FILE, read.error().message());
  auto compiled = fuzzy::compile(read->model);
  if (!compiled) return message.fail(TACTUS_BAD_FILE, compiled.error().message());
  const auto loaded = std::make_shared<LoadedModel>();
  loaded->compiled = std::move(*compiled);
  loaded->name = std::move(read->model.name);
  for (fuzzy::Variable& input : read->model.inputs) loaded->inputs.push_back(withoutTerms(std::move(input)));
  loaded->output = withoutTerms(std::move(read->model.output));
  for (fuzzy::Expert& expert : read->model.experts) loaded->experts.push_back(std::move(expert.id));
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
  return guarded(said, [&] { return load(model_io::readModel(path), model, said); });
}

tactus_status tactus_model_read(const void* text, size_t size, tactus_model** model, char* message,
                                size_t message_size) {
  Message said(message, message_size);
  if (model == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "model: found a null pointer, wanted a place for the model");
  *model = nullptr;
  if (text == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "text: found a null pointer, wanted the text of a model file");
  return guarded(said, [&] {
    const std::string_view bytes(static_cast<const char*>(text), size);
    return load(model_io::parseModel(bytes, "model"), model, said);
  });
}

void tactus_model_free(tactus_model* model) { delete model; }

const char* tactus_model_name(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->name.c_str() : nullptr;
}

size_t tactus_model_inputs(const tactus_model* model) {
  const LoadedModel* const loaded = of(model);
  return loaded != nullptr ? loaded->inputs.size() : 0;
}

const char* tactus_model_input_id(const tactus_model* model, size_t input) {
  const fuzzy::Variable* const variable = inputOf(model, input);
  return variable != nullptr ? variable->id.c_str() : nullptr;
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
  return expert < tactus_model_experts(model) ? of(model)->experts[expert].c_str() : nullptr;
}

double tactus_model_expert_weight(const tactus_model* model, size_t expert) {
  return expert < tactus_model_experts(model) ? of(model)->compiled.weight(expert) : 0;
}
