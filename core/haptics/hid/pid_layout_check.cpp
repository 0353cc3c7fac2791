#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/haptics/hid/pid_layout.h"
#include "core/haptics/hid/pid_session.h"

namespace tactus::haptics {
namespace {

using Done = base::Result<void>;

constexpr double kDurationErrorS = 0.005;

std::string bitsOf(const ValueSlot& slot) {
  return std::to_string(slot.bit_size) + (slot.bit_size == 1 ? " bit" : " bits");
}

tl::unexpected<base::Error> lie(const std::string& what, std::string found, std::string wanted) {
  return base::fail(base::ErrorCode::kData, "report descriptor, " + what, std::move(found), std::move(wanted));
}

/// Goes over the values of a layout and keeps the first thing that cannot be.
class Checker {
 public:
  explicit Checker(const PidLayout& layout) : layout_(layout) {}

  Done check() {
    checkEffect();
    checkDuration();
    checkOtherReports();
    checkInputs();
    checkIds();
    return std::move(done_);
  }

 private:
  void range(const ValueSlot& slot, const std::string& what) {
    if (done_ && !rangeFits(slot))
      done_ = lie(what,
                  "a range from " + std::to_string(slot.logical_min) + " to " + std::to_string(slot.logical_max) +
                      " in " + bitsOf(slot),
                  "a range that fits into its bits");
  }
  void range(const std::optional<ValueSlot>& slot, const std::string& what) {
    if (slot) range(*slot, what);
  }
  /// A value that has to be able to change.
  void span(const ValueSlot& slot, const std::string& what) {
    range(slot, what);
    if (done_ && slot.logical_min >= slot.logical_max)
      done_ = lie(what, "a range from " + std::to_string(slot.logical_min) + " to " + std::to_string(slot.logical_max),
                  "a range of more than one value");
  }
  void choice(const PidChoice& choice, const std::string& what) {
    const std::int64_t most = (std::int64_t{1} << choice.slot.bit_size) - 1;
    if (done_ && (choice.value < 0 || choice.value > most))
      done_ = lie(what, "the number " + std::to_string(choice.value) + " in " + bitsOf(choice.slot),
                  "a number that fits into its bits");
  }
  void choice(const std::optional<PidChoice>& option, const std::string& what) {
    if (option) choice(*option, what);
  }

  void checkEffect() {
    const auto& effect = layout_.set_effect;
    range(effect.block, "block index in Set Effect");
    choice(effect.constant_force, "constant force among the effect types");
    if (effect.gain) span(*effect.gain, "gain in Set Effect");
    for (const ValueSlot& slot : effect.directions) span(slot, "direction in Set Effect");
    span(layout_.constant_force.magnitude, "magnitude in Set Constant Force");
    range(layout_.constant_force.block, "block index in Set Constant Force");
  }

  void checkDuration() {
    const std::string what = "duration in Set Effect";
    const ValueSlot& slot = layout_.set_effect.duration;
    span(slot, what);
    if (!done_) return;
    const auto step_s = stepOfTime(slot);
    if (!step_s) {
      done_ = lie(what, "a unit that is no time", "seconds, or no unit");
      return;
    }
    const double given_s = static_cast<double>(rawOfTime(slot, PidSession::kDurationS)) * *step_s;
    if (std::abs(given_s - PidSession::kDurationS) > kDurationErrorS)
      done_ = lie(what,
                  "steps of " + base::formatNumber(*step_s) + " s up to " + std::to_string(slot.logical_max) +
                      ", in which 0.09 s are " + base::formatNumber(given_s) + " s",
                  "0.09 s to 5 ms, because an effect without an end continues when the program dies");
  }

  void checkOtherReports() {
    range(layout_.operation.block, "block index in Effect Operation");
    choice(layout_.operation.start, "start in Effect Operation");
    choice(layout_.operation.stop, "stop in Effect Operation");
    range(layout_.operation.loop_count, "loop count in Effect Operation");
    choice(layout_.create.constant_force, "constant force in Create New Effect");
    range(layout_.block_load.block, "block index in PID Block Load");
    choice(layout_.block_load.success, "success in PID Block Load");
    choice(layout_.block_load.full, "full in PID Block Load");
    choice(layout_.block_load.error, "error in PID Block Load");
    if (layout_.block_free) range(layout_.block_free->block, "block index in PID Block Free");
    if (layout_.gain) span(layout_.gain->gain, "gain in Device Gain");
    if (layout_.control) {
      choice(layout_.control->enable, "actuators on in Device Control");
      choice(layout_.control->disable, "actuators off in Device Control");
      choice(layout_.control->stop_all, "stop all in Device Control");
      choice(layout_.control->reset, "reset in Device Control");
    }
  }

  void checkInputs() {
    constexpr const char* kAxes[] = {"position axis X", "position axis Y", "position axis Z"};
    for (std::size_t axis = 0; axis < layout_.axes.size(); ++axis)
      if (layout_.axes[axis]) span(layout_.axes[axis]->slot, kAxes[axis]);
  }

  /// Two reports of one direction under one id are one report, and what is written for the one is written into the
  /// other.
  void checkIds() {
    std::vector<std::pair<std::string, PidReport>> out = {{"Set Effect", layout_.set_effect.report},
                                                          {"Set Constant Force", layout_.constant_force.report},
                                                          {"Effect Operation", layout_.operation.report}};
    if (layout_.control) out.emplace_back("Device Control", layout_.control->report);
    if (layout_.gain) out.emplace_back("Device Gain", layout_.gain->report);
    if (layout_.block_free) out.emplace_back("PID Block Free", layout_.block_free->report);
    std::vector<std::pair<std::string, PidReport>> feature = {{"Create New Effect", layout_.create.report},
                                                              {"PID Block Load", layout_.block_load.report}};
    if (layout_.pool) feature.emplace_back("PID Pool", *layout_.pool);
    for (const auto* reports : {&out, &feature})
      for (std::size_t i = 0; i < reports->size(); ++i)
        for (std::size_t j = i + 1; j < reports->size(); ++j) different((*reports)[i], (*reports)[j]);
  }

  void different(const std::pair<std::string, PidReport>& one, const std::pair<std::string, PidReport>& other) {
    if (done_ && one.second.id == other.second.id)
      done_ = lie(one.first + " and " + other.first, "the same report id " + std::to_string(one.second.id),
                  "an id for each");
  }

  const PidLayout& layout_;
  Done done_;
};

}  // namespace

Done checkLayout(const PidLayout& layout) { return Checker(layout).check(); }

}  // namespace tactus::haptics
