// Colors, spacing and fonts of the workbench in one place.
#pragma once

#include <QColor>
#include <QFont>
#include <cstddef>

class QApplication;
class QSettings;

namespace tactus::workbench::theme {

inline constexpr int kGrid = 8;          ///< px; every distance is a multiple of it or half of it
inline constexpr int kCornerRadius = 8;  ///< px, of cards and banners

enum class Look { kLight, kDark };

/// The look that was chosen last; light before somebody chose.
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

/// The line of the mean.
QColor mean();

/// The force of the friction, where it stands beside that of the mean.
QColor friction();

/// Line of expert `index`: Okabe and Ito's colors (2008), told apart with any kind of color vision; they repeat after
/// six.
QColor expert(std::size_t index);

/// Color of term `index` of `count`: a ramp from dark blue to amber that rises in lightness, so that the order of the
/// terms survives any kind of color vision and a print in gray.
QColor term(std::size_t index, std::size_t count);
/// The same color, with enough contrast for small text on a card.
QColor termText(std::size_t index, std::size_t count);

/// Black or white ink, whichever reads better on `fill`.
QColor inkOn(const QColor& fill);

QFont titleFont();    ///< name of the model
QFont headingFont();  ///< heads of cards and panels
QFont smallFont();    ///< notes, readouts, labels in plots

/// What a color with an alpha looks like on a card.
QColor onCard(const QColor& color);

/// The color of the present look that `color` stands for: what was taken from the functions above in the other look
/// gets its counterpart, with its alpha; everything else, also the white of light cards, stays as it is.
QColor inLook(const QColor& color);

/// The calm look on the Fusion style, the same on every desktop. At the start of the program.
void apply(QApplication& application, Look look = Look::kLight);
/// Another look at once: colors that widgets took from here are exchanged too. Plots follow by themselves
/// (plot/plot_look.h).
void changeLook(QApplication& application, Look look);

}  // namespace tactus::workbench::theme
