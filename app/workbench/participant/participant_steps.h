// The steps of the nurse's course, one for each screen: what it shows, which answers it takes, and what is stored.
// Private to ParticipantController.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>

#include "app/workbench/participant/participant_controller.h"

namespace tactus::workbench {

class ParticipantController::Step {
 public:
  explicit Step(ParticipantController& course) : course_(course) {}
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
  virtual ~Step() = default;

  /// What is measured of the hand is dropped: something else is asked, or the force is off.
  virtual void close() {}
  /// Begins the force that the screen asks about. False: it gives none now.
  virtual bool beginsForce() { return false; }
  /// Another question is asked on the screen, or the same once more.
  virtual void ask() {}
  /// What tells two questions of the screen apart, besides the step of the session.
  virtual std::string question() const { return {}; }
  /// Fills in what the screen shows. Before: `can_go_on` is true, `can_go_back` false.
  virtual void show(ParticipantState& /*state*/) {}

  /// A card. Ignores what is none.
  virtual void choose(const QString& /*id*/) {}
  /// The primary button, while it acts.
  virtual void next() {}
  virtual void back() {}
  /// The samples of the device, oldest first; not while an overlay is open.
  virtual void sampled(std::span<const haptics::Sample> /*samples*/) {}
  /// The button of the device.
  virtual void pressed(ButtonPress /*press*/) {}

 protected:
  ParticipantController& course_;
};

}  // namespace tactus::workbench
