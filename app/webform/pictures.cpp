#include "app/webform/pictures.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::webform {

namespace {

std::string tenths(double value) { return base::formatNumber(std::round(value * 10) / 10); }

/// The name of its file, without folder and ending: `upright`.
std::string postureIn(const procedure::Picture& picture) {
  const auto slash = picture.file.rfind('/');
  const std::string name = slash == std::string::npos ? picture.file : picture.file.substr(slash + 1);
  return name.substr(0, name.rfind('.'));
}

std::string lineTo(const Picture& picture, const PictureRegion& region) {
  std::string d = "M";
  for (std::size_t i = 0; i <= region.end; ++i)
    d += tenths(picture.tube[i].x) + ' ' + tenths(picture.tube[i].y) + (i == 0 ? "L" : " ");
  return d + tenths(region.tip.x) + ' ' + tenths(region.tip.y);
}

}  // namespace

std::vector<Picture> pictures(const procedure::Procedure& procedure) {
  std::vector<Picture> out;
  for (const procedure::Picture& picture : procedure::picturesOf(procedure)) {
    Picture& one = out.emplace_back();
    one.posture = postureIn(picture);
    one.drawing = picture.svg.substr(0, picture.svg.rfind("</svg>") + std::string_view("</svg>").size());
    one.box = one.near = {picture.left, picture.top, picture.width, picture.height};
    if (picture.near) one.near = {picture.near->left, picture.near->top, picture.near->width, picture.near->height};
    one.tube = picture.approach;
    one.tube.insert(one.tube.end(), picture.way.begin(), picture.way.end());
    for (const auto& term : procedure.wayInput().terms) {
      PictureRegion& region = one.regions.emplace_back();
      region.id = term.id;
      region.outline = picture.regions.at(term.id);
      const double middle_mm =
          std::clamp((term.points[1] + term.points[2]) / 2, picture.way_mm.front(), picture.way_mm.back());
      const auto next = std::upper_bound(picture.way_mm.begin(), picture.way_mm.end() - 1, middle_mm);
      region.end = picture.approach.size() +
                   static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - picture.way_mm.begin() - 1, 0));
      region.tip = procedure::placeAt(picture, middle_mm);
      region.far = picture.near && !procedure::holds(*picture.near, region.tip);
    }
  }
  return out;
}

std::string postureOf(const procedure::Procedure& procedure, const study::ItemCondition& condition) {
  const auto all = procedure::picturesOf(procedure);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& picture) { return picture.pose == condition; });
  return postureIn(found == all.end() ? all.front() : *found);
}

std::string regionsPicture(const procedure::Procedure& procedure, const study::Form& form) {
  std::vector<std::pair<std::string, std::string>> tips;
  for (const std::string& region : procedure::regionsOf(procedure, form))
    tips.emplace_back(region, std::to_string(tips.size() + 1));
  return pictureFile(pictures(procedure).front(), tips);
}

std::string pictureFile(const Picture& picture, const std::vector<std::pair<std::string, std::string>>& tips) {
  std::string lit;
  std::string marks;
  const PictureRegion* deepest = nullptr;
  for (const PictureRegion& region : picture.regions) {
    for (const auto& [id, label] : tips) {
      if (region.id != id) continue;
      deepest = &region;
      lit += "<path d=\"" + region.outline + "\" fill=\"#FFC247\" stroke=\"#6B4500\" stroke-width=\"1.3\"/>";
      const std::string x = tenths(region.tip.x);
      const std::string y = tenths(region.tip.y);
      marks +=
          "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"4\" fill=\"#0B659E\" stroke=\"#FFFFFF\" stroke-width=\"2\"/>";
      if (!label.empty()) {
        const std::string at = tenths(region.tip.x + 16);
        marks += "<circle cx=\"" + at + "\" cy=\"" + y + "\" r=\"9\" fill=\"#FFFFFF\" stroke=\"#1F2933\"/><text x=\"" +
                 at + "\" y=\"" + tenths(region.tip.y + 4) +
                 "\" font-family=\"Arial, sans-serif\" font-size=\"11\" text-anchor=\"middle\">" + label + "</text>";
      }
    }
  }
  std::string tube;
  if (deepest != nullptr) {
    const std::string d = lineTo(picture, *deepest);
    for (const char* const stroke :
         {"#FFFFFF\" stroke-width=\"6", "#0B659E\" stroke-width=\"4", "#7DB9DC\" stroke-width=\"1"})
      tube += "<path d=\"" + d + "\" fill=\"none\" stroke-linecap=\"round\" stroke=\"" + stroke + "\"/>";
  }
  std::string out = picture.drawing.substr(0, picture.drawing.size() - std::string_view("</svg>").size());
  return out + lit + tube + marks + "</svg>\n";
}

}  // namespace tactus::webform
