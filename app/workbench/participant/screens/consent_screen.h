// Consent: what she agrees to, as pages. Without consent there is no session.
#pragma once

#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

struct ConsentState {
  std::vector<Phrase> paragraphs;
  bool simulated = false;
};

class ConsentScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ConsentScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ConsentState& state);

  void setMayGoBack(bool may) override;

 signals:
  void agreed();
  void declined();
  void left();  ///< Back from the first page

 private:
  void showPage();

  PagedText* text_;
  bool may_leave_ = true;  ///< Back from the first page
};

}  // namespace tactus::workbench::nurse
