#include "app/workbench/plots/curve_looks.h"

#include <array>

#include "app/workbench/controllers/reference_curve.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

constexpr double kGhostShare = 0.6;  // of a line's color; the rest is the ground

QColor faded(const QColor& color) {
  const QColor ground = theme::card();
  const auto mix = [](int line, int behind) {
    return static_cast<int>(line * kGhostShare + behind * (1 - kGhostShare));
  };
  return {mix(color.red(), ground.red()), mix(color.green(), ground.green()), mix(color.blue(), ground.blue())};
}

}  // namespace

QPen ghostPen(const QColor& line, bool fast) {
  QPen pen(faded(line), fast ? 1 : 1.4, Qt::CustomDashLine);
  pen.setDashPattern({4, 3});
  return pen;
}

QPen familyPen(std::size_t index, std::size_t count, bool fast) {
  // The dark end of the ramp would drown in a dark ground.
  return {theme::isDark() ? theme::termText(index, count) : theme::term(index, count), fast ? 1.0 : 2.0};
}

QPen referencePen(std::size_t index) {
  static constexpr std::array<QRgb, kMostReferences> kLight = {0x5B2DA0, 0x6B4E00, 0x00646B,
                                                               0x8A1F11, 0x3F5F00, 0xB0006A};
  static constexpr std::array<QRgb, kMostReferences> kDark = {0xC0A4FF, 0xE2C27A, 0x7FE0E6,
                                                              0xFF9C8C, 0xC3E07A, 0xFF7AC4};
  return {QColor::fromRgb((theme::isDark() ? kDark : kLight)[index % kMostReferences]), 1.6, Qt::DotLine};
}

LegendEntry ghostLook(const QString& name) { return {name, ghostPen(theme::mean())}; }

LegendEntry rangeLook(const QString& name) {
  QColor fill = theme::mean();
  fill.setAlpha(theme::isDark() ? 44 : 30);
  return {name, Qt::NoPen, fill};
}

LegendEntry deviationLook(const QString& name) { return {name, QPen(faded(theme::mean()), 1.2, Qt::DotLine)}; }

LegendEntry stepLook(const QString& name) {
  QPen pen(theme::errorInk(), 4);
  pen.setCapStyle(Qt::RoundCap);
  return {name, pen};
}

}  // namespace tactus::workbench
