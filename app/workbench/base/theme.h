// Colors, spacing and fonts of the workbench in one place.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QProxyStyle>
#include <QWidget>
#include <array>
#include <cstddef>
#include <optional>

class QApplication;
class QSettings;
class QWidget;

namespace tactus::workbench {

// Secondary text: small, in the muted ink of the theme.

/// Gives `label`, a widget that shows text, the font and color of secondary text.
void setMuted(QWidget& label);

// The color of a widget's text.

inline void setInk(QWidget& widget, const QColor& ink) {
  QPalette colors = widget.palette();
  colors.setColor(QPalette::WindowText, ink);
  widget.setPalette(colors);
}
}  // namespace tactus::workbench

namespace tactus::workbench::theme {

// The Fusion style with visible edges of fields. Fusion derives the edges from the color of the window, which gives a
// contrast of 1.3 to a card; 3 is wanted (WCAG 2.1, 1.4.11). Fusion cuts the words of a choice or a button that is too
// narrow; here they end in an ellipsis. Fusion leaves 3 px beside the words of a button; here it is as much as inside a
// card.

/// Edge of fields to type in, of choices, of check boxes and of round buttons: contrast at least 3 to cards, window and
/// buttons.
QColor fieldEdge();

class FieldStyle : public QProxyStyle {
  Q_OBJECT

 public:
  FieldStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
};

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

namespace tactus::workbench::appearance {

// What the user chose for the whole program: the look, and how large its text is.

inline constexpr std::array kTextSizes = {100, 125, 150};  ///< percent of the system's

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
