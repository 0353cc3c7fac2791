// Colors of the plots. They are distinct for every kind of color vision; in gray print the line styles differ.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "app/figures/colors.h"

namespace tactus::report {

// Okabe and Ito 2008, without the yellow, which is invisible on white.
inline constexpr std::string_view kBlue = "#0072B2";
inline constexpr std::string_view kOrange = "#E69F00";
inline constexpr std::string_view kGreen = "#009E73";
inline constexpr std::string_view kVermilion = "#D55E00";
inline constexpr std::string_view kPurple = "#CC79A7";
inline constexpr std::string_view kSky = "#56B4E9";
inline constexpr std::string_view kInk = "#1B1F24";    ///< text, the averaged model
inline constexpr std::string_view kMuted = "#57606A";  ///< axes, secondary text
inline constexpr std::string_view kGrid = "#E3E7EB";

/// Colors that differ; the next one is the first again.
inline constexpr std::size_t kSeriesColors = 6;

/// Color of one expert, the same in every plot and in the workbench.
std::string_view seriesColor(std::size_t index);

/// Color of a force at `share` in [0, 1] of its axis. `light` scales the brightness.
std::string scaleColor(double share, double light = 1);

/// `color` for text on white.
std::string readableText(const figures::Rgb& color);

}  // namespace tactus::report
