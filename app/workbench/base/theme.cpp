#include "app/workbench/base/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QSettings>
#include <QStyleOption>
#include <QTabWidget>
#include <QVariant>
#include <QWidget>
#include <algorithm>
#include <cstdint>

#include "app/figures/colors.h"

namespace tactus::workbench::appearance {
namespace {

constexpr auto kLookKey = "look";  // of theme::storeLook
constexpr auto kTextSizeKey = "text_size_percent";
// Properties of the application.
constexpr auto kSystemIsDark = "system_is_dark";
constexpr auto kTextPercent = "text_percent";

QFont times(QFont font, double factor) {
  font.setPointSizeF(font.pointSizeF() * factor);
  return font;
}

}  // namespace

std::optional<theme::Look> chosenLook(const QSettings& settings) {
  if (!settings.contains(QLatin1String(kLookKey))) return std::nullopt;
  return theme::storedLook(settings);
}

void chooseLook(QSettings& settings, std::optional<theme::Look> look) {
  if (look) {
    theme::storeLook(settings, *look);
  } else {
    settings.remove(QLatin1String(kLookKey));
  }
}

int chosenTextSize(const QSettings& settings) {
  const int percent = settings.value(QLatin1String(kTextSizeKey), 100).toInt();
  return std::find(kTextSizes.begin(), kTextSizes.end(), percent) == kTextSizes.end() ? 100 : percent;
}

void chooseTextSize(QSettings& settings, int percent) { settings.setValue(QLatin1String(kTextSizeKey), percent); }

void apply(QApplication& application, const QSettings& settings) {
  const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  application.setProperty(kSystemIsDark, dark);
  theme::apply(application, chosenLook(settings).value_or(systemLook(application)));
  changeTextSize(application, chosenTextSize(settings));
}

theme::Look systemLook(const QApplication& application) {
  return application.property(kSystemIsDark).toBool() ? theme::Look::kDark : theme::Look::kLight;
}

void followSystem(QApplication& application, const QSettings& settings, theme::Look look) {
  application.setProperty(kSystemIsDark, look == theme::Look::kDark);
  const bool shown = theme::isDark() == (look == theme::Look::kDark);
  if (!chosenLook(settings) && !shown) theme::changeLook(application, look);
}

int scaled(int px) {
  const QVariant percent = qApp->property(kTextPercent);
  return percent.isValid() ? qRound(px * percent.toDouble() / 100) : px;
}

void changeTextSize(QApplication& application, int percent) {
  const QVariant before = application.property(kTextPercent);
  const double factor = percent / (before.isValid() ? before.toDouble() : 100.0);
  application.setProperty(kTextPercent, percent);
  if (factor == 1) return;
  // Those first: a widget without a font of its own takes that of the application afterwards.
  for (QWidget* widget : QApplication::allWidgets()) {
    if (widget->testAttribute(Qt::WA_SetFont)) widget->setFont(times(widget->font(), factor));
  }
  QApplication::setFont(times(QApplication::font(), factor));
}
}  // namespace tactus::workbench::appearance

namespace tactus::workbench {

void setMuted(QWidget& label) {
  label.setFont(theme::smallFont());
  setInk(label, theme::mutedInk());
}
}  // namespace tactus::workbench

namespace tactus::workbench::theme {
namespace {

constexpr double kRound = 2;         // px, as in Fusion
constexpr int kBesideWords = kGrid;  // px, of a button

// Focus has a frame of its own, and what is disabled may be pale.
bool wantsEdge(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_Enabled) && !option.state.testFlag(QStyle::State_HasFocus);
}

void drawEdge(QPainter& painter, const QRectF& place, double round) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(fieldEdge(), 1));
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), round, round);
  painter.restore();
}

QString shortened(const QString& text, const QFontMetrics& metrics, int room) {
  return metrics.elidedText(text, Qt::ElideRight, room, Qt::TextShowMnemonic);
}

}  // namespace

QColor fieldEdge() { return isDark() ? QColor(0x7A, 0x86, 0x92) : QColor(0x7D, 0x88, 0x94); }

FieldStyle::FieldStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void FieldStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  // There is no line below tabs (kit/tab_look.h), so there is none below what stands beside them.
  if (element == PE_FrameTabBarBase && qobject_cast<const QTabWidget*>(widget) != nullptr) return;
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (!wantsEdge(*option)) return;
  if (element == PE_FrameLineEdit) drawEdge(*painter, option->rect, kRound);
  if (element == PE_IndicatorCheckBox) drawEdge(*painter, option->rect, 0);
  if (element == PE_IndicatorRadioButton) drawEdge(*painter, option->rect, option->rect.height() / 2.0);
}

void FieldStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  constexpr int kBesideIcon = 4;  // px, as in Fusion
  if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
      box != nullptr && element == CE_ComboBoxLabel) {
    QStyleOptionComboBox fitting = *box;
    int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - 2;
    if (!box->currentIcon.isNull()) room -= box->iconSize.width() + kBesideIcon;
    // An ampersand is none here.
    fitting.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
    QProxyStyle::drawControl(element, &fitting, painter, widget);
    return;
  }
  if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
      button != nullptr && element == CE_PushButtonLabel) {
    QStyleOptionButton fitting = *button;
    int room = button->rect.width();
    if (!button->icon.isNull()) room -= button->iconSize.width() + kBesideIcon;
    if (button->features.testFlag(QStyleOptionButton::HasMenu)) {
      room -= pixelMetric(PM_MenuButtonIndicator, button, widget);
    }
    fitting.text = shortened(button->text, button->fontMetrics, room);
    QProxyStyle::drawControl(element, &fitting, painter, widget);
    return;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void FieldStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (!wantsEdge(*option)) return;
  if (control == CC_ComboBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (box != nullptr && box->frame) drawEdge(*painter, option->rect, kRound);
  }
  if (control == CC_SpinBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    // Fusion leaves a line above and below.
    if (box != nullptr && box->frame) drawEdge(*painter, QRectF(option->rect).adjusted(0, 1, 0, -1), kRound);
  }
}

QSize FieldStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
  QSize out = QProxyStyle::sizeFromContents(type, option, size, widget);
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (type == CT_PushButton && button != nullptr && !button->text.isEmpty()) {
    out.setWidth(std::max(out.width(), size.width() + 2 * kBesideWords));
  }
  return out;
}

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
// The card with the band of a region and the range of the experts on it (plot/term_marks.cpp, curve_looks.cpp), where a
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
