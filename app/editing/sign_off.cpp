#include "app/editing/sign_off.h"

namespace tactus::editing {
namespace {

constexpr auto kFelt = "feels right";
constexpr auto kUnfelt = "approved without feeling";

std::string counted(std::size_t number, const std::string& what) {
  return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

}  // namespace

std::string signOffText(std::size_t edits, const Felt& felt) {
  const std::string after = ", after " + counted(edits, "edit");
  if (felt.strokes == 0) return kUnfelt + after;
  std::string out = kFelt + after + ": " + counted(felt.strokes, "stroke") + " on " + felt.device;
  if (felt.simulated) out += " (simulated)";
  if (!felt.regions.empty()) out += ", " + felt.regions.front();
  if (felt.regions.size() > 1) out += " to " + felt.regions.back();
  return out;
}

bool saysFelt(const std::string& label) { return label.starts_with(kFelt); }

}  // namespace tactus::editing
