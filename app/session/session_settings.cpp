#include "app/session/session_settings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/json/json_members.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::JsonMembers;
using base::Result;
using Json = nlohmann::ordered_json;
using experiments::SpeedSettings;
using questionnaires::ItemOrder;

constexpr std::array kBlocks = {Block::kSpeed, Block::kForce, Block::kForm};

std::string_view name(SpeedSettings::Order order) noexcept {
  switch (order) {
    case SpeedSettings::Order::kAsGiven: return "as_given";
    case SpeedSettings::Order::kShuffled: return "shuffled";
    case SpeedSettings::Order::kLatinSquare: return "latin_square";
  }
  return "";
}

std::string_view name(VirtualStrokes strokes) noexcept {
  return strokes == VirtualStrokes::kPractice ? "practice" : "accepted";
}

std::string_view name(Grip grip) noexcept { return grip == Grip::kHeld ? "held" : "latch"; }

template <class Enum>
constexpr int kAll = 0;
template <>
constexpr std::array kAll<SpeedSettings::Order> = {SpeedSettings::Order::kAsGiven, SpeedSettings::Order::kShuffled,
                                                   SpeedSettings::Order::kLatinSquare};
template <>
constexpr auto kAll<ItemOrder> = std::to_array(questionnaires::kItemOrders);
template <>
constexpr std::array kAll<VirtualStrokes> = {VirtualStrokes::kPractice, VirtualStrokes::kAccepted};
template <>
constexpr std::array kAll<Grip> = {Grip::kHeld, Grip::kLatch};

// One list of members for both directions: `visit` shows each with its name.

template <class Visitor>
void visit(Visitor& v, experiments::StrokeSettings& s) {
  v("start_speed_mm_s", s.start_speed_mm_s);
  v("stop_speed_mm_s", s.stop_speed_mm_s);
  v("edge_speed_mm_s", s.edge_speed_mm_s);
  v("speed_window_s", s.speed_window_s);
  v("longest_pause_s", s.longest_pause_s);
  v("longest_reversal_mm", s.longest_reversal_mm);
  v("least_mm", s.least_mm);
  v("shortest_mm", s.shortest_mm);
  v("briefest_s", s.briefest_s);
  v("lowest_mm", s.lowest_mm);
  v("highest_mm", s.highest_mm);
  v("longest_gap_s", s.longest_gap_s);
}

template <class Visitor>
void visit(Visitor& v, SpeedSettings& s) {
  v("levels", s.levels);
  v("order", s.order);
  if (s.order == SpeedSettings::Order::kLatinSquare) v("latin_row", s.latin_row);
  v("strokes", s.strokes);
  v("practice", s.practice);
  v("stroke", s.stroke);
}

template <class Visitor>
void visit(Visitor& v, experiments::ForceSteps& s) {
  v("lowest_n", s.lowest_n);
  v("highest_n", s.highest_n);
  v("step_n", s.step_n);
}

template <class Visitor>
void visit(Visitor& v, experiments::ForceSettings& s) {
  v("terms", s.terms);
  v("familiarisation_n", s.familiarisation_n);
  v("ascending", s.ascending);
  v("ladder", s.ladder);
  v("descending", s.descending);
  v("descending_offset_most", s.descending_offset_most);
  v("ladder_catches", s.ladder_catches);
  v("random", s.random);
  v("random_steps", s.random_steps);
  v("random_repeats", s.random_repeats);
  v("random_widest_jump", s.random_widest_jump);
  v("catch_share", s.catch_share);
  v("forward_least_mm", s.forward_least_mm);
  v("forward_least_mm_s", s.forward_least_mm_s);
  v("device_friction_n", s.device_friction_n);
  v.ifUnusual("device_scale", s.device_scale, 1);
  v("ramp_s", s.ramp_s);
  v("continuous_n", s.continuous_n);
  v("hold_limit_s", s.hold_limit_s);
  v("pause_s", s.pause_s);
  v("rest_every", s.rest_every);
  v("start_zone_mm", s.start_zone_mm);
  v("attempts_most", s.attempts_most);
}

template <class Visitor>
void visit(Visitor& v, SessionSettings& s) {
  v("blocks", s.blocks);
  v("speed", s.speed);
  v("force", s.force);
  v("form", s.form);
  v("item_order", s.item_order);
  v("virtual", s.virtual_strokes);
  v("grip", s.grip);
}

template <class T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string> ||
                          std::is_same_v<T, std::vector<std::string>> || std::is_same_v<T, std::vector<double>>;

class Writer {
 public:
  Json json = Json::object();

  void ifUnusual(const char* key, double& member, double usual) {
    if (member != usual) json[key] = member;
  }

  template <class T>
  void operator()(const char* key, T& member) {
    if constexpr (kIsPlain<T>) {
      json[key] = member;
    } else if constexpr (std::is_enum_v<T>) {
      json[key] = name(member);
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      json[key] = member ? Json(*member) : Json(nullptr);
    } else if constexpr (std::is_same_v<T, std::vector<Block>>) {
      json[key] = Json::array();
      for (const Block block : member) json[key].push_back(session::name(block));
    } else {
      Writer part;
      visit(part, member);
      json[key] = std::move(part.json);
    }
  }
};

class Reader {
 public:
  Reader(JsonMembers& members, std::optional<base::Error>& error) : members_(members), error_(error) {}

