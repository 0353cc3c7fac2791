#include "app/workbench/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <algorithm>
#include <array>
#include <cmath>

namespace tactus::workbench::theme {
namespace {

QColor mixed(const QColor& from, const QColor& to, double share) {
  const auto mix = [share](int low, int high) { return static_cast<int>(std::lround(low + (high - low) * share)); };
  return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue())};
}

QFont scaled(double points, QFont::Weight weight) {
  QFont font = QApplication::font();
  font.setPointSizeF(font.pointSizeF() + points);
  font.setWeight(weight);
  return font;
}

}  // namespace

QColor window() { return {0xF3, 0xF5, 0xF7}; }
QColor card() { return Qt::white; }
QColor border() { return {0xD9, 0xE0, 0xE6}; }
QColor grid() { return {0xE8, 0xEC, 0xF0}; }
QColor ink() { return {0x1F, 0x29, 0x33}; }
QColor mutedInk() { return {0x52, 0x60, 0x6D}; }
QColor accent() { return {0x0B, 0x65, 0x9E}; }
QColor warningInk() { return {0x7A, 0x4B, 0x00}; }
QColor warningFill() { return {0xFF, 0xF1, 0xD0}; }
QColor errorInk() { return {0x9B, 0x1C, 0x1C}; }
QColor errorFill() { return {0xFD, 0xEC, 0xEA}; }
QColor mean() { return {0x2B, 0x35, 0x40}; }

QColor expert(std::size_t index) {
  static constexpr std::array<QColor, 6> kColors = {QColor(0x00, 0x72, 0xB2), QColor(0xD5, 0x5E, 0x00),
                                                    QColor(0x00, 0x9E, 0x73), QColor(0xCC, 0x79, 0xA7),
                                                    QColor(0xE6, 0x9F, 0x00), QColor(0x56, 0xB4, 0xE9)};
  return kColors[index % kColors.size()];
}

QColor term(std::size_t index, std::size_t count) {
  static constexpr std::array<QColor, 4> kRamp = {QColor(0x2C, 0x3E, 0x8C), QColor(0x1F, 0x7A, 0xA8),
                                                  QColor(0x35, 0xA8, 0x8A), QColor(0xE9, 0xA8, 0x20)};
  if (count < 2) return kRamp[1];
  const double place = static_cast<double>(index) / static_cast<double>(count - 1) * (kRamp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  return mixed(kRamp[below], kRamp[below + 1], place - static_cast<double>(below));
}

QColor termText(std::size_t index, std::size_t count) { return mixed(term(index, count), ink(), 0.5); }

QFont titleFont() { return scaled(3, QFont::DemiBold); }
QFont headingFont() { return scaled(0, QFont::DemiBold); }
QFont smallFont() { return scaled(-1, QFont::Normal); }

void apply(QApplication& application) {
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QFont font = QApplication::font();
  if (font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  QApplication::setFont(font);

  QPalette palette;
  palette.setColor(QPalette::Window, window());
  palette.setColor(QPalette::WindowText, ink());
  palette.setColor(QPalette::Base, card());
  palette.setColor(QPalette::AlternateBase, window());
  palette.setColor(QPalette::Text, ink());
  palette.setColor(QPalette::PlaceholderText, mutedInk());
  palette.setColor(QPalette::Button, QColor(0xFB, 0xFC, 0xFD));
  palette.setColor(QPalette::ButtonText, ink());
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Highlight, accent());
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, ink());
  palette.setColor(QPalette::ToolTipText, Qt::white);
  palette.setColor(QPalette::Link, accent());
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(0x9A, 0xA5, 0xB1));
  }
  application.setPalette(palette);
}

}  // namespace tactus::workbench::theme
