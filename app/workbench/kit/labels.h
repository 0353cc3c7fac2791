// Labels: elided, wrapped, editable, fitted to their place.
#pragma once

#include <QFontMetricsF>
#include <QLabel>
#include <QLineEdit>
#include <QString>
#include <functional>

class QWidget;

namespace tactus::workbench {

// Sizes that follow from the font of a widget, also after the size of the text was changed while the program runs.

/// Calls `fit` now, and again whenever the font of `widget` has changed.
void keepFitted(QWidget& widget, std::function<void()> fit);

// Fits a name into a narrow place, on one or two lines.

/// `label` fitted into `width` px: on one line, or on two lines of nearly equal length. The break is at a space or
/// after a vowel (`Laryngo-`, `pharynx`). Text that is still too wide ends in an ellipsis.
QString brokenLabel(const QString& label, double width, const QFontMetricsF& metrics);

/// The width of the widest line after the break, px.
double brokenWidth(const QString& label, const QFontMetricsF& metrics);

/// A name that can be edited: while it is not, one that is too long ends in an ellipsis.
class ElidedEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit ElidedEdit(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Text on as many lines as it needs, in a place whose height the layout sets. With a QLabel the height of the whole
/// layout would depend on the width, and a scroll area could scroll although everything fits.
class WrappedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit WrappedLabel(QWidget* parent = nullptr);

  bool hasHeightForWidth() const override { return false; }
};

/// A line of text that becomes shorter or ends in an ellipsis if it does not fit. Its tool tip then has the whole text,
/// and what the text means.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// Shows `brief` if `text` does not fit. Without `brief` the end of `text` is cut.
  void setFullText(const QString& text, const QString& brief = {});
  /// Cuts the middle instead: the end says what matters.
  void keepEnd() { cut_ = Qt::ElideMiddle; }
  /// What the text means, below it in the tool tip.
  void setHint(const QString& hint);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString full_;
  QString brief_;
  QString hint_;
  Qt::TextElideMode cut_ = Qt::ElideRight;
};

}  // namespace tactus::workbench
