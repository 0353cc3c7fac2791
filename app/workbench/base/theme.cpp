#include "app/workbench/base/theme.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>
#include <QWidget>
#include <cstdint>

#include "app/figures/colors.h"
#include "app/workbench/base/field_style.h"

namespace tactus::workbench::theme {
namespace {

figures::Rgb of(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue())};
}

QColor of(const figures::Rgb& color) { return {color.red, color.green, color.blue}; }

constexpr auto kLookKey = "look";
constexpr auto kDark = "dark";

/// A color in both looks.
struct Pair {
  QRgb light;
  QRgb dark;
};
constexpr Pair kWindow{0xFFF3F5F7, 0xFF15191E};
constexpr Pair kCard{0xFFFFFFFF, 0xFF1E242B};
constexpr Pair kBorder{0xFFD9E0E6, 0xFF39434D};
constexpr Pair kGridLine{0xFFE8ECF0, 0xFF2B333B};
constexpr Pair kInk{0xFF1F2933, 0xFFE4E9EE};
constexpr Pair kMutedInk{0xFF52606D, 0xFFA2AEBA};
constexpr Pair kAccent{0xFF0B659E, 0xFF2F87C4};
constexpr Pair kWarningInk{0xFF7A4B00, 0xFFFFCC66};
constexpr Pair kWarningFill{0xFFFFF1D0, 0xFF42340F};
constexpr Pair kErrorInk{0xFF9B1C1C, 0xFFFF9A94};
constexpr Pair kErrorFill{0xFFFDECEA, 0xFF4A1F1E};
constexpr Pair kMean{0xFF2B3540, 0xFFF2F5F8};
constexpr Pair kFriction{0xFF7B3FA0, 0xFFC79BEA};
// The card with the band of a region and the range of the experts on it (plot/term_bands.cpp, curve_looks.cpp), where a
// line of an expert stands out least.
constexpr Pair kCurveGround{0xFFE2DADF, 0xFF3D4443};

QColor pick(const Pair& pair) { return QColor::fromRgb(isDark() ? pair.dark : pair.light); }
QColor pick(QRgb light, QRgb dark) { return QColor::fromRgb(isDark() ? dark : light); }

/// The color of an expert where its line is seen on the curves of each look.
Pair expertPair(std::size_t number) {
  const figures::Rgb color = figures::expertColor(number);
  const auto seen = [&color](QRgb ground, QRgb ink) {
    return of(figures::readable(color, of(QColor::fromRgb(ground)), of(QColor::fromRgb(ink)), 3)).rgb();
  };
  return {seen(kCurveGround.light, kInk.light), seen(kCurveGround.dark, kInk.dark)};
}

void setPalette(QApplication& application, Look look) {
  // The colors below are those of the look that the palette of the application has.
  QPalette palette;
  palette.setColor(QPalette::Window, look == Look::kDark ? Qt::black : Qt::white);
  application.setPalette(palette);
  palette.setColor(QPalette::Window, window());
  palette.setColor(QPalette::WindowText, ink());
  palette.setColor(QPalette::Base, card());
  palette.setColor(QPalette::AlternateBase, window());
  palette.setColor(QPalette::Text, ink());
  palette.setColor(QPalette::PlaceholderText, mutedInk());
  palette.setColor(QPalette::Button, pick(0xFBFCFD, 0x2A323A));
  palette.setColor(QPalette::ButtonText, ink());
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Highlight, pick(0x0B659E, 0x1F6F9F));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, pick(0x1F2933, 0x39434D));
  palette.setColor(QPalette::ToolTipText, Qt::white);
  palette.setColor(QPalette::Link, accent());
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, pick(0x65717E, 0x929EAA));
  }
  application.setPalette(palette);
}

