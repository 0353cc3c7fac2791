// What participants are asked about themselves: the questions, their answers, and what a profile stores of them.
#pragma once

#include <span>
#include <string_view>

namespace tactus::session {

struct ProfileOffer {
  std::string_view id;      ///< unique in its question: `years_1`, `left`
  std::string_view words;   ///< id of the text in strings.tsv of the participant's screens: `you.hand_left`
  std::string_view stored;  ///< in study::ProfileRecord; of `years` the band (experienceBandCalled)
};

struct ProfileQuestion {
  std::string_view field;  ///< `years`, `handedness`, `gloves`, `haptic_experience`, `comfort`
  std::string_view words;  ///< id of its text
  std::span<const ProfileOffer> offers;
  bool may_not_say = true;  ///< false where the answer must be known: pictures and device follow the hand
};

/// In the order in which they are asked.
std::span<const ProfileQuestion> profileQuestions();

/// The question with this field, or null.
const ProfileQuestion* profileQuestion(std::string_view field);

/// What is stored where the offer `id` of `question` was chosen; empty for no offer: the participant did not say.
std::string_view storedAnswer(const ProfileQuestion& question, std::string_view id);

}  // namespace tactus::session
