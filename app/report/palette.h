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

/// Colours of things that have an order or a number (experts, terms), used round and round.
inline constexpr std::array<std::string_view, 6> kSeriesColors = {kBlue, kOrange, kGreen, kVermilion, kPurple, kSky};

inline std::string_view seriesColor(std::size_t index) { return kSeriesColors[index % kSeriesColors.size()]; }

/// Colour of `share` in [0, 1] on a scale from dark blue over green to yellow, rising in lightness all the way
/// (after the map viridis of Smith and van der Walt 2015), `light` times as bright.
std::string scaleColor(double share, double light = 1);

}  // namespace tactus::report
