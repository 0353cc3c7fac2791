// Procedure, language, text size and real sizes of the nurse's screens. Each widget of the screens asks it and follows
// `changed`.
#pragma once

#include <QColor>
#include <QFont>
#include <QLayout>
#include <QObject>
#include <QSize>
#include <array>
#include <memory>

#include "app/workbench/participant/kit/wordbook.h"

class QScreen;

namespace tactus::workbench::nurse::colors {

// The colors of the nurse's screens. Text on its ground has a contrast of at least 7:1; edges and focus at least 3:1.
// One light look: the screens stand alone, beside nothing else of the program.

inline constexpr QColor kGround(0xF3, 0xF5, 0xF7);
inline constexpr QColor kCard(0xFF, 0xFF, 0xFF);
inline constexpr QColor kInk(0x1F, 0x29, 0x33);       // 14.8:1 on cards, 13.5:1 on the ground
inline constexpr QColor kMutedInk(0x46, 0x52, 0x5E);  // 8.0:1, 7.3:1
inline constexpr QColor kEdge(0x7B, 0x87, 0x94);      // 3.7:1
inline constexpr QColor kLine(0xD9, 0xE0, 0xE6);      // between things, carries no meaning
inline constexpr QColor kAccent(0x08, 0x52, 0x85);    // white on it 8.2:1
inline constexpr QColor kAccentPressed(0x06, 0x3B, 0x60);
inline constexpr QColor kChosen(0xE3, 0xEE, 0xF7);    // ink on it 12.5:1
inline constexpr QColor kForceOff(0x9B, 0x1C, 0x1C);  // white on it 8.2:1
inline constexpr QColor kForceOffPressed(0x6E, 0x12, 0x12);
inline constexpr QColor kWaiting(0xE6, 0xEA, 0xEE);  // ground of a button that waits; ink on it 12:1

/// One hue from light to dark: neighbors differ by lightness for every kind of color vision.
inline constexpr std::array kStrength = {QColor(0xA9, 0xCC, 0xE6), QColor(0x7D, 0xB5, 0xD9), QColor(0x5E, 0x9F, 0xCB),
                                         QColor(0x20, 0x69, 0x9F), QColor(0x0B, 0x35, 0x58)};
}  // namespace tactus::workbench::nurse::colors

namespace tactus::workbench::nurse {

class Look : public QObject {
  Q_OBJECT

 public:
  explicit Look(QObject* parent = nullptr);

  /// What the screens are about: the default procedure before anybody says another, and its first form.
  const std::shared_ptr<const procedure::Procedure>& about() const { return about_; }
  const study::Form& form() const { return *form_; }
  /// `form`: an id; that of no form of the procedure is its first.
  void setAbout(std::shared_ptr<const procedure::Procedure> about, const QString& form = {});

  const Language& language() const { return language_; }
  void setLanguage(const Language& language);

  /// 100, 125 or 150.
  int textPercent() const { return text_percent_; }
  void setTextPercent(int percent);

  /// The real size of the screen, px per inch (clamped to 80..220: screens that state nonsense), and the window, px.
  void setScreen(double dots_per_inch, const QSize& window);
  void setScreen(const QScreen& screen);

  QString say(const Phrase& phrase) const { return words_.say(phrase, language_); }
  QString say(const Phrase& phrase, const Language& language) const { return words_.say(phrase, language); }
  bool knows(const QString& id) const { return words_.has(id); }

  /// Logical px of a length on the screen. A small window gets smaller things, so that each screen fits.
  int mm(double length) const;
  /// The height of a line of body text's letters: 22 pt on the screen, times the text size, as far as it fits.
  int textPx() const;
  /// Body text times `factor`.
  QFont font(double factor = 1, bool bold = false) const { return font(language_, factor, bold); }
  QFont font(const Language& language, double factor, bool bold) const;
  /// `steps` of the grid, 2 mm each.
  int gap(double steps) const { return mm(2 * steps); }

 signals:
  void changed();

 private:
  std::shared_ptr<const procedure::Procedure> about_ = procedure::defaultProcedure();
  const study::Form* form_ = &about_->forms.front();
  Wordbook words_{*about_};
  Language language_;
  int text_percent_ = 100;
  double dots_per_inch_ = 96;
  QSize window_{1280, 720};
};

// Distances in layouts of the nurse's screens, in steps of the grid, which follow the size of the screen.

/// `layout` gets no margins and `steps` of the grid between its items, now and after each change.
void keepSpacing(const Look& look, QLayout& layout, double steps);

}  // namespace tactus::workbench::nurse
