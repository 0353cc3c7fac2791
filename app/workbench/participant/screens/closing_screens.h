// A rest, the end of a session, and the thanks.
#pragma once

#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/force_curve.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

/// Thank you, with her own force along the way of the tube, to print. No comparison with others.
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

/// The end before the end: stopped for today, withdrawn, or no consent; also what keeps her from going on.
enum class StopReason { kForToday, kWithdrawn, kNoConsent, kPaused, kNotSaved, kDeviceLost };

struct StoppedState {
  StopReason reason = StopReason::kForToday;
  QString code;
  bool may_go_on = false;
  bool simulated = false;
};

class StoppedScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit StoppedScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const StoppedState& state);

 private:
  TextBlock* texts_;
  Label* lead_;
};

/// A rest: the force is off, there is no countdown, she continues whenever she likes.
class RestScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit RestScreen(const Look& look, QWidget* parent = nullptr);

 private:
  TextBlock* texts_;
};

}  // namespace tactus::workbench::nurse
