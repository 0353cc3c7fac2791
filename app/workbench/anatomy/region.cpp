#include "app/workbench/anatomy/region.h"

namespace tactus::workbench::anatomy {
namespace {

struct Entry {
  std::string_view id;
  double begin_mm;  // adults: choana 64 to 70, soft palate 115, epiglottis 150, upper sphincter 200, cardia 440
};

constexpr std::array<Entry, kRegions.size()> kEntries = {Entry{"nasal_cavity", 0}, Entry{"nasopharynx", 70},
                                                         Entry{"oropharynx", 115}, Entry{"laryngopharynx", 150},
                                                         Entry{"esophagus", 200},  Entry{"stomach", 440}};

const Entry& entryOf(Region region) { return kEntries[static_cast<std::size_t>(region)]; }

}  // namespace

std::string_view idOf(Region region) { return entryOf(region).id; }

std::optional<Region> regionWithId(std::string_view id) {
  for (const Region region : kRegions) {
    if (idOf(region) == id) return region;
  }
  return std::nullopt;
}

double beginMm(Region region) { return entryOf(region).begin_mm; }

std::optional<Region> regionAtDepth(double depth_mm) {
  std::optional<Region> found;
  for (const Region region : kRegions) {
    if (depth_mm >= beginMm(region)) found = region;
  }
  return found;
}

}  // namespace tactus::workbench::anatomy
