#include "app/workbench/feel/tube_picture.h"

#include <numeric>

#include "app/workbench/base/theme.h"
#include "app/workbench/model/patient.h"

namespace tactus::workbench {
namespace {

// Deeper than the upper sphincter the tip leaves the picture of head and neck.
constexpr double kNeckEndMm = 215;

}  // namespace

anatomy::Posture drawnPosture(const fuzzy::Variable& neck_flexion, double value) {
  using anatomy::Posture;
  const auto word = strongestTerm(neck_flexion, value);
  if (!word)
    return value < std::midpoint(neck_flexion.min, neck_flexion.max) ? Posture::kUpright : Posture::kChinOnChest;
  if (*word == 0) return Posture::kUpright;
  return *word + 1 == neck_flexion.terms.size() ? Posture::kChinOnChest : Posture::kHalfFlexed;
}

TubePicture::TubePicture(QWidget* parent) : AnatomyView(parent) {
  setAccessibleName(tr("The tube in nose, throat and esophagus, from the side"));
  setFont(theme::smallFont());
  showTip();
}

void TubePicture::setRegions(std::vector<DepthRegion> regions) {
  regions_ = std::move(regions);
  showTip();
}

void TubePicture::setTip(double depth_mm) {
  depth_mm_ = depth_mm;
  showTip();
}

QString TubePicture::regionText() const {
  const auto region = depth_mm_ > 0 ? regionAt(regions_, depth_mm_) : std::nullopt;
  return region ? regions_[*region].label : QString();
}

void TubePicture::setNeck(anatomy::Posture posture) {
  setPosture(posture, placed_);
  placed_ = true;
}

void TubePicture::showTip() {
  setDepth(depth_mm_);
  setFraming(depth_mm_ > kNeckEndMm ? anatomy::Framing::kWhole : anatomy::Framing::kHeadAndNeck);
  const auto region = depth_mm_ > 0 ? regionAt(regions_, depth_mm_) : std::nullopt;
  std::optional<anatomy::LitRange> lit;
  if (region) lit = {regions_[*region].from_mm, regions_[*region].to_mm, regions_[*region].label};
  light(lit);
}

}  // namespace tactus::workbench
