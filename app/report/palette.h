// Colors of the plots. They are distinct for every kind of color vision; in gray print the line styles differ.
#pragma once

#include <array>
#include <string>
#include <string_view>

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

/// Colors of the experts, repeated after the last one; the workbench uses the same.
inline constexpr std::array<std::string_view, 6> kSeriesColors = {kBlue, kVermilion, kGreen, kPurple, kOrange, kSky};

/// Color of one expert, the same in every plot.
inline std::string_view seriesColor(std::size_t index) { return kSeriesColors[index % kSeriesColors.size()]; }

/// Color `index` of `count` ordered items (terms, settings of one input): from dark blue to amber with rising
/// lightness, as in the workbench. `light` scales the brightness.
std::string rampColor(std::size_t index, std::size_t count, double light = 1);
/// `light` for texts in these colors: dark enough to read on white.
inline constexpr double kTextLight = 0.65;

/// Color of `share` in [0, 1] on a scale from dark blue over green to yellow with rising lightness (after the map
/// viridis of Smith and van der Walt 2015). `light` scales the brightness.
std::string scaleColor(double share, double light = 1);

}  // namespace tactus::report
