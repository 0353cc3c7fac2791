#include "app/session/profile_questions.h"

#include <algorithm>
#include <array>

namespace tactus::session {
namespace {

constexpr std::array kYearsOffers = {
    ProfileOffer{"years_1", "you.years_1", "years_1"}, ProfileOffer{"years_2", "you.years_2", "years_2"},
    ProfileOffer{"years_3", "you.years_3", "years_3"}, ProfileOffer{"years_4", "you.years_4", "years_4"}};
constexpr std::array kHandsOffers = {ProfileOffer{"left", "you.hand_left", "left"},
                                     ProfileOffer{"right", "you.hand_right", "right"},
                                     ProfileOffer{"both", "you.hand_both", "both"}};
constexpr std::array kGlovesOffers = {ProfileOffer{"yes", "you.yes", "yes"}, ProfileOffer{"no", "you.no", "none"}};
constexpr std::array kHapticOffers = {ProfileOffer{"haptic_0", "you.haptic_0", "none"},
                                      ProfileOffer{"haptic_1", "you.haptic_1", "some"},
                                      ProfileOffer{"haptic_2", "you.haptic_2", "regular"}};
constexpr std::array kComfortOffers = {ProfileOffer{"yes", "you.yes", "good"},
                                       ProfileOffer{"no", "you.no", "not_good"}};

constexpr std::array kProfileQuestions = {ProfileQuestion{"years", "you.years", kYearsOffers, true},
                                          ProfileQuestion{"handedness", "you.hand", kHandsOffers, false},
                                          ProfileQuestion{"gloves", "you.gloves", kGlovesOffers, true},
                                          ProfileQuestion{"haptic_experience", "you.haptic", kHapticOffers, true},
                                          ProfileQuestion{"comfort", "you.comfort", kComfortOffers, true}};

}  // namespace

std::span<const ProfileQuestion> profileQuestions() { return kProfileQuestions; }

const ProfileQuestion* profileQuestion(std::string_view field) {
  const auto* const found = std::find_if(kProfileQuestions.begin(), kProfileQuestions.end(),
                                         [&](const ProfileQuestion& question) { return question.field == field; });
  return found == kProfileQuestions.end() ? nullptr : found;
}

std::string_view storedAnswer(const ProfileQuestion& question, std::string_view id) {
  for (const ProfileOffer& offer : question.offers) {
    if (offer.id == id) return offer.stored;
  }
  return {};
}

}  // namespace tactus::session
