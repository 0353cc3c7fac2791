// Takes experts out of the text of a model file: participants who withdrew.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::model_io {

struct ExpertRemoval {
  std::string text;  ///< what is left
  bool changed = false;
  std::vector<std::string> labels;  ///< of the experts that were taken out, where they are not empty
};

/// The text of a model without the experts whose id or label holds one of `names` (base::holdsName), and without the
/// names everywhere else: in the model's name, the labels, the provenance and the keys that are not ours. Rules, own
/// terms and weight go with the expert; terms that all experts share stay. The notes of the provenance say that experts
/// were removed, and the checks are evaluated again. Where all weights that are left are 0, they become 1.
///
/// A model without any expert left, and a text that names one and is no readable model, is replaced by a text that says
/// so and that `parseModel` refuses with that sentence. A text that names nobody stays as it is, byte for byte.
///
/// The outcome follows from the text and the names alone, so two stations clean a model to the same bytes; names taken
/// out one after the other, in any order, leave the same text as all at once.
ExpertRemoval withoutExperts(std::string_view text, std::span<const std::string> names);

/// The ids of the experts in a model's text, in their order; none where the text is no JSON.
std::vector<std::string> expertIds(std::string_view text);

}  // namespace tactus::model_io
