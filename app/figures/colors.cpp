#include "app/figures/colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::figures {
namespace {

constexpr std::array<Rgb, 4> kRamp = {{{0x2C, 0x3E, 0x8C}, {0x1F, 0x7A, 0xA8}, {0x35, 0xA8, 0x8A}, {0xE9, 0xA8, 0x20}}};

/// Of the regions in the order of the way; the next one is the first again.
constexpr std::array<Rgb, 6> kRegions = {{{0x8C, 0x6D, 0x46},
                                          {0x6B, 0x7F, 0x3F},
                                          {0x3E, 0x82, 0x73},
                                          {0x4A, 0x78, 0xA6},
                                          {0x7C, 0x6B, 0xAA},
                                          {0xA3, 0x61, 0x7F}}};
constexpr Rgb kWhite = {0xFF, 0xFF, 0xFF};
constexpr double kTintOfAPart = 0.09;
constexpr int kMostTints = 2;  // a lighter one would be lost on a white card

constexpr Rgb kFirstGray = {0x6B, 0x77, 0x84};
constexpr Rgb kLastGray = {0x7E, 0x8A, 0x96};

constexpr std::array<Rgb, 6> kExperts = {{{0x00, 0x72, 0xB2},
                                          {0xD5, 0x5E, 0x00},
                                          {0x00, 0x87, 0x5F},
                                          {0xB0, 0x50, 0x8A},
                                          {0x9C, 0x7A, 0x00},
                                          {0x37, 0x96, 0xBD}}};

double shareOf(std::size_t index, std::size_t count) {
  return count < 2 ? 0 : static_cast<double>(index) / static_cast<double>(count - 1);
}

/// Relative luminance.
double luminance(const Rgb& color) {
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

using Regions = std::vector<std::string>;

/// The regions of each procedure that the program carries, in the order of the way.
const std::vector<Regions>& knownRegions() {
  static const std::vector<Regions> known = [] {
    std::vector<Regions> out;
    for (const std::string& id : procedure::builtInIds()) {
      auto& regions = out.emplace_back();
      for (const fuzzy::Term& term : procedure::builtIn(id)->wayInput().terms) regions.push_back(term.id);
    }
    return out;
  }();
  return known;
}

/// The place of the region that `id` is, or is a part of: `oropharynx_2` of `oropharynx`.
std::optional<std::size_t> placeIn(const Regions& regions, std::string_view id) {
  const auto found = std::find_if(regions.begin(), regions.end(), [id](const std::string& region) {
    return id.starts_with(region) && (id.size() == region.size() || id[region.size()] == '_');
  });
  return found == regions.end() ? std::nullopt : std::optional<std::size_t>(found - regions.begin());
}

/// The regions of the procedure that knows most of `terms`; the first one of equals.
const Regions& regionsFor(const std::vector<fuzzy::Term>& terms) {
  const auto known = [&terms](const Regions& regions) {
    return std::count_if(terms.begin(), terms.end(),
                         [&regions](const fuzzy::Term& term) { return placeIn(regions, term.id).has_value(); });
  };
  const auto& all = knownRegions();
  return *std::max_element(all.begin(), all.end(),
                           [&](const Regions& one, const Regions& other) { return known(one) < known(other); });
}

}  // namespace

std::string hex(const Rgb& color) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out = "#";
  for (const std::uint8_t byte : {color.red, color.green, color.blue}) {
    out += kDigits[byte / 16U];
    out += kDigits[byte % 16U];
  }
  return out;
}

Rgb mixed(const Rgb& from, const Rgb& to, double share) {
  const auto mix = [share](std::uint8_t low, std::uint8_t high) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(low + (high - low) * share, 0.0, 255.0)));
  };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

double contrast(const Rgb& one, const Rgb& other) {
  const double a = luminance(one);
  const double b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

Rgb readable(const Rgb& color, const Rgb& card, const Rgb& ink, double least) {
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const Rgb out = mixed(color, ink, static_cast<double>(i) / kSteps);
    if (contrast(out, card) >= least) return out;
  }
  return ink;
}

Rgb forceRamp(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  return mixed(kRamp[below], kRamp[below + 1], place - static_cast<double>(below));
}

Rgb regionColor(const std::vector<fuzzy::Term>& terms, std::size_t index) {
  const Regions& regions = regionsFor(terms);
  const auto place = placeIn(regions, terms[index].id);
  const Rgb color = kRegions[place.value_or(index) % kRegions.size()];
  if (!place) return color;
  const auto before = std::count_if(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(index),
                                    [&](const fuzzy::Term& term) { return placeIn(regions, term.id) == place; });
  return mixed(color, kWhite, kTintOfAPart * static_cast<double>(before % (kMostTints + 1)));
}

Rgb termColor(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  if (variable.unit == "N") return forceRamp(shareOf(index, terms.size()));
  if (variable.unit == "mm") return regionColor(terms, index);
  return mixed(kFirstGray, kLastGray, shareOf(index, terms.size()));
}

std::vector<std::size_t> expertNumbers(const std::vector<fuzzy::Expert>& experts) {
  std::vector<std::size_t> numbers;
  for (const fuzzy::Expert& expert : experts) {
    const std::size_t last = expert.id.find_last_not_of("0123456789");
    const std::string digits = last == std::string::npos ? expert.id : expert.id.substr(last + 1);
    const auto number = digits.size() > 3 ? std::nullopt : base::parseNumber(digits);
    if (!number || *number < 1) break;
    numbers.push_back(static_cast<std::size_t>(*number) - 1);
  }
  const std::set<std::size_t> different(numbers.begin(), numbers.end());
  if (different.size() == experts.size()) return numbers;
  numbers.resize(experts.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

Rgb expertColor(std::size_t number) { return kExperts[number % kExperts.size()]; }

}  // namespace tactus::figures
