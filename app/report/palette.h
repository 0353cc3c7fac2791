// Colours of the plots: told apart with any colour vision, and in grey by their line styles.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace tactus::report {

// Okabe and Ito 2008, without the yellow that vanishes on white.
inline constexpr std::string_view kBlue = "#0072B2";
inline constexpr std::string_view kOrange = "#E69F00";
inline constexpr std::string_view kGreen = "#009E73";
inline constexpr std::string_view kVermilion = "#D55E00";
inline constexpr std::string_view kPurple = "#CC79A7";
inline constexpr std::string_view kSky = "#56B4E9";
inline constexpr std::string_view kInk = "#1B1F24";    ///< text, the averaged model
inline constexpr std::string_view kMuted = "#57606A";  ///< axes, secondary text
inline constexpr std::string_view kGrid = "#E3E7EB";

/// Colours of the experts, used round and round; the workbench has the same.
inline constexpr std::array<std::string_view, 6> kSeriesColors = {kBlue, kVermilion, kGreen, kPurple, kOrange, kSky};

/// Colour of one expert, the same in every plot.
inline std::string_view seriesColor(std::size_t index) { return kSeriesColors[index % kSeriesColors.size()]; }

/// Colour of the `index`-th of `count` things in an order (terms, settings of one input), from dark blue to amber,
/// rising in lightness all the way, as in the workbench; `light` times as bright.
std::string rampColor(std::size_t index, std::size_t count, double light = 1);
/// `light` for texts in these colours: dark enough to read on white.
inline constexpr double kTextLight = 0.65;

/// Colour of `share` in [0, 1] on a scale from dark blue over green to yellow, rising in lightness all the way
/// (after the map viridis of Smith and van der Walt 2015), `light` times as bright.
std::string scaleColor(double share, double light = 1);

}  // namespace tactus::report
