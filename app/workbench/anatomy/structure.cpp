#include "app/workbench/anatomy/structure.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"

namespace tactus::workbench::anatomy {
namespace {

constexpr std::array kStructures = {
    Structure{"nasal_cavity", {20, -30}, Part::kHead, Side::kFront},
    Structure{"inferior_turbinate", {40, -17}, Part::kHead, Side::kFront},
    Structure{"nasal_floor", {32, -1.5}, Part::kHead, Side::kFront},
    Structure{"hard_palate", {40, 4}, Part::kHead, Side::kFront},
    Structure{"tongue", {45, 35}, Part::kSoft, Side::kFront},
    Structure{"mandible", {15, 58}, Part::kHead, Side::kFront},
    Structure{"epiglottis", {82, 68}, Part::kLarynx, Side::kFront},
    Structure{"hyoid", {63, 71}, Part::kHyoid, Side::kFront},
    Structure{"thyroid", {69, 94}, Part::kLarynx, Side::kFront},
    Structure{"vocal_folds", {81, 97}, Part::kLarynx, Side::kFront},
    Structure{"cricoid", {77.5, 113}, Part::kLarynx, Side::kFront},
    Structure{"trachea", {90, 150}, Part::kWindpipe, Side::kFront},
    Structure{"heart", {80, 262}, Part::kTrunk, Side::kFront},
    Structure{"diaphragm", {70, 303}, Part::kTrunk, Side::kFront},
    Structure{"choana", {62, -14}, Part::kHead, Side::kBack},
    Structure{"nasopharynx", {82, -8}, Part::kHead, Side::kBack},
    Structure{"bend", {92, 6}, Part::kSoft, Side::kBack},
    Structure{"soft_palate", {80, 20}, Part::kHead, Side::kBack},
    Structure{"oropharynx", {86, 48}, Part::kSoft, Side::kBack},
    Structure{"tongue_base", {78.5, 54}, Part::kSoft, Side::kBack},
    Structure{"laryngopharynx", {94, 80}, Part::kSoft, Side::kBack},
    Structure{"arytenoid", {92.5, 90}, Part::kLarynx, Side::kBack},
    Structure{"ues", {103.5, 106}, Part::kSoft, Side::kBack},
    Structure{"esophagus", {117, 166}, Part::kSoft, Side::kBack},
    Structure{"aortic_arch", {107, 194}, Part::kTrunk, Side::kBack},
    Structure{"left_bronchus", {113, 218}, Part::kTrunk, Side::kBack},
    Structure{"hiatus", {119, 322}, Part::kTrunk, Side::kBack},
    Structure{"cardia", {107, 338}, Part::kTrunk, Side::kBack},
    Structure{"stomach", {110, 385}, Part::kTrunk, Side::kBack},
};

}  // namespace

std::span<const Structure> structures() { return kStructures; }

const Structure& structureOf(Region region) {
  const auto found = std::find_if(kStructures.begin(), kStructures.end(),
                                  [region](const Structure& structure) { return structure.id == idOf(region); });
  TACTUS_CHECK(found != kStructures.end());
  return *found;
}

}  // namespace tactus::workbench::anatomy
