// The body along the way of the tube: its regions, structures, postures, and the path itself.
#pragma once

#include <QPointF>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tactus::workbench::anatomy {

/// The three postures of the neck in which the head is drawn.
enum class Posture { kUpright, kHalfFlexed, kChinOnChest };

/// The angle between head and trunk in the drawing, degrees. The model's neck flexion of 0 to 90 is nominal: its words
/// Small, Medium and Large are drawn as 0, 33 and 66 degrees of active flexion (normal: 60).
constexpr double drawnFlexionDeg(Posture posture) { return 33.0 * static_cast<int>(posture); }

// How points of the drawing move when the neck flexes: nine joints from the skull to the trunk, each turned by its
// share.
//
// Coordinates of the drawing, mm: the head looks left, x to the back, y down, the origin at the rim of the nostril.

/// What a point moves with.
enum class Part { kHead, kHyoid, kLarynx, kWindpipe, kSoft, kTrunk };

/// `point` of the upright drawing, as it lies when the neck is flexed by `flexion_deg`. `kSoft` tissue follows the
/// joints at its own height.
QPointF posed(const QPointF& point, Part part, double flexion_deg);

/// The regions along the path of the tube, from the nostril inward.
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

/// The path of the tube in the drawing. Its length from the nostril is the depth of the model.
class TubeWay {
 public:
  /// The path with the neck flexed by `flexion_deg`. A place keeps the depth that it has in the upright head, so that a
  /// landmark has one depth in every posture; the drawn path to it gets a little shorter.
  explicit TubeWay(double flexion_deg);

  /// The tip at `depth_mm` from the nostril; below 0 it is in front of the nose. Clamped to the path.
  QPointF placeAt(double depth_mm) const;
  /// The path from one depth to another, both clamped, `from_mm` < `to_mm`.
  std::vector<QPointF> between(double from_mm, double to_mm) const;
  /// The drawn length from the nostril to `depth_mm`, mm.
  double drawnLengthMm(double depth_mm) const;

  double beginMm() const { return depths_.front(); }
  double endMm() const { return depths_.back(); }

 private:
  std::vector<QPointF> line_;
  std::vector<double> depths_;  ///< of each point of the line, in the upright head
};

// The structures of the drawing that have a name, and where the name points to.

/// The side of the point on which its name stands, in a head that looks left.
enum class Side { kFront, kBack };

struct Structure {
  std::string_view id;  ///< `soft_palate`
  QPointF at;           ///< in the upright drawing, mm
  Part part;
  Side side;
};

std::span<const Structure> structures();

/// Where the name of `region` points to.
const Structure& structureOf(Region region);

}  // namespace tactus::workbench::anatomy
