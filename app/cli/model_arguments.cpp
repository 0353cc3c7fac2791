#include "app/cli/model_arguments.h"

#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {

namespace {

base::Result<OpenedModel> compiledOf(base::Result<model_io::ReadModel> read, const std::string& path) {
  if (!read) return tl::unexpected(std::move(read.error()));
  auto compiled = fuzzy::compile(read->model);
  if (!compiled) return base::inFile(std::move(compiled.error()), path);
  return OpenedModel{std::move(read->model), std::move(*compiled), std::move(read->warnings)};
}

}  // namespace

base::Result<OpenedModel> openedModel(const std::string& path) { return compiledOf(model_io::readModel(path), path); }

base::Result<OpenedModel> openedModel(std::string_view text, const std::string& path) {
  return compiledOf(model_io::parseModel(text, path), path);
}

using base::ErrorCode;

base::Result<std::optional<std::size_t>> expertOption(const fuzzy::ForceModel& model, const std::string& path,
                                                      const std::string& id) {
  if (id.empty()) return std::nullopt;
  std::string known;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].id == id) return e;
    if (known.size() < 200) known += (known.empty() ? "" : ", ") + model.experts[e].id;
  }
  return tl::unexpected(base::Error{ErrorCode::kReference, path, "--expert", base::quoted(id), "one of " + known});
}

base::Result<std::pair<std::size_t, double>> inputOption(const fuzzy::ForceModel& model, const std::string& option,
                                                         const std::string& text) {
  const auto equals = text.find('=');
  const auto value = equals == std::string::npos ? std::nullopt : base::parseNumber(text.substr(equals + 1));
  if (!value) return base::fail(ErrorCode::kValue, option, base::quoted(text), "INPUT=VALUE, such as lubrication=1");
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == text.substr(0, equals)) return std::pair{i, *value};
    ids.push_back(model.inputs[i].id);
  }
  return base::fail(ErrorCode::kReference, option, base::quoted(text.substr(0, equals)),
                    "an input of the model: " + base::joined(ids, ", "));
}

base::Result<std::vector<double>> pointOption(const fuzzy::ForceModel& model, const std::string& option,
                                              const std::vector<std::string>& texts) {
  std::vector<std::optional<double>> values(model.inputs.size());
  std::string before;  // the input of the entry before
  for (const std::string& text : texts) {
    if (!before.empty() && base::parseNumber(text)) {  // the rest of a number with a decimal comma
      return base::fail(
          ErrorCode::kValue, option, base::quoted(text) + " after a comma",
          "INPUT=VALUE; a comma separates entries and the decimal sign is a point, as in " + before + "=0.5");
    }
    TACTUS_TRY(const auto one, inputOption(model, option, text));
    before = model.inputs[one.first].id;
    auto& value = values[one.first];
    if (value) return base::fail(ErrorCode::kValue, option, "a second " + before, "each input once");
    value = one.second;
  }
  std::vector<std::string> missing;
  std::vector<double> point;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) missing.push_back(model.inputs[i].id);
    point.push_back(values[i].value_or(0));
  }
  if (missing.empty()) return point;
  return base::fail(ErrorCode::kValue, option, "no value for " + base::joined(missing, ", "),
                    "INPUT=VALUE for each input of the model, separated by commas");
}

base::Result<std::size_t> variableOption(const fuzzy::ForceModel& model, const std::string& option,
                                         const std::string& id) {
  std::vector<std::string> ids;
  for (std::size_t v = 0; v <= model.inputs.size(); ++v) {
    ids.push_back(v < model.inputs.size() ? model.inputs[v].id : model.output.id);
    if (ids.back() == id) return v;
  }
  return base::fail(ErrorCode::kReference, option, base::quoted(id),
                    "a variable of the model: " + base::joined(ids, ", "));
}

}  // namespace tactus::cli
