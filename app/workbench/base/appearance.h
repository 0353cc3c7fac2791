// What the user chose for the whole program: the look, and how large its text is.
#pragma once

#include <array>
#include <optional>

#include "app/workbench/base/theme.h"

namespace tactus::workbench::appearance {

inline constexpr std::array kTextSizes = {90, 100, 110, 125, 150};  ///< percent of the system's

/// The look that the user chose; nothing: that of the system.
std::optional<theme::Look> chosenLook(const QSettings& settings);
void chooseLook(QSettings& settings, std::optional<theme::Look> look);

/// One of kTextSizes; 100 before the first choice.
int chosenTextSize(const QSettings& settings);
void chooseTextSize(QSettings& settings, int percent);

/// theme::apply with what was chosen. Call at the start of the program, once.
void apply(QApplication& application, const QSettings& settings);
/// The look of the system: that at the start of the program, or what `followSystem` was told since.
theme::Look systemLook(const QApplication& application);
/// The system has another look now: takes it, unless the user chose one.
void followSystem(QApplication& application, const QSettings& settings, theme::Look look);
/// A width or height that text of 100 % needs, with the text as large as it is now, px.
int scaled(int px);
/// All texts at once, also those of widgets with a font of their own.
void changeTextSize(QApplication& application, int percent);

}  // namespace tactus::workbench::appearance
