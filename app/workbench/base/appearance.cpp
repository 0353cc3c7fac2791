#include "app/workbench/base/appearance.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>
#include <QVariant>
#include <QWidget>
#include <algorithm>

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
