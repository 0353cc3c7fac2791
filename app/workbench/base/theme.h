// Colors, spacing and fonts of the workbench in one place.
#pragma once

#include <QColor>
#include <QFont>
#include <cstddef>

class QApplication;
class QSettings;

namespace tactus::workbench::theme {

inline constexpr int kGrid = 8;          ///< px; every distance is a multiple of this or of its half
inline constexpr int kCornerRadius = 8;  ///< px, of cards and banners

enum class Look { kLight, kDark };

/// The look that the user chose last; light before the first choice.
Look storedLook(const QSettings& settings);
void storeLook(QSettings& settings, Look look);

/// Whether the application has the dark look.
bool isDark();

QColor window();    ///< behind the cards
QColor card();      ///< cards and plots
QColor border();    ///< edges of cards
QColor grid();      ///< grid lines of plots
QColor ink();       ///< text
QColor mutedInk();  ///< secondary text, 4.5:1 on cards and window
QColor accent();    ///< focus, selection, markers
QColor warningInk();
QColor warningFill();
QColor errorInk();
QColor errorFill();

/// The line of the mean force.
QColor mean();

/// The force with friction, drawn beside the mean force.
QColor friction();

/// Line color of the expert with this number (figures::expertNumbers).
QColor expert(std::size_t number);

/// Color of term `index` of `count` of the force: the force's ramp.
QColor force(std::size_t index, std::size_t count);

/// `color`, changed as little as it needs for a contrast of 3 to a card: for lines and handles.
QColor readableLine(const QColor& color);
/// The same with 4.5, for small text.
QColor readableText(const QColor& color);

/// Black or white ink, whichever reads better on `fill`.
QColor inkOn(const QColor& fill);

QFont titleFont();    ///< name of the model
QFont headingFont();  ///< headings of cards and panels
QFont smallFont();    ///< notes, readouts, labels in plots

/// `color`, which has an alpha, blended onto a card.
QColor onCard(const QColor& color);

/// The color of the current look that corresponds to `color`. A theme color of the other look becomes its counterpart
/// with the same alpha. Every other color, also the white of light cards, stays unchanged.
QColor inLook(const QColor& color);

/// Sets the Fusion style with the theme's colors, the same on every desktop. Call at the start of the program.
void apply(QApplication& application, Look look = Look::kLight);
/// Changes the look at once, also the theme colors that widgets have stored. Plots follow on their own
/// (plot/plot_style.cpp).
void changeLook(QApplication& application, Look look);

}  // namespace tactus::workbench::theme