  void ifUnusual(const char* key, double& member, double /*usual*/) { members_.number(key, member); }

  template <class T>
  void operator()(const char* key, T& member) {
    if constexpr (std::is_same_v<T, bool>) {
      members_.flag(key, member);
    } else if constexpr (std::is_same_v<T, int>) {
      members_.integer(key, member);
    } else if constexpr (std::is_same_v<T, double>) {
      members_.number(key, member);
    } else if constexpr (std::is_same_v<T, std::string>) {
      members_.textOrEmpty(key, member);
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      members_.texts(key, member);
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      members_.numbers(key, member);
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      members_.numberOrNull(key, member);
    } else if constexpr (std::is_same_v<T, std::vector<Block>>) {
      readBlocks(key, member);
    } else if constexpr (std::is_enum_v<T>) {
      const auto words = namesOf(kAll<T>);
      if (const auto found = members_.word(key, words)) member = kAll<T>[*found];
    } else if (const auto value = members_.object(key)) {
      JsonMembers part(*value, error_);
      Reader reader(part, error_);
      visit(reader, member);
    }
  }

 private:
  template <class Enum, std::size_t count>
  static std::array<std::string_view, count> namesOf(const std::array<Enum, count>& all) {
    std::array<std::string_view, count> names;
    std::transform(all.begin(), all.end(), names.begin(), [](Enum one) { return name(one); });
    return names;
  }

  void readBlocks(const char* key, std::vector<Block>& blocks) {
    const auto names = namesOf(kBlocks);
    std::vector<std::string> words;
    if (!members_.has(key)) return;
    members_.texts(key, words);
    blocks.clear();
    for (const auto& word : words) {
      const auto found = std::find(names.begin(), names.end(), word);
      if (found == names.end()) return members_.refuse(key, base::quoted(word), "speed, force or form");
      blocks.push_back(kBlocks[static_cast<std::size_t>(found - names.begin())]);
    }
  }

  JsonMembers& members_;
  std::optional<base::Error>& error_;
};

}  // namespace

std::string_view name(Block block) noexcept {
  switch (block) {
    case Block::kSpeed: return "speed";
    case Block::kForce: return "force";
    case Block::kForm: return "form";
  }
  return "";
}

SessionSettings usabilitySession() {
  SessionSettings settings;
  settings.blocks = {Block::kForm};
  settings.form = "usability-v1";
  return settings;
}

double expectedMinutes(const SessionSettings& settings) {
  constexpr double kStimulusS = 12;
  constexpr double kItemS = 10;
  constexpr double kOtherMin = 5;
  double seconds = 0;
  for (const Block block : settings.blocks) {
    if (block == Block::kSpeed) {
      const auto levels = static_cast<double>(settings.speed.levels.size());
      seconds += kStimulusS * levels * (settings.speed.practice + settings.speed.strokes);
    } else if (block == Block::kForce) {
      const auto& force = settings.force;
      double stimuli = static_cast<double>(force.familiarisation_n.size());
      const int ladders = (force.ascending ? 1 : 0) + (force.descending ? 1 : 0);
      stimuli += (force.ladder.count() + force.ladder_catches) * ladders;
      if (force.random) stimuli += force.random_steps.count() * force.random_repeats * (1 + force.catch_share);
      seconds += kStimulusS * stimuli;
    } else if (const auto form =
                   questionnaires::questionnaire(settings.about(), settings.form, settings.about().languages.front())) {
      seconds += kItemS * static_cast<double>(form->questions.size());
    }
  }
  return kOtherMin + seconds / 60;
}

Result<void> validate(const SessionSettings& settings) {
  if (settings.blocks.empty()) return fail(ErrorCode::kValue, "session", "no blocks", "at least one");
  for (const Block block : settings.blocks) {
    if (std::count(settings.blocks.begin(), settings.blocks.end(), block) > 1) {
      return fail(ErrorCode::kValue, "session", "the block " + base::quoted(name(block)) + " twice", "each block once");
    }
    Result<void> ok;
    switch (block) {
      case Block::kSpeed: ok = experiments::validate(settings.speed); break;
      case Block::kForce: ok = experiments::validate(settings.force); break;
      case Block::kForm:
        if (const auto form =
                questionnaires::questionnaire(settings.about(), settings.form, settings.about().languages.front());
            !form) {
          ok = tl::unexpected(form.error());
        }
        break;
    }
    if (!ok) return ok;
  }
  return {};
}

std::string toJson(const SessionSettings& settings) {
  SessionSettings copy = settings;
  Writer writer;
  visit(writer, copy);
  if (!settings.felt) writer.json["felt"] = false;
  return writer.json.dump();
}

SessionSettings readSessionSettings(JsonMembers& members, std::optional<base::Error>& error) {
  // A member of a newer program is ignored.
  SessionSettings settings;
  Reader reader(members, error);
  visit(reader, settings);
  members.flag("felt", settings.felt);
  return settings;
}

Result<SessionSettings> parseSessionSettings(std::string_view text) {
  return base::readJson(text, {}, readSessionSettings);
}

std::uint64_t blockSeed(std::uint64_t session_seed, Block block) noexcept {
  // One step of SplitMix64 (Steele, Lea and Flood 2014) from a place of its own for each block.
  std::uint64_t z = session_seed + 0x9E3779B97F4A7C15U * (static_cast<std::uint64_t>(block) + 1);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

}  // namespace tactus::session
