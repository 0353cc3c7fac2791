// Removes experts from the text of a model file: participants who withdrew.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::model_io {

// The text that replaces a model whose experts all withdrew. Private to core/model_io.

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

struct ExpertRemoval {
  std::string text;  ///< the remaining text
  bool changed = false;
  std::vector<std::string> labels;  ///< labels of the removed experts, without empty ones
};

/// Removes from the text of a model the experts whose id or label contains one of `names` (base::holdsName).
/// Also removes the names elsewhere: in the model's name, labels, provenance and unknown keys. An expert's rules, own
/// terms and weight go with the expert; shared terms stay. The notes of the provenance mention the removal, and the
/// checks are computed again. If all remaining weights are 0, they become 1.
///
/// If no expert remains, or the text contains a name but is not a readable model, the result is a text that says so,
/// and `parseModel` refuses it with that sentence. A text without any of the names stays equal, byte for byte.
///
/// The result depends only on the text and the names, so two stations get the same bytes. Removing names one after the
/// other, in any order, gives the same text as removing all at once.
ExpertRemoval withoutExperts(std::string_view text, std::span<const std::string> names);

/// The ids of the experts in a model's text, in order; none if the text is not JSON.
std::vector<std::string> expertIds(std::string_view text);

}  // namespace tactus::model_io
