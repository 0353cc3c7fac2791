// Consent: what she agrees to, as pages. Without consent there is no session.
#pragma once

#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

class ConsentScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ConsentScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 signals:
  void declined();

 protected:
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return text_->page() > 0; }

 private:
  void showPage();

  PagedText* text_;
};

}  // namespace tactus::workbench::nurse
