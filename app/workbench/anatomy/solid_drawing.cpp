#include <algorithm>
#include <cmath>
#include <limits>

#include "app/workbench/anatomy/solid.h"

namespace tactus::workbench::anatomy {
namespace {

constexpr Spot kLight{-0.38, -0.55, 0.744};  // from the upper left, before the picture; of length 1
constexpr double kAmbient = 0.25;
constexpr double kLeastSeen = 0.02;
constexpr double kHiddenShare = 0.03;  // of the canvas: a contour so little behind a face is its own
constexpr float kFar = -std::numeric_limits<float>::infinity();

/// A vertex in px.
struct Corner {
  float x, y, z;
  float light;   ///< [0, 1]
  float opaque;  ///< [0, 1]
  float facing;  ///< the part of the normal that points to the viewer
};

std::uint32_t channel(std::uint32_t color, int shift) { return (color >> shift) & 0xFF; }

std::uint32_t premultiplied(const SolidColors& colors, float light, float opaque) {
  const auto alpha = static_cast<std::uint32_t>(std::lround(255 * std::clamp(opaque, 0.F, 1.F)));
  const auto share = static_cast<std::uint32_t>(std::lround(255 * std::clamp(light, 0.F, 1.F)));
  std::uint32_t out = alpha << 24U;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t mixed =
        channel(colors.lit, shift) * share + channel(colors.shaded, shift) * (255 - share);  // 0 to 255²
    out |= (mixed * alpha / (255 * 255)) << static_cast<unsigned>(shift);
  }
  return out;
}

std::vector<Corner> cornersOf(const Solid& solid, const Projection& projection, const SolidColors& colors) {
  std::vector<Corner> out;
  out.reserve(solid.vertices.size());
  for (const Solid::Vertex& vertex : solid.vertices) {
    const Spot at = projection(vertex.at);
    const Spot normal = projection.turned(vertex.normal);
    const double toward_light = normal.x * kLight.x + normal.y * kLight.y + normal.z * kLight.z;
    const double grazing = 1 - std::clamp(std::abs(normal.z), 0.0, 1.0);
    const double opaque = vertex.seen * (colors.clear + (colors.edge - colors.clear) * grazing * grazing);
    out.push_back({static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z),
                   static_cast<float>(kAmbient + (1 - kAmbient) * std::max(0.0, toward_light)),
                   static_cast<float>(opaque), static_cast<float>(normal.z)});
  }
  return out;
}

/// The part of the canvas that the solid covers, whole px, its end behind it.
struct Extent {
  int left, top, right, bottom;
};

Extent extentOf(const Canvas& canvas, const std::vector<Corner>& corners) {
  float left = static_cast<float>(canvas.width), top = static_cast<float>(canvas.height), right = 0, bottom = 0;
  for (const Corner& corner : corners) {
    left = std::min(left, corner.x);
    right = std::max(right, corner.x);
    top = std::min(top, corner.y);
    bottom = std::max(bottom, corner.y);
  }
  const auto whole = [](float at, int end) { return static_cast<int>(std::clamp(at, 0.F, static_cast<float>(end))); };
  return {whole(left, canvas.width), whole(top, canvas.height), whole(right + 1, canvas.width),
          whole(bottom + 1, canvas.height)};
}

/// A number at each pixel of a triangle, even between its corners.
struct Ramp {
  float start, along, down;
};

class Triangle {
 public:
  /// Nothing is drawn of one that is seen from inside.
  Triangle(const Corner& a, const Corner& b, const Corner& c) : a_(a), b_(b), c_(c) {
    area_ = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  }

  void draw(Canvas& canvas, const std::vector<std::uint32_t>& shades, const Extent& extent) const {
    if (!(area_ > 0)) return;
    const auto [x_min, x_max] = std::minmax({a_.x, b_.x, c_.x});
    const auto [y_min, y_max] = std::minmax({a_.y, b_.y, c_.y});
    const int left = std::max(extent.left, static_cast<int>(x_min));
    const int right = std::min(extent.right, static_cast<int>(x_max) + 1);
    const int top = std::max(extent.top, static_cast<int>(y_min));
    const int bottom = std::min(extent.bottom, static_cast<int>(y_max) + 1);
    const float x = static_cast<float>(left) + 0.5F, y = static_cast<float>(top) + 0.5F;
    Ramp in_a = edge(b_, c_, x, y), in_b = edge(c_, a_, x, y), in_c = edge(a_, b_, x, y);
    const float scale = 1 / area_;
    for (int row = top; row < bottom; ++row) {
      float wa = in_a.start, wb = in_b.start, wc = in_c.start;
      const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas.width);
      for (int column = left; column < right; ++column, wa += in_a.along, wb += in_b.along, wc += in_c.along) {
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const std::size_t at = line + static_cast<std::size_t>(column);
        const float z = (wa * a_.z + wb * b_.z + wc * c_.z) * scale;
        if (z <= canvas.depths[at]) continue;
        canvas.depths[at] = z;
        const float light = (wa * a_.light + wb * b_.light + wc * c_.light) * scale;
        const float opaque = (wa * a_.opaque + wb * b_.opaque + wc * c_.opaque) * scale;
        canvas.layer[at] =
            shades[static_cast<std::size_t>(light * 63.F + 0.5F) * 64 + static_cast<std::size_t>(opaque * 63.F + 0.5F)];
      }
      for (Ramp* const ramp : {&in_a, &in_b, &in_c}) ramp->start += ramp->down;
    }
  }

 private:
  /// Twice the area beside the edge from `from` to `to`, at (x, y); positive inside.
  static Ramp edge(const Corner& from, const Corner& to, float x, float y) {
    const float along = -(to.y - from.y), down = to.x - from.x;
    return {down * (y - from.y) + along * (x - from.x), along, down};
  }

  const Corner& a_;
  const Corner& b_;
  const Corner& c_;
  float area_;
};

