// The text that stands where a model was removed, because its experts withdrew. Private to core/model_io.
#pragma once

#include <string_view>

namespace tactus::model_io {

/// The key of the text that says so.
inline constexpr std::string_view kRemovedKey = "removed";

/// `{"format": "tactus-force-model", "version": 1, "removed": …}`, which holds nothing of the model.
constexpr std::string_view removedModelText() {
  return "{\n"
         "  \"format\": \"tactus-force-model\",\n"
         "  \"version\": 1,\n"
         "  \"removed\": \"The experts of this model withdrew, so nothing of it is left.\"\n"
         "}\n";
}

}  // namespace tactus::model_io
