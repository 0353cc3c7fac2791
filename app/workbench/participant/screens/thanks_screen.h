// Thank you, with her own force along the way of the tube, to print. No comparison with others.
#pragma once

#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/force_curve.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

struct ThanksState {
  std::vector<QPointF> curve;  ///< depth mm, share of the largest force; empty: no curve yet
  bool may_print = true;
  bool simulated = false;
};

class ThanksScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ThanksScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ThanksState& state);
  const ForceCurve& curve() const { return *curve_; }

 signals:
  void print();
  void done();

 private:
  Label* curve_title_;
  ForceCurve* curve_;
  Button* print_;
};

}  // namespace tactus::workbench::nurse
