// Cards, forms below a button, headings of menus, a highlight that fades.
#pragma once

#include <QColor>
#include <QFrame>
#include <QMenu>
#include <QVariantAnimation>
#include <optional>

class QFormLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace tactus::workbench {

/// A highlight that fades away: shows where something was pointed at.
class Flash : public QObject {
  Q_OBJECT

 public:
  /// Repaints `widget` while the highlight fades. Owned by it.
  explicit Flash(QWidget* widget);

  /// Begins the highlight anew.
  void start();
  /// 1 at the beginning, 0 at the end and afterwards.
  double strength() const { return strength_; }

 private:
  QVariantAnimation fading_;
  double strength_ = 0;
};

// A line at the top of a menu that says what it is about.

/// Adds `text` above the entries that follow. The menu is as wide as it: Qt cuts the text of a section to the entries.
void addMenuHeading(QMenu& menu, const QString& text);

/// A small form below a button for one or two values. Escape or a click outside closes it.
class PopupForm : public QFrame {
  Q_OBJECT

 public:
  PopupForm(const QString& title, const QString& accept, QWidget* parent);

  void addField(const QString& label, QWidget* field);
  /// A sentence above the fields.
  void setNote(const QString& sentence);
  /// Shows the form below `anchor`, or above it if the space below is too small. The form is deleted when it closes.
  void openAt(const QWidget& anchor);

 signals:
  void accepted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QLabel* note_;
  QFormLayout* fields_;
  QPushButton* accept_;
};

/// A panel with round corners: the background of all content on the screen.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  /// A theme color follows a change of the look.
  void setColors(const QColor& fill, const QColor& edge);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<QColor> fill_;  ///< nothing: the theme's card color
  std::optional<QColor> edge_;
};

}  // namespace tactus::workbench
