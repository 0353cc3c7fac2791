// The JSON Schema of the model file: every model that the program writes validates, what the reader refuses for its
// shape does not. A small validator of the words that the schema uses; schema_test.py asks another one.
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/base/random.h"
#include "core/fuzzy/renderer_parameters.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::model_io {
namespace {

using nlohmann::json;

json load(const std::string& path) {
  std::ifstream file(path);
  return json::parse(file);
}

/// The place of the first violation; empty where there is none.
class Validator {
 public:
  explicit Validator(json schema) : schema_(std::move(schema)) {}

  std::string check(const json& value) const { return check(schema_, value, "/"); }

 private:
  static bool isType(const std::string& type, const json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    ADD_FAILURE() << "the schema has an unknown type " << type;
    return false;
  }

  static bool inLimits(const json& schema, const json& value) {
    const auto limit = [&](const char* word, double size, auto&& holds) {
      return !schema.contains(word) || holds(size, schema[word].get<double>());
    };
    const auto least = [](double size, double bound) { return size >= bound; };
    const auto most = [](double size, double bound) { return size <= bound; };
    if (value.is_number()) {
      const double x = value.get<double>();
      return limit("minimum", x, least) && limit("maximum", x, most) &&
             limit("exclusiveMinimum", x, std::greater<>()) && limit("exclusiveMaximum", x, std::less<>());
    }
    const auto size = static_cast<double>(value.is_string() ? value.get<std::string>().size() : value.size());
    if (value.is_string()) return limit("minLength", size, least) && limit("maxLength", size, most);
    if (value.is_array()) return limit("minItems", size, least) && limit("maxItems", size, most);
    if (value.is_object()) return limit("minProperties", size, least) && limit("maxProperties", size, most);
    return true;
  }

  std::string check(const json& schema, const json& value, const std::string& place) const {
    static const std::set<std::string> kKnown = {
        "$schema",  "title",     "description", "type",          "required",         "properties",           "items",
        "enum",     "const",     "minimum",     "maximum",       "exclusiveMinimum", "exclusiveMaximum",     "minItems",
        "maxItems", "minLength", "maxLength",   "minProperties", "maxProperties",    "additionalProperties", "$ref",
        "$defs",    "allOf",     "if",          "then",          "pattern"};
    for (const auto& [word, unused] : schema.items()) EXPECT_TRUE(kKnown.contains(word)) << word;
    if (schema.contains("$ref")) {
      const std::string name = schema["$ref"].get<std::string>().substr(8);
      return check(schema_["$defs"].at(name), value, place);
    }
    if (schema.contains("type") && !isType(schema["type"], value)) return place;
    if (schema.contains("const") && schema["const"] != value) return place;
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      return place;
    if (!inLimits(schema, value)) return place;
    for (const json& key : schema.value("required", json::array())) {
      if (!value.contains(key.get<std::string>())) return place + key.get<std::string>();
    }
    for (const json& part : schema.value("allOf", json::array())) {
      if (!check(part["if"], value, place).empty()) continue;
      if (const std::string wrong = check(part["then"], value, place); !wrong.empty()) return wrong;
    }
    if (value.is_object()) return checkMembers(schema, value, place);
    if (!value.is_array() || !schema.contains("items")) return {};
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (auto wrong = check(schema["items"], value[i], place + std::to_string(i) + "/"); !wrong.empty()) return wrong;
    }
    return {};
  }

  std::string checkMembers(const json& schema, const json& value, const std::string& place) const {
    for (const auto& [key, member] : value.items()) {
      const bool known = schema.contains("properties") && schema["properties"].contains(key);
      const json* const of = known                                     ? &schema["properties"][key]
                             : schema.contains("additionalProperties") ? &schema["additionalProperties"]
                                                                       : nullptr;
      if (of == nullptr) continue;
      if (auto wrong = check(*of, member, place + key + "/"); !wrong.empty()) return wrong;
    }
    return {};
  }

  json schema_;
};

const json kModelSchema = load(std::string(TACTUS_SOURCE_DIR) + "/core/model_io/model_file.schema.json");

TEST(ModelSchema, TakesWhatTheProgramWrites) {
  const Validator validator(kModelSchema);
  base::Random random(21);
  for (int i = 0; i < 300; ++i) {
    const auto model = support::randomModel(random, {.gaussians = i % 2 == 0});
    EXPECT_EQ(validator.check(json::parse(formatModel(model))), "") << i;
  }
  for (const char* const name : {"example", "minimal", "ngt"}) {
    EXPECT_EQ(validator.check(load(std::string(TACTUS_GOLDEN_DIR) + "/models/" + name + ".tactus.json")), "") << name;
  }
}

TEST(ModelSchema, RefusesWhatTheReaderRefusesForItsShape) {
  const Validator validator(kModelSchema);
  const json whole = load(std::string(TACTUS_GOLDEN_DIR) + "/models/example.tactus.json");
  ASSERT_TRUE(parseModel(whole.dump(), "whole"));
  const auto refused = [&](const std::string& pointer, const json& value) {
    json broken = whole;
    broken[json::json_pointer(pointer)] = value;
    EXPECT_FALSE(parseModel(broken.dump(), "broken")) << pointer;
    EXPECT_NE(validator.check(broken), "") << pointer;
  };
  refused("/format", "tactus");
  refused("/version", 2);
  refused("/inputs", json::array());
  refused("/inputs/0/min", "0");
  refused("/inputs/0/terms/0/shape", "bell");
  refused("/inputs/0/terms/0/points", {0, 1});
  refused("/inference/conjunction", "product");
  refused("/experts/0/weight", -1);
  refused("/experts/0/rules/0/weight", 1.5);
  refused("/experts/0/rules/0/if", json::object());
  refused("/experts/0/rules/0/enabled", 1);
  refused("/renderer/stiffness_n_mm", 0);
  refused("/checks/0/fired", "yes");
  refused("/contracts/0/kind", "never_hurts");
  refused("/contracts/2/within", 0);
  refused("/events/0/share", 1);
  refused("/events/0/term", 3);
  for (const std::string key : {"name", "inputs", "output", "inference", "experts"}) {
    json broken = whole;
    broken.erase(key);
    EXPECT_FALSE(parseModel(broken.dump(), "broken")) << key;
    EXPECT_NE(validator.check(broken), "") << key;
  }
}

TEST(ModelSchema, HasTheRangesOfTheRenderer) {
  const json& renderer = kModelSchema["properties"]["renderer"]["properties"];
  EXPECT_EQ(renderer.size(), std::size(fuzzy::kRendererFields) + 1);
  for (const auto& field : fuzzy::kRendererFields) {
    const json& range = renderer.at(field.key);
    EXPECT_EQ(range.at(field.min_excluded ? "exclusiveMinimum" : "minimum").get<double>(), field.min) << field.key;
    EXPECT_EQ(range.at("maximum").get<double>(), field.max) << field.key;
  }
}

}  // namespace
}  // namespace tactus::model_io
