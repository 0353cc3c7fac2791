#include "app/cli/model_arguments.h"

#include <vector>

#include "core/base/text.h"

namespace tactus::cli {

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

}  // namespace tactus::cli
