// What a sign-off says. "Feels right" needs a stroke of the hand on that very state; without one it is an approval.
#pragma once

#include <string>
#include <vector>

namespace tactus::editing {

/// How one state of the model was felt.
struct Felt {
  unsigned strokes = 0;              ///< that began on this state
  std::string device;                ///< its name; that of the last stroke
  bool simulated = false;            ///< a program moved, or there was no hardware
  std::vector<std::string> regions;  ///< labels of the regions that the tip reached, in the order of the depth

  bool operator==(const Felt&) const = default;
};

/// `feels right, after 3 edits: 4 strokes on Touch, Nasal cavity to Oropharynx`; the device with `(simulated)` behind
/// it where it is one. `approved without feeling, after 3 edits` for no stroke.
std::string signOffText(std::size_t edits, const Felt& felt);

/// Whether the label of a sign-off says that the state was felt. Labels stay as they are stored.
bool saysFelt(const std::string& label);

}  // namespace tactus::editing
