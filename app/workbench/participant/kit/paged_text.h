// A long text as pages: what does not fit goes to the next page, nothing scrolls.
#pragma once

#include <QStringList>
#include <QWidget>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

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

}  // namespace tactus::workbench::nurse
