// The regions along the path of the tube, from the nostril inward.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tactus::workbench::anatomy {

enum class Region { kNasalCavity, kNasopharynx, kOropharynx, kLaryngopharynx, kEsophagus, kStomach };

inline constexpr std::array kRegions = {Region::kNasalCavity,    Region::kNasopharynx, Region::kOropharynx,
                                        Region::kLaryngopharynx, Region::kEsophagus,   Region::kStomach};

/// The id of `region`, as in the depth terms of the model: `nasal_cavity`.
std::string_view idOf(Region region);
std::optional<Region> regionWithId(std::string_view id);

/// Where `region` begins, mm from the nostril; it ends where the next one begins.
double beginMm(Region region);

/// The region of a tip at `depth_mm`; nothing in front of the nostril.
std::optional<Region> regionAtDepth(double depth_mm);

}  // namespace tactus::workbench::anatomy
