// The guide beside the program: its pages on the left, the page that is read on the right.
#pragma once

#include <QTextBrowser>
#include <QWidget>

class QListWidget;

namespace tactus::workbench {

/// Shows a page of the guide: pictures fit the column, links between pages stay here, others open in the web browser.
class GuideBrowser : public QTextBrowser {
  Q_OBJECT

 public:
  explicit GuideBrowser(QWidget* parent = nullptr);

  void showPage(const QUrl& url);

 signals:
  void pageShown(const QUrl& url);

 protected:
  QVariant loadResource(int type, const QUrl& url) override;

 private:
  void follow(const QUrl& link);
};

class GuideBrowser;

class GuideWindow : public QWidget {
  Q_OBJECT

 public:
  explicit GuideWindow(QWidget* parent = nullptr);

  /// Shows the window before others.
  void open();
  GuideBrowser& browser() { return *browser_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QListWidget* pages_;
  GuideBrowser* browser_;
};

}  // namespace tactus::workbench
