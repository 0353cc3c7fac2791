#include "app/session/session_settings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using Json = nlohmann::ordered_json;
using experiments::SpeedSettings;
using questionnaires::ItemOrder;

constexpr std::array kBlocks = {Block::kSpeed, Block::kForce, Block::kForm};

std::string_view name(SpeedSettings::Order order) noexcept {
  return order == SpeedSettings::Order::kAsGiven ? "as_given" : "shuffled";
}

template <class Enum>
constexpr std::array<Enum, 2> kTwo = {};
template <>
constexpr std::array<SpeedSettings::Order, 2> kTwo<SpeedSettings::Order> = {SpeedSettings::Order::kAsGiven,
                                                                            SpeedSettings::Order::kShuffled};
template <>
constexpr std::array<ItemOrder, 2> kTwo<ItemOrder> = {ItemOrder::kFixed, ItemOrder::kShuffled};

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
  v("random", s.random);
  v("random_steps", s.random_steps);
  v("random_repeats", s.random_repeats);
  v("random_widest_jump", s.random_widest_jump);
  v("catch_share", s.catch_share);
  v("forward_least_mm", s.forward_least_mm);
  v("forward_least_mm_s", s.forward_least_mm_s);
  v("device_friction_n", s.device_friction_n);
  v("ramp_s", s.ramp_s);
  v("continuous_n", s.continuous_n);
  v("hold_limit_s", s.hold_limit_s);
  v("pause_s", s.pause_s);
  v("rest_every", s.rest_every);
  v("start_zone_mm", s.start_zone_mm);
}

template <class Visitor>
void visit(Visitor& v, SessionSettings& s) {
  v("blocks", s.blocks);
  v("speed", s.speed);
  v("force", s.force);
  v("form", s.form);
  v("item_order", s.item_order);
}

template <class T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string> ||
                          std::is_same_v<T, std::vector<std::string>> || std::is_same_v<T, std::vector<double>>;

class Writer {
 public:
  Json json = Json::object();

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
  Reader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}
  std::optional<base::Error> error;

  template <class T>
  void operator()(const char* key, T& member) {
    if (error || !json_.contains(key)) return;
    const Json& value = json_.at(key);
    const std::string place = place_ + '/' + key;
    if constexpr (std::is_same_v<T, bool>) {
      takeIf(value.is_boolean(), value, member, place, "true or false");
    } else if constexpr (std::is_integral_v<T>) {
      takeIf(value.is_number_integer(), value, member, place, "a whole number");
    } else if constexpr (std::is_arithmetic_v<T>) {
      takeIf(value.is_number(), value, member, place, "a number");
    } else if constexpr (std::is_same_v<T, std::string>) {
      takeIf(value.is_string(), value, member, place, "a text");
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      takeIf(allOf(value, &Json::is_string), value, member, place, "a list of texts");
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      takeIf(allOf(value, &Json::is_number), value, member, place, "a list of numbers");
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      if (value.is_null()) {
        member.reset();
      } else {
        double number = 0;
        takeIf(value.is_number(), value, number, place, "a number or null");
        member = number;
      }
    } else if constexpr (std::is_same_v<T, std::vector<Block>>) {
      member.clear();
      if (!value.is_array()) return refuse(place, value, "a list of blocks");
      for (const auto& word : value) {
        Block block{};
        if (!word.is_string() || !takeWord(word.get<std::string>(), kBlocks, block)) {
          return refuse(place, word, "speed, force or form");
        }
        member.push_back(block);
      }
    } else if constexpr (std::is_enum_v<T>) {
      if (!value.is_string() || !takeWord(value.get<std::string>(), kTwo<T>, member)) {
        refuse(place, value, "a word that this program knows");
      }
    } else {
      if (!value.is_object()) return refuse(place, value, "an object");
      Reader part(value, place);
      visit(part, member);
      error = std::move(part.error);
    }
  }

 private:
  static bool allOf(const Json& list, bool (Json::*is)() const noexcept) {
    return list.is_array() && std::all_of(list.begin(), list.end(), [is](const Json& one) { return (one.*is)(); });
  }

  template <class Enum, std::size_t count>
  static bool takeWord(const std::string& word, const std::array<Enum, count>& all, Enum& member) {
    const auto it = std::find_if(all.begin(), all.end(), [&word](Enum value) { return name(value) == word; });
    if (it == all.end()) return false;
    member = *it;
    return true;
  }

  template <class T>
  void takeIf(bool fits, const Json& value, T& member, const std::string& place, const char* wanted) {
    if (fits) {
      member = value.get<T>();
    } else {
      refuse(place, value, wanted);
    }
  }

  void refuse(const std::string& place, const Json& value, std::string wanted) {
    error = base::Error{ErrorCode::kSchema, {}, place, base::quoted(value.dump()), std::move(wanted)};
  }

  const Json& json_;
  std::string place_;
};

}  // namespace

std::string_view name(Block block) noexcept {
  switch (block) {
    case Block::kSpeed:
      return "speed";
    case Block::kForce:
      return "force";
    case Block::kForm:
      return "form";
  }
  return "";
}

SessionSettings usabilitySession() {
  SessionSettings settings;
  settings.blocks = {Block::kForm};
  settings.form = "usability-v1";
  return settings;
}

Result<void> validate(const SessionSettings& settings) {
  if (settings.blocks.empty()) return fail(ErrorCode::kValue, "session", "no blocks", "at least one");
  for (const Block block : settings.blocks) {
    if (std::count(settings.blocks.begin(), settings.blocks.end(), block) > 1) {
      return fail(ErrorCode::kValue, "session", "the block " + base::quoted(name(block)) + " twice", "each block once");
    }
    Result<void> ok;
    switch (block) {
      case Block::kSpeed:
        ok = experiments::validate(settings.speed);
        break;
      case Block::kForce:
        ok = experiments::validate(settings.force);
        break;
      case Block::kForm:
        if (const auto form = questionnaires::questionnaire(settings.form, "en"); !form) {
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
  return writer.json.dump();
}

Result<SessionSettings> parseSessionSettings(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return fail(ErrorCode::kSyntax, "settings", base::quoted(text), "a JSON object");
  SessionSettings settings;
  Reader reader(json, {});
  visit(reader, settings);
  if (reader.error) return tl::unexpected(std::move(*reader.error));
  return settings;
}

std::uint64_t blockSeed(std::uint64_t session_seed, Block block) noexcept {
  // One step of SplitMix64 (Steele, Lea and Flood 2014) from a place of its own for each block.
  std::uint64_t z = session_seed + 0x9E3779B97F4A7C15U * (static_cast<std::uint64_t>(block) + 1);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

}  // namespace tactus::session
