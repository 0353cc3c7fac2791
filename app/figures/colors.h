// The colors of the pictures, the same in the report and in the workbench. A color means one thing: the ramp is force,
// regions have quiet colors of their own, terms of the other inputs are gray, and every expert keeps one color.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::figures {

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Example: `#0B659E`.
std::string hex(const Rgb& color);
Rgb mixed(const Rgb& from, const Rgb& to, double share);
/// Contrast of two colors, 1 to 21 (WCAG 2.1).
double contrast(const Rgb& one, const Rgb& other);
/// `color`, as far toward `ink` as its contrast to `card` needs to be `least`.
Rgb readable(const Rgb& color, const Rgb& card, const Rgb& ink, double least);

/// `share` in [0, 1] of the force's universe: from dark blue to amber with rising lightness, so that the order stays
/// visible with every kind of color vision and in a gray print.
Rgb forceRamp(double share);

/// Color of a region by its place in the procedure that has it (of those that the program carries). The parts of a
/// split (`oropharynx_2`) are tints of the whole. Regions with other ids have the colors in their order. Contrast at
/// least 3 to the cards of both looks.
Rgb regionColor(const std::vector<fuzzy::Term>& terms, std::size_t index);

/// Color of term `index` of `variable`: the ramp for a force in N, a region's color for a depth in mm, else gray.
Rgb termColor(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);

/// What the color of each expert follows from: the number at the end of the id less one (3 for `S4`), so that an expert
/// looks the same alone and in the average. The place in the model if an id has no number, or two have the same.
std::vector<std::size_t> expertNumbers(const std::vector<fuzzy::Expert>& experts);

/// Color of the expert with this number, from the set of Okabe and Ito (2008), darkened where it was too light for a
/// line: distinct for every kind of color vision. Repeats after six. Contrast at least 3 to the cards of both looks.
Rgb expertColor(std::size_t number);

}  // namespace tactus::figures
