#include "app/workbench/anatomy/neck_rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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
    case Part::kHead:
      return -60;
    case Part::kHyoid:
      return 52;
    case Part::kLarynx:
      return 84;
    case Part::kWindpipe:
      return 84 + 1.05 * (point.y() - 118);
    case Part::kTrunk:
      return 400;
    case Part::kSoft:
      break;
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

}  // namespace tactus::workbench::anatomy
