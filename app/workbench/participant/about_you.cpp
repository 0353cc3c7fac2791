#include "app/workbench/participant/about_you.h"

#include <algorithm>
#include <span>
#include <string>

namespace tactus::workbench {
namespace {

using Question = AboutYouState::Question;

constexpr auto kNotSay = "not_say";

/// An answer, and what the profile holds of it.
struct Offer {
  const char* id;
  const char* stored;
};

constexpr Offer kYears[] = {
    {"years_1", ""}, {"years_2", ""}, {"years_3", ""}, {"years_4", ""}};  // the session knows them
constexpr Offer kHands[] = {{"left", "left"}, {"right", "right"}, {"both", "both"}};
constexpr Offer kGloves[] = {{"yes", "yes"}, {"no", "none"}};
constexpr Offer kHaptic[] = {{"haptic_0", "none"}, {"haptic_1", "some"}, {"haptic_2", "regular"}};
constexpr Offer kComfort[] = {{"yes", "good"}, {"no", "not_good"}};

std::span<const Offer> offersOf(Question question) {
  switch (question) {
    case Question::kYears:
      return kYears;
    case Question::kHand:
      return kHands;
    case Question::kGloves:
      return kGloves;
    case Question::kHaptic:
      return kHaptic;
    case Question::kComfort:
      return kComfort;
  }
  return {};
}

// Empty if she did not say.
std::string stored(Question question, const QString& chosen) {
  for (const Offer& offer : offersOf(question)) {
    if (chosen == QLatin1String(offer.id)) return offer.stored;
  }
  return {};
}

}  // namespace

AboutYouState AboutYou::state() const { return {static_cast<Question>(at_), chosen_[at_], isFirst()}; }

void AboutYou::choose(const QString& id) {
  const auto offers = offersOf(static_cast<Question>(at_));
  const auto is_it = [&](const Offer& offer) { return id == QLatin1String(offer.id); };
  if (id == QLatin1String(kNotSay) || std::any_of(offers.begin(), offers.end(), is_it)) chosen_[at_] = id;
}

void AboutYou::next() {
  if (isAnswered() && !isLast()) ++at_;
}

void AboutYou::back() {
  if (!isFirst()) --at_;
}

study::ProfileRecord AboutYou::profile() const {
  const auto answer = [this](Question question) {
    return stored(question, chosen_[static_cast<std::size_t>(question)]);
  };
  study::ProfileRecord out;
  out.handedness = answer(Question::kHand);
  out.gloves = answer(Question::kGloves);
  out.haptic_experience = answer(Question::kHaptic);
  out.comfort = answer(Question::kComfort);
  return out;
}

std::optional<session::ExperienceBand> AboutYou::experience() const {
  return session::experienceBandCalled(chosen_[static_cast<std::size_t>(Question::kYears)].toStdString());
}

bool AboutYou::isLeftHanded() const {
  return chosen_[static_cast<std::size_t>(Question::kHand)] == QLatin1String("left");
}

}  // namespace tactus::workbench
