// The words of the questions, before the questions: what is asked, and the levels of each condition as pictures.
#pragma once

#include <QStackedWidget>

#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

class GlossaryScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit GlossaryScreen(const Look& look, QWidget* parent = nullptr);

  int pages() const { return pages_->count(); }
  void setPage(int page);

  void setMayGoBack(bool may) override;

 signals:
  void finished();
  void left();  ///< Back from the first page

 private:
  QStackedWidget* pages_;
  bool may_leave_ = true;  ///< Back from the first page
};

}  // namespace tactus::workbench::nurse
