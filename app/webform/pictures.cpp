#include "app/webform/pictures.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::webform {

// Embedded from app/workbench/anatomy/drawings.
std::string_view uprightDrawing();
std::string_view halfFlexedDrawing();
std::string_view chinOnChestDrawing();

namespace {

constexpr std::array<std::string_view, 6> kRegions = {"nasal_cavity",   "nasopharynx", "oropharynx",
                                                      "laryngopharynx", "esophagus",   "stomach"};
constexpr std::size_t kNearRegions = 4;  // those of nose and throat
constexpr double kNearMarginMm = 26;     // to the tip of the nose and the back of the neck
constexpr int kSteps = 8;                // for each piece of a curve: 2 mm and less

/// The value of the attribute `name` at or behind `from`.
std::string_view attribute(std::string_view file, std::string_view name, std::size_t from) {
  const std::string opening = ' ' + std::string(name) + "=\"";
  const auto begin = file.find(opening, from);
  TACTUS_CHECK(begin != std::string_view::npos);
  const auto value = begin + opening.size();
  return file.substr(value, file.find('"', value) - value);
}

std::vector<double> numbersIn(std::string_view text) {
  std::vector<double> out;
  std::string number;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    const bool part = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (part) {
      number += c;
    } else if (!number.empty()) {
      const auto value = base::parseNumber(number);
      TACTUS_CHECK(value.has_value());
      out.push_back(*value);
      number.clear();
    }
  }
  return out;
}

/// The points along `d`: M, L, C and Z with absolute numbers, as in the drawings.
std::vector<Point> pointsOf(std::string_view d) {
  std::vector<Point> line;
  for (std::size_t at = 0; at < d.size();) {
    const auto next = std::min(d.find_first_of("MLCZ", at + 1), d.size());
    const std::vector<double> n = numbersIn(d.substr(at + 1, next - at - 1));
    if (d[at] == 'C') {
      for (std::size_t i = 0; i + 5 < n.size(); i += 6) {
        const Point from = line.back();
        for (int step = 1; step <= kSteps; ++step) {
          const double t = static_cast<double>(step) / kSteps;
          const double s = 1 - t;
          const std::array<double, 4> b = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
          line.push_back({b[0] * from.x + b[1] * n[i] + b[2] * n[i + 2] + b[3] * n[i + 4],
                          b[0] * from.y + b[1] * n[i + 1] + b[2] * n[i + 3] + b[3] * n[i + 5]});
        }
      }
    } else {
      for (std::size_t i = 0; i + 1 < n.size(); i += 2) line.push_back({n[i], n[i + 1]});
    }
    at = next;
  }
  return line;
}

bool isInside(const std::vector<Point>& outline, const Point& point) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point& a = outline[i];
    const Point& b = outline[j];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// Sets the tip half of the way through the region.
void placeTip(const std::vector<Point>& tube, const std::vector<Point>& outline, PictureRegion& region) {
  std::optional<std::size_t> first;
  std::size_t last = 0;
  for (std::size_t i = 0; i < tube.size(); ++i) {
    if (!isInside(outline, tube[i])) continue;
    if (!first) first = i;
    last = i;
  }
  TACTUS_CHECK(first.has_value());
  std::vector<double> way(tube.size(), 0);
  for (std::size_t i = *first + 1; i <= last; ++i)
    way[i] = way[i - 1] + std::hypot(tube[i].x - tube[i - 1].x, tube[i].y - tube[i - 1].y);
  region.end = *first;
  while (way[region.end + 1] < way[last] / 2) ++region.end;
  region.tip = tube[region.end + 1];
}

std::array<double, 4> boxAround(const std::vector<Point>& points, double margin) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Point low{kFar, kFar};
  Point high{-kFar, -kFar};
  for (const Point& point : points) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  return {low.x - margin, low.y - margin, high.x - low.x + 2 * margin, high.y - low.y + 2 * margin};
}

