// The record of one tick of the servo, for plots, recordings and the flight recorder.
#pragma once

#include <cstdint>

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/sources/force_source.h"
#include "core/render/renderer_state.h"

namespace tactus::haptics {

struct Sample {
  std::uint64_t tick = 0;        ///< from 1
  std::int64_t time_ns = 0;      ///< of the tick, monotonic
  std::int64_t read_age_ns = 0;  ///< age of the device's sample
  std::uint64_t orders = 0;      ///< number of the orders in effect, as returned by `post`
  double position_mm = 0;        ///< along the insertion axis
  double speed_mm_s = 0;         ///< of the hand, filtered
  double depth_mm = 0;           ///< of the tube (insertion)
  double slip_speed_mm_s = 0;    ///< of the tube, filtered
  double stretch_mm = 0;         ///< lead of the hand over the tube
  double model_force_n = 0;      ///< fuzzy force F_d in use; 0 while released
  double source_force_n = 0;     ///< resistance requested by the source
  double force_n = 0;  ///< resistance after all limits; the force on the hand is its negative, divided by `scale`
  double scale = 1;    ///< ServoOrders::scale
  double stiffness_n_mm = 0;  ///< as rendered
  double since_full_s = 0;    ///< time since the stimulus reached its full force, until the answer; 0: not yet
  std::uint32_t stroke = 0;   ///< from 1 within a placement; 0: none yet
  std::uint32_t buttons = 0;  ///< of the device
  std::uint32_t limited = 0;  ///< LimitBit
  ForceSource source = ForceSource::kOff;
  StimulusPhase stimulus = StimulusPhase::kWaiting;
  render::Phase phase = render::Phase::kReleased;
  TripCause trip = TripCause::kNone;
  bool enabled = false;  ///< the hand holds the device, debounced
  bool held = false;     ///< no rule fires, so the last force is held
};

}  // namespace tactus::haptics