// Colors that the widget set itself.
void takeLook(QWidget& widget) {
  QPalette colors = widget.palette();
  for (int g = 0; g < QPalette::NColorGroups; ++g) {
    for (int r = 0; r < QPalette::NColorRoles; ++r) {
      const auto group = static_cast<QPalette::ColorGroup>(g);
      const auto role = static_cast<QPalette::ColorRole>(r);
      if (!colors.isBrushSet(group, role)) continue;
      const QColor color = colors.color(group, role);
      if (const QColor now = inLook(color); now != color) colors.setColor(group, role, now);
    }
  }
  widget.setPalette(colors);
}

QFont scaled(double points, QFont::Weight weight) {
  QFont font = QApplication::font();
  font.setPointSizeF(font.pointSizeF() + points);
  font.setWeight(weight);
  return font;
}

}  // namespace

Look storedLook(const QSettings& settings) {
  return settings.value(QLatin1String(kLookKey)).toString() == QLatin1String(kDark) ? Look::kDark : Look::kLight;
}

void storeLook(QSettings& settings, Look look) {
  settings.setValue(QLatin1String(kLookKey), QLatin1String(look == Look::kDark ? kDark : "light"));
}

bool isDark() { return QApplication::palette().color(QPalette::Window).lightness() < 128; }

QColor window() { return pick(kWindow); }
QColor card() { return pick(kCard); }
QColor border() { return pick(kBorder); }
QColor grid() { return pick(kGridLine); }
QColor ink() { return pick(kInk); }
QColor mutedInk() { return pick(kMutedInk); }
QColor accent() { return pick(kAccent); }
QColor warningInk() { return pick(kWarningInk); }
QColor warningFill() { return pick(kWarningFill); }
QColor errorInk() { return pick(kErrorInk); }
QColor errorFill() { return pick(kErrorFill); }
QColor mean() { return pick(kMean); }
QColor friction() { return pick(kFriction); }

QColor inLook(const QColor& color) {
  const bool dark = isDark();
  for (const Pair& pair :
       {kWindow, kBorder, kGridLine, kInk, kMutedInk, kAccent, kWarningInk, kWarningFill, kErrorInk, kErrorFill, kMean,
        kFriction, expertPair(0), expertPair(1), expertPair(2), expertPair(3), expertPair(4), expertPair(5)}) {
    if ((color.rgb() | 0xFF000000U) != (dark ? pair.light : pair.dark)) continue;
    QColor now = QColor::fromRgb(dark ? pair.dark : pair.light);
    now.setAlphaF(color.alphaF());
    return now;
  }
  return color;
}

QColor onCard(const QColor& color) { return of(figures::mixed(of(card()), of(color), color.alphaF())); }

QColor expert(std::size_t number) { return pick(expertPair(number)); }

QColor force(std::size_t index, std::size_t count) {
  return of(figures::forceRamp(count < 2 ? 0 : static_cast<double>(index) / static_cast<double>(count - 1)));
}

QColor readableLine(const QColor& color) { return of(figures::readable(of(color), of(card()), of(ink()), 3)); }

QColor readableText(const QColor& color) { return of(figures::readable(of(color), of(card()), of(ink()), 4.5)); }

QColor inkOn(const QColor& fill) {
  const QColor dark(0x14, 0x1C, 0x24);
  const auto contrast = [&](const QColor& ink) { return figures::contrast(of(ink), of(fill)); };
  return contrast(Qt::white) >= contrast(dark) ? QColor(Qt::white) : dark;
}

QFont titleFont() { return scaled(3, QFont::DemiBold); }
QFont headingFont() { return scaled(0, QFont::DemiBold); }
QFont smallFont() { return scaled(-1, QFont::Normal); }

void apply(QApplication& application, Look look) {
  QApplication::setStyle(new FieldStyle);
  QFont font = QApplication::font();
  if (font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  QApplication::setFont(font);

  setPalette(application, look);
}

void changeLook(QApplication& application, Look look) {
  setPalette(application, look);
  for (QWidget* widget : QApplication::allWidgets()) {
    if (widget->testAttribute(Qt::WA_SetPalette)) takeLook(*widget);
    widget->update();
  }
}

}  // namespace tactus::workbench::theme
