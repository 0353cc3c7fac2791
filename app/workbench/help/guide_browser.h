// Shows a page of the guide: pictures fit the column, links between pages stay here, others open in the web browser.
#pragma once

#include <QTextBrowser>

namespace tactus::workbench {

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

}  // namespace tactus::workbench
