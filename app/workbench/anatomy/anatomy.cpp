#include "app/workbench/anatomy/anatomy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/check.h"

namespace tactus::workbench::anatomy {
namespace {

struct Joint {
  double x;
  double y;
  double share;  // degrees of 60
  double level;  // height at which it acts, mm
};

// C0/1 to T1/2. Shares of active flexion: C0/1 and C1/2 little, most between C4 and C7.
constexpr std::array kJoints = {Joint{110, -8, 4, -8},   Joint{104, 18, 8, 14},   Joint{106, 56, 4, 46},
                                Joint{108, 74, 7, 65},   Joint{111, 93, 9, 84},   Joint{116, 110, 10, 102},
                                Joint{121, 128, 9, 120}, Joint{126, 147, 6, 139}, Joint{130, 165, 3, 158}};
constexpr double kAllShares = 60;
constexpr double kFadeMm = 26;  // over which a joint's turn fades around its level

double levelOf(const QPointF& point, Part part) {
  switch (part) {
    case Part::kHead: return -60;
    case Part::kHyoid: return 52;
    case Part::kLarynx: return 84;
    case Part::kWindpipe: return 84 + 1.05 * (point.y() - 118);
    case Part::kTrunk: return 400;
    case Part::kSoft: break;
  }
  // In front of the spine soft tissue hangs on joints further up.
  return point.y() - 0.9 * std::max(0.0, 96 - point.x());
}

}  // namespace

QPointF posed(const QPointF& point, Part part, double flexion_deg) {
  const double level = levelOf(point, part);
  QPointF at = point;
  for (const Joint& joint : kJoints) {
    const double place = std::clamp((joint.level + kFadeMm / 2 - level) / kFadeMm, 0.0, 1.0);
    const double weight = place * place * (3 - 2 * place);
    const double turn = joint.share * flexion_deg / kAllShares * weight * std::numbers::pi / 180;
    const double dx = at.x() - joint.x;
    const double dy = at.y() - joint.y;
    at = {joint.x + dx * std::cos(turn) + dy * std::sin(turn), joint.y - dx * std::sin(turn) + dy * std::cos(turn)};
  }
  return at;
}

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

namespace {

constexpr std::size_t kSteps = 32;   // for each piece: 0.5 mm and less
constexpr std::size_t kNostril = 4;  // the point at the origin

// From the hand to the stomach, upright.
constexpr std::array kThrough = {
    QPointF(-70, 52),    QPointF(-46, 44),    QPointF(-24, 28),    QPointF(-8, 10),     QPointF(0, 0),
    QPointF(4, -6),      QPointF(11, -8),     QPointF(24, -7),     QPointF(45, -4.2),   QPointF(62, -2),
    QPointF(74, 0),      QPointF(83, 6),      QPointF(88, 16),     QPointF(90, 28),     QPointF(90, 42),
    QPointF(90, 56),     QPointF(91, 70),     QPointF(93.5, 85),   QPointF(97, 99),     QPointF(100.5, 109),
    QPointF(104.5, 122), QPointF(109.5, 138), QPointF(115.5, 157), QPointF(121.5, 178), QPointF(127, 198),
    QPointF(130, 212),   QPointF(132.5, 230), QPointF(134, 248),   QPointF(133.5, 266), QPointF(131, 282),
    QPointF(127, 297),   QPointF(121, 312),   QPointF(114.5, 324), QPointF(109, 333),   QPointF(106, 341),
    QPointF(103, 356),   QPointF(97, 372),    QPointF(86, 385),    QPointF(72, 392),    QPointF(60, 392)};

// A smooth line through points (Catmull and Rom): each piece is a cubic whose control points lie at a sixth of the
// chord between the neighbors.
std::vector<QPointF> smoothLine(const std::vector<QPointF>& through) {
  const std::size_t last = through.size() - 1;
  std::vector<QPointF> line;
  line.reserve(last * kSteps + 1);
  for (std::size_t i = 0; i < last; ++i) {
    const QPointF from = through[i];
    const QPointF to = through[i + 1];
    const QPointF leaving = from + (to - through[i == 0 ? 0 : i - 1]) / 6;
    const QPointF arriving = to - (through[std::min(i + 2, last)] - from) / 6;
    for (std::size_t step = 0; step < kSteps; ++step) {
      const double t = static_cast<double>(step) / static_cast<double>(kSteps);
      const double s = 1 - t;
      line.push_back(from * (s * s * s) + leaving * (3 * s * s * t) + arriving * (3 * s * t * t) + to * (t * t * t));
    }
  }
  line.push_back(through.back());
  return line;
}

std::vector<QPointF> lineAt(double flexion_deg) {
  std::vector<QPointF> through;
  through.reserve(kThrough.size());
  for (const QPointF& point : kThrough) through.push_back(posed(point, Part::kSoft, flexion_deg));
  return smoothLine(through);
}

// The way along `line`, 0 at the nostril.
std::vector<double> lengthsOf(const std::vector<QPointF>& line) {
  std::vector<double> lengths(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const QPointF step = line[i] - line[i - 1];
    lengths[i] = lengths[i - 1] + std::hypot(step.x(), step.y());
  }
  const double nostril = lengths[kNostril * kSteps];
  for (double& length : lengths) length -= nostril;
  return lengths;
}

}  // namespace

TubeWay::TubeWay(double flexion_deg) : line_(lineAt(flexion_deg)), depths_(lengthsOf(lineAt(0))) {}

QPointF TubeWay::placeAt(double depth_mm) const {
  const double depth = std::clamp(depth_mm, beginMm(), endMm());
  const auto above = std::lower_bound(depths_.begin() + 1, depths_.end() - 1, depth);
  const auto i = static_cast<std::size_t>(above - depths_.begin());
  const double share = (depth - depths_[i - 1]) / (depths_[i] - depths_[i - 1]);
  return line_[i - 1] + (line_[i] - line_[i - 1]) * share;
}

std::vector<QPointF> TubeWay::between(double from_mm, double to_mm) const {
  std::vector<QPointF> points = {placeAt(from_mm)};
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (depths_[i] > from_mm && depths_[i] < to_mm) points.push_back(line_[i]);
  }
  points.push_back(placeAt(to_mm));
  return points;
}

double TubeWay::drawnLengthMm(double depth_mm) const {
  const std::vector<QPointF> points = depth_mm < 0 ? between(depth_mm, 0) : between(0, depth_mm);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const QPointF step = points[i] - points[i - 1];
    length += std::hypot(step.x(), step.y());
  }
  return depth_mm < 0 ? -length : length;
}

}  // namespace tactus::workbench::anatomy
