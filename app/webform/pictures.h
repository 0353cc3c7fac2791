// The pictures of the form: the drawings of the participant's screens, with the places of the tube's tip.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactus::webform {

struct Point {
  double x = 0;
  double y = 0;
};

/// A region of the way of the tube.
struct PictureRegion {
  std::string id;       ///< as the depth terms of the form: `nasal_cavity`
  std::string outline;  ///< `d` of an SVG path
  Point tip;            ///< where the tip lies that is in the region: half of the way through it
  std::size_t end = 0;  ///< index in Picture::tube of the last point before the tip
};

/// A head with neck in one posture, seen from the side.
struct Picture {
  std::string_view posture;    ///< `upright`, `half`, `chest`
  std::string drawing;         ///< SVG text without tube and regions
  std::array<double, 4> box;   ///< view box of the drawing: x, y, width, height in mm
  std::array<double, 4> near;  ///< the part of it with nose and throat
  std::vector<Point> tube;     ///< the way of the tube, from the hand to the stomach
  std::vector<PictureRegion> regions;
};

/// Of the three postures, from upright to chin on chest.
std::vector<Picture> pictures();

/// The picture as an SVG file: the tube in each of the `tips` (ids of regions), whose regions are lit. `labels`: one
/// for each tip, beside it.
std::string pictureFile(const Picture& picture, const std::vector<std::pair<std::string, std::string>>& tips);

/// The posture that a condition is about: of `neck_flexion` its own, otherwise `upright`.
std::string_view postureOf(std::string_view input, std::string_view term);

}  // namespace tactus::webform
