// The body in three dimensions, from the outline of its picture from the side, and how it is drawn without any graphics
// library: turned, projected in parallel, shaded triangle by triangle into pixels.
//
// The outline is blown up like a balloon: its sections are ellipses, a limb becomes as broad as it is deep, and the
// nose stays narrow beside the head. Where the picture ends, the body is cut straight and fades. Coordinates are those
// of the picture, x to the right and y down, and z toward its viewer, 0 in its plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/procedure/procedure.h"

namespace tactus::workbench::anatomy {

struct Spot {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// A closed surface.
struct Solid {
  struct Vertex {
    Spot at;
    Spot normal;      ///< outward, of length 1
    double seen = 1;  ///< 0 where the picture ends
  };
  std::vector<Vertex> vertices;
  /// (b - a) × (c - a) points outward.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The part of the plane in which an outline counts.
struct Frame {
  double left = 0, top = 0, width = 0, height = 0;
};
inline Frame frameOf(const procedure::Picture& picture) {
  return {picture.left, picture.top, picture.width, picture.height};
}

/// Blows up `outline`, a closed line, with `cells` steps along its longer side. `breadth`: of the whole at its
/// broadest; nothing: a limb is as broad as it is deep. Empty if the outline encloses nothing.
Solid solidOf(const std::vector<procedure::Point>& outline, const Frame& frame, std::optional<double> breadth,
              int cells);

/// The place of the tip at `place_mm`, clamped to the way.
Spot wayAt(const procedure::Picture& picture, double place_mm);
/// The way between two places, `from_mm` <= `to_mm`.
std::vector<Spot> wayBetween(const procedure::Picture& picture, double from_mm, double to_mm);
/// The tool with its tip at `depth_mm`. It comes as the picture says, or straight on over the distance `outside`, in
/// units of the picture; before the beginning of the way the tip is in front of the body.
std::vector<Spot> toolTo(const procedure::Picture& picture, double depth_mm, double outside);

/// How the body is turned before the viewer: first about its upright axis, then toward him.
struct Turn {
  double yaw_deg = 0;
  double pitch_deg = 0;
};
/// The turn that shows the front.
Turn frontTurn(procedure::FrontSide front);

/// From the body to a picture of it, in px; z grows toward the viewer.
class Projection {
 public:
  /// `center` of the body comes to `x`, `y`; a unit of the body is `scale` px.
  Projection(const Turn& turn, const Spot& center, double scale, double x, double y);

  Spot operator()(const Spot& at) const;
  /// A direction, not moved and not scaled.
  Spot turned(const Spot& direction) const;

 private:
  std::array<double, 9> rows_;
  Spot center_;
  double scale_;
  double x_, y_;
};

/// Pixels, premultiplied 0xAARRGGBB, row by row.
struct Canvas {
  Canvas(int columns, int rows);

  int width;
  int height;
  std::vector<std::uint32_t> pixels;
  std::vector<std::uint32_t> layer;  ///< of the solid that is drawn
  std::vector<float> depths;         ///< of the layer
};

struct SolidColors {
  std::uint32_t lit = 0;     ///< 0xRRGGBB, of what faces the light
  std::uint32_t shaded = 0;  ///< of what is turned away from it
  double clear = 1;          ///< opacity of what faces the viewer
  double edge = 1;           ///< of what he sees at a grazing angle
};

/// A piece of the line at which the surface turns away from the viewer, px.
struct ContourLine {
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  double seen = 1;
};

/// Draws the nearest faces of `solid` over what `canvas` has, and gives its contour, as far as the solid does not hide
/// it.
std::vector<ContourLine> drawSolid(Canvas& canvas, const Solid& solid, const Projection& projection,
                                   const SolidColors& colors);

}  // namespace tactus::workbench::anatomy
