// The pictures of the form: the drawings of the participant's screens, with the places of the tube's tip.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/procedure/procedure.h"

namespace tactus::webform {

using procedure::Point;

/// A region of the way of the tube.
struct PictureRegion {
  std::string id;       ///< as the terms of the way
  std::string outline;  ///< `d` of an SVG path
  Point tip;            ///< where the tip lies that is in the region: half of the way through it
  std::size_t end = 0;  ///< index in Picture::tube of the last point before the tip
  bool far = false;     ///< outside Picture::near
};

/// The body in one pose.
struct Picture {
  std::string posture;         ///< the name of its file: `upright`
  std::string drawing;         ///< SVG text
  std::array<double, 4> box;   ///< view box of the drawing: x, y, width, height
  std::array<double, 4> near;  ///< the part of it that most questions are about
  std::vector<Point> tube;     ///< the way of the tool, with its approach
  std::vector<PictureRegion> regions;
};

/// Of each pose of the procedure, first the usual one; a bar of regions for a procedure without pictures.
std::vector<Picture> pictures(const procedure::Procedure& procedure);

/// The picture as an SVG file: the tube in each of the `tips` (ids of regions), whose regions are lit. `labels`: one
/// for each tip, beside it.
std::string pictureFile(const Picture& picture, const std::vector<std::pair<std::string, std::string>>& tips);

/// The pose that a condition is about: its own, if it has one, otherwise the usual one.
std::string postureOf(const procedure::Procedure& procedure, const study::ItemCondition& condition);

/// The usual picture with the regions of `form`, numbered.
std::string regionsPicture(const procedure::Procedure& procedure, const study::Form& form);

}  // namespace tactus::webform