/// Two of the channels of `pixel` times `share` / 255, rounded, each in its place.
std::uint32_t shareOf(std::uint32_t pixel, std::uint32_t share) {
  constexpr std::uint32_t kChannels = 0x00FF00FFU;
  const std::uint32_t product = (pixel & kChannels) * share + 0x00800080U;
  return ((product + ((product >> 8U) & kChannels)) >> 8U) & kChannels;
}

void blend(Canvas& canvas, const Extent& extent) {
  for (int row = extent.top; row < extent.bottom; ++row) {
    const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas.width);
    for (int column = extent.left; column < extent.right; ++column) {
      const std::size_t at = line + static_cast<std::size_t>(column);
      const std::uint32_t over = canvas.layer[at];
      if (over == 0) continue;
      const std::uint32_t left = 255 - (over >> 24U);
      std::uint32_t& pixel = canvas.pixels[at];
      pixel = over + shareOf(pixel, left) + (shareOf(pixel >> 8U, left) << 8U);
    }
  }
}

/// Where the surface turns away from the viewer on its way from `a` to `b`.
Corner turning(const Corner& a, const Corner& b) {
  const float t = a.facing / (a.facing - b.facing);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), 0, 0, 0};
}

bool isHidden(const Canvas& canvas, float x, float y, float z) {
  if (x < 0 || y < 0 || x >= static_cast<float>(canvas.width) || y >= static_cast<float>(canvas.height)) return true;
  const float nearest =
      canvas.depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width) + static_cast<std::size_t>(x)];
  return nearest > z + static_cast<float>(kHiddenShare * std::max(canvas.width, canvas.height));
}

std::vector<ContourLine> contourOf(const Canvas& canvas, const Solid& solid, const std::vector<Corner>& corners) {
  std::vector<ContourLine> out;
  for (const auto& triangle : solid.triangles) {
    const Corner* at[] = {&corners[triangle[0]], &corners[triangle[1]], &corners[triangle[2]]};
    const auto away = [&](int i) { return at[i]->facing < 0; };
    if (away(0) == away(1) && away(1) == away(2)) continue;
    const int alone = away(0) == away(1) ? 2 : away(1) == away(2) ? 0 : 1;
    const double seen =
        (solid.vertices[triangle[0]].seen + solid.vertices[triangle[1]].seen + solid.vertices[triangle[2]].seen) / 3;
    if (seen < kLeastSeen) continue;
    const Corner one = turning(*at[alone], *at[(alone + 1) % 3]);
    const Corner other = turning(*at[alone], *at[(alone + 2) % 3]);
    if (isHidden(canvas, (one.x + other.x) / 2, (one.y + other.y) / 2, (one.z + other.z) / 2)) continue;
    out.push_back({one.x, one.y, other.x, other.y, seen});
  }
  return out;
}

}  // namespace

Canvas::Canvas(int columns, int rows)
    : width(columns),
      height(rows),
      pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0),
      layer(pixels.size(), 0),
      depths(pixels.size(), kFar) {}

std::vector<ContourLine> drawSolid(Canvas& canvas, const Solid& solid, const Projection& projection,
                                   const SolidColors& colors) {
  const std::vector<Corner> corners = cornersOf(solid, projection, colors);
  const Extent extent = extentOf(canvas, corners);
  std::vector<std::uint32_t> shades(64 * 64);
  for (std::size_t i = 0; i < shades.size(); ++i)
    shades[i] = premultiplied(colors, static_cast<float>(i / 64) / 63, static_cast<float>(i % 64) / 63);
  for (const auto& triangle : solid.triangles)
    Triangle(corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]).draw(canvas, shades, extent);
  blend(canvas, extent);
  std::vector<ContourLine> contour = contourOf(canvas, solid, corners);
  // Ready for what is drawn over it.
  for (int row = extent.top; row < extent.bottom; ++row) {
    const auto begin = static_cast<std::ptrdiff_t>(row) * canvas.width + extent.left;
    const auto end = begin + std::max(0, extent.right - extent.left);
    std::fill(canvas.layer.begin() + begin, canvas.layer.begin() + end, 0);
    std::fill(canvas.depths.begin() + begin, canvas.depths.begin() + end, kFar);
  }
  return contour;
}

}  // namespace tactus::workbench::anatomy
