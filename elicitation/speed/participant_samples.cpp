#include "elicitation/speed/participant_samples.h"

#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

ParticipantSamples::ParticipantSamples(std::span<const study::SpeedSample> samples) {
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin + 1;
    while (end < samples.size() && samples[end].participant == samples[begin].participant) ++end;
    const auto run = samples.subspan(begin, end - begin);
    const auto [place, is_new] = found_.try_emplace(run.front().participant);
    Found& found = place->second;
    if (is_new) {
      found.all = run;
    } else {
      if (found.copied.empty()) found.copied.assign(found.all.begin(), found.all.end());
      found.copied.insert(found.copied.end(), run.begin(), run.end());
      found.all = found.copied;
    }
    begin = end;
  }
}

std::span<const study::SpeedSample> ParticipantSamples::of(std::string_view participant) const {
  const auto found = found_.find(participant);
  return found == found_.end() ? std::span<const study::SpeedSample>() : found->second.all;
}

std::span<const study::SpeedSample> keptSamples(std::span<const study::SpeedSample> samples, double share,
                                                std::vector<study::SpeedSample>& room) {
  if (share <= 0) return samples;
  room = trimStrokes(samples, share);
  return room;
}

}  // namespace tactus::elicitation
