// The text that replaces a model whose experts all withdrew. Private to core/model_io.
#pragma once

#include <string_view>

namespace tactus::model_io {

/// The key of the sentence that says so.
inline constexpr std::string_view kRemovedKey = "removed";

/// `{"format": "tactus-force-model", "version": 1, "removed": …}`, without any content of the model.
constexpr std::string_view removedModelText() {
  return "{\n"
         "  \"format\": \"tactus-force-model\",\n"
         "  \"version\": 1,\n"
         "  \"removed\": \"The experts of this model withdrew, so nothing of it is left.\"\n"
         "}\n";
}

}  // namespace tactus::model_io
