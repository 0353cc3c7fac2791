// Text of the nurse's screens: follows language and text size by itself, takes as many lines as it needs, is never cut.
#pragma once

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

/// A long text as pages: what does not fit goes to the next page, nothing scrolls.
class PagedText : public QWidget {
  Q_OBJECT

 public:
  explicit PagedText(const Look& look, QWidget* parent = nullptr);

  void setParagraphs(std::vector<Phrase> paragraphs);
  int pages() const { return static_cast<int>(pages_.size()); }
  int page() const { return page_; }
  void setPage(int page);

 signals:
  /// The pages, or the page that is shown, are others.
  void paged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Line {
    QString text;
    double y = 0;
  };
  void paginate();

  const Look& look_;
  std::vector<Phrase> paragraphs_;
  std::vector<std::vector<Line>> pages_;
  int page_ = 0;
};

enum class TextRole {
  kBody,
  kLead,   ///< the one sentence of the screen: larger and bold
  kTitle,  ///< where she is: bold, muted
  kMuted,
};

class Label : public QLabel {
  Q_OBJECT

 public:
  Label(const Look& look, TextRole role, QWidget* parent = nullptr);
  Label(const Look& look, TextRole role, const Phrase& text, QWidget* parent = nullptr);

  void setPhrase(const Phrase& text);

 private:
  void refreshState();

  const Look& look_;
  TextRole role_;
  Phrase text_;
};

// Texts of a screen, one below the other: the one sentence in large letters, what belongs to it below.

class TextBlock : public QWidget {
  Q_OBJECT

 public:
  explicit TextBlock(const Look& look, QWidget* parent = nullptr);

  Label* add(TextRole role, const Phrase& text = {});
  void add(QWidget* widget, Qt::Alignment alignment = {});
  /// The texts stand in the middle of the height instead of at the top. Call last.
  void center();

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return layout_->heightForWidth(width); }

 private:
  const Look& look_;
  QVBoxLayout* layout_;
};

/// Shows `label` with `text`, or hides it if there is none.
void showOrHide(Label& label, const Phrase& text);

}  // namespace tactus::workbench::nurse
