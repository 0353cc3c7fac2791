// Language, text size and real sizes of the nurse's screens. Each widget of the screens asks it and follows `changed`.
#pragma once

#include <QFont>
#include <QObject>
#include <QSize>

#include "app/workbench/participant/kit/wordbook.h"

class QScreen;

namespace tactus::workbench::nurse {

class Look : public QObject {
  Q_OBJECT

 public:
  explicit Look(QObject* parent = nullptr);

  Language language() const { return language_; }
  void setLanguage(Language language);

  /// 100, 125 or 150.
  int textPercent() const { return text_percent_; }
  void setTextPercent(int percent);

  /// The real size of the screen, px per inch (clamped to 80..220: screens that state nonsense), and the window, px.
  void setScreen(double dots_per_inch, const QSize& window);
  void setScreen(const QScreen& screen);

  QString say(const Phrase& phrase) const { return words_.say(phrase, language_); }
  QString say(const Phrase& phrase, Language language) const { return words_.say(phrase, language); }

  /// Logical px of a length on the screen. A small window gets smaller things, so that each screen fits.
  int mm(double length) const;
  /// The height of a line of body text's letters: 22 pt on the screen, times the text size, as far as it fits.
  int textPx() const;
  /// Body text times `factor`.
  QFont font(double factor = 1, bool bold = false) const { return font(language_, factor, bold); }
  QFont font(Language language, double factor, bool bold) const;
  /// `steps` of the grid, 2 mm each.
  int gap(double steps) const { return mm(2 * steps); }

 signals:
  void changed();

 private:
  Wordbook words_;
  Language language_ = Language::kEnglish;
  int text_percent_ = 100;
  double dots_per_inch_ = 96;
  QSize window_{1280, 720};
};

}  // namespace tactus::workbench::nurse