/// Of the drawings of the default procedure, which the program carries: the screens move the neck between them.
Picture drawnPicture(std::string_view posture, std::string_view file) {
  const auto regions = file.find("<g id=\"regions\">");
  const auto tube = file.find("<g id=\"tube\">");
  const auto after_regions = file.find("</g>", regions) + 4;
  TACTUS_CHECK(regions < after_regions && after_regions < tube && tube != std::string_view::npos);
  Picture out;
  out.posture = posture;
  out.drawing =
      std::string(file.substr(0, regions)) + std::string(file.substr(after_regions, tube - after_regions)) + "</svg>";
  const auto box = numbersIn(attribute(file, "viewBox", 0));
  std::copy_n(box.begin(), 4, out.box.begin());
  out.tube = pointsOf(attribute(file, "d", tube));
  std::vector<Point> throat;
  for (const std::string_view id : kRegions) {
    PictureRegion region;
    region.id = id;
    region.outline = attribute(file, "d", file.find("id=\"region_" + region.id + "\""));
    const auto outline = pointsOf(region.outline);
    placeTip(out.tube, outline, region);
    region.far = out.regions.size() >= kNearRegions;
    if (!region.far) throat.insert(throat.end(), outline.begin(), outline.end());
    out.regions.push_back(std::move(region));
  }
  out.near = boxAround(throat, kNearMarginMm);
  return out;
}

std::string tenths(double value) { return base::formatNumber(std::round(value * 10) / 10); }

std::string lineTo(const Picture& picture, const PictureRegion& region) {
  std::string d = "M";
  for (std::size_t i = 0; i <= region.end; ++i)
    d += tenths(picture.tube[i].x) + ' ' + tenths(picture.tube[i].y) + (i == 0 ? "L" : " ");
  return d + tenths(region.tip.x) + ' ' + tenths(region.tip.y);
}

}  // namespace

std::vector<Picture> pictures(const procedure::Procedure& procedure) {
  if (procedure.pictures.empty() && procedure.id == procedure::defaultProcedure()->id) {
    return {drawnPicture("upright", uprightDrawing()), drawnPicture("half", halfFlexedDrawing()),
            drawnPicture("chest", chinOnChestDrawing())};
  }
  std::vector<Picture> out;
  for (const procedure::Picture& picture : procedure::picturesOf(procedure)) {
    Picture& one = out.emplace_back();
    one.posture = "p" + std::to_string(out.size());
    one.drawing = picture.svg.substr(0, picture.svg.rfind("</svg>") + std::string_view("</svg>").size());
    one.box = one.near = {picture.left, picture.top, picture.width, picture.height};
    one.tube = picture.way;
    for (const auto& term : procedure.wayInput().terms) {
      PictureRegion& region = one.regions.emplace_back();
      region.id = term.id;
      region.outline = picture.regions.at(term.id);
      const double middle_mm =
          std::clamp((term.points[1] + term.points[2]) / 2, picture.way_mm.front(), picture.way_mm.back());
      const auto next = std::upper_bound(picture.way_mm.begin(), picture.way_mm.end() - 1, middle_mm);
      region.end = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - picture.way_mm.begin() - 1, 0));
      region.tip = procedure::placeAt(picture, middle_mm);
    }
  }
  return out;
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

std::string postureOf(const procedure::Procedure& procedure, const study::ItemCondition& condition) {
  const auto all = pictures(procedure);
  for (std::size_t i = 0; i < procedure.pictures.size(); ++i) {
    if (procedure.pictures[i].pose == condition) return all[i].posture;
  }
  if (procedure.pictures.empty() && all.size() > 1) {
    // The drawings stand in the order of the words of the input that is drawn as a pose.
    for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
      const auto& terms = procedure.inputs[i].terms;
      if (procedure.inputs[i].id != condition.input ||
          procedure.input_notes[i].picture != procedure::LevelPicture::kPose)
        continue;
      const auto term =
          std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == condition.term; });
      const auto place = static_cast<std::size_t>(term - terms.begin());
      if (place < all.size()) return all[place].posture;
    }
  }
  return all.front().posture;
}

}  // namespace tactus::webform
