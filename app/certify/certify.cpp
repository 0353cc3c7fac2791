#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "app/certify/certificate.h"
#include "core/analysis/check_points.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"

namespace tactus::certify {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonWriter;
using base::required;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kProtocol = "tactus-certify";
constexpr int kGreetings = 5;     ///< a program may take as many times as long to begin as for an answer
constexpr int kMostSilences = 3;  ///< in a row; then it is not asked any more

}  // namespace

Percentiles percentilesOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = [&values](double share) {
    const auto number = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(number, 1) - 1];
  };
  return {rank(0.5), rank(0.99), rank(0.999), values.back()};
}

Percentiles Answers::jitter() const {
  std::vector<double> differences;
  for (std::size_t i = 1; i < latency_us.size(); ++i)
    differences.push_back(std::abs(latency_us[i] - latency_us[i - 1]));
  return percentilesOf(std::move(differences));
}

std::string Certificate::verdict() const {
  const std::string within = base::formatNumber(tolerance) + " N";
  if (!ok()) return "Not certified: " + (failure.empty() ? std::string("not every answer is right") : failure) + ".";
  const std::string what = has_tube ? "the forces of the model and what a hand feels of its tube"
                                    : "the forces of the model; its tube was not asked for";
  return "Within " + within + " of " + base::oneLine(model_name) + ": " + what + ".";
}

std::string scientific(double value) {
  if (value == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  return base::formatFixed(value / std::pow(10, exponent), 1) + "e" + std::to_string(exponent);
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(": ");
    return colon == std::string::npos ? std::string() : line.substr(colon + 2);
  }
  return {};
}

namespace {

std::string oneLineOf(const JsonWriter& json) {
  std::string text = json.text();
  text.pop_back();  // its line feed
  return text;
}

/// What an answer says.
struct Reply {
  double id = 0;
  double force_n = 0;
  bool fired = false;
  double depth_mm = 0;
};

enum class Asked { kForce, kStep };

class Examiner {
 public:
  Examiner(ForeignProgram& program, const Questions& questions, const CertifySettings& settings,
           const Patience& patience, Certificate& out)
      : program_(program), questions_(questions), settings_(settings), patience_(patience), out_(out) {}

  void run() {
    out_.points.all = questions_.points.size();
    if (!greet()) return;
    if (out_.program_has_tube) {
      for (const auto& felt : questions_.insertions.felt) out_.steps.all += felt.size();
    }
    out_.has_tube = out_.steps.all > 0;
    askForces();
    if (out_.has_tube) askTraces();
    if (!over_) (void)program_.send(oneLineOf(lineOf("end").beginObject().endObject().endObject()));
  }

  bool isStopped() const { return stopped_; }

 private:
  bool greet() {
    JsonWriter hello = lineOf("hello");
    hello.value(kProtocol).key("version").value(1).key("model_sha256").value(questions_.model_sha256);
    hello.key("inputs").beginArray();
    for (const fuzzy::Variable& input : questions_.model.inputs) hello.value(input.id);
    hello.endArray().endObject();
    if (!say(oneLineOf(hello), "hello")) return false;
    const auto line = program_.receive(kGreetings * patience_.answer);
    if (!line) return gone(line.error(), "hello");
    std::string sha256;
    const auto read = base::readJson(*line, "", [&](JsonMembers& members, std::optional<base::Error>& error) {
      if (takeError(members)) return true;
      std::string name;
      members.text(required("hello"), name);
      if (!error && name != kProtocol) members.refuse("hello", "'" + std::string(kProtocol) + "'");
      members.version(required("version"));
      members.textOrEmpty("program", out_.program);
      members.textOrEmpty("model_sha256", sha256);
      members.flag("tube", out_.program_has_tube);
      return true;
    });
    if (!read) return gone(read.error(), "hello");
    if (over_) return false;
    if (!sha256.empty() && base::lowered(sha256) != questions_.model_sha256)
      note("hello", "a program of the model with SHA-256 " + base::oneLine(sha256),
           "one of " + questions_.model_sha256);
    return true;
  }

  void askForces() {
    for (std::size_t p = 0; p < questions_.points.size() && !over_; ++p) {
      const Point& point = questions_.points[p];
      JsonWriter line = lineOf("force");
      line.beginObject().key("id").value(++id_).key("inputs").values(std::span<const double>(point.inputs));
      line.endObject().endObject();
      const std::string place = "point " + std::to_string(p + 1) + " (" + valuesText(point.inputs) + ")";
      const auto reply = ask(Asked::kForce, oneLineOf(line), place, out_.points);
      if (reply) judge(*reply, point.force_n, point.fired, std::nullopt, place, out_.points);
    }
  }

  void askTraces() {
    const bundle::FeltTraces& all = questions_.insertions;
    for (std::size_t t = 0; t < all.traces.size() && !over_; ++t) askTrace(all.traces[t], all.felt[t]);
  }

  void askTrace(const render::TubeTrace& trace, const std::vector<render::TubeFeel>& felt) {
    const std::vector<double>* conditions = nullptr;
    for (std::size_t s = 0; s < trace.steps.size() && !over_; ++s) {
      const render::TubeStep& step = trace.steps[s];
      const std::string place = "insertion " + base::quoted(trace.name) + ", step " + std::to_string(s + 1);
      const bool is_start = conditions == nullptr;
      if ((is_start || step.conditions != *conditions) && !say(sceneLine(step, is_start), place)) return;
      conditions = &step.conditions;
      JsonWriter line = lineOf("step");
      line.beginObject().key("id").value(++id_).key("position_mm").value(step.position_mm);
      line.key("held").value(step.held).key("dt_s").value(step.dt_s).endObject().endObject();
      const auto reply = ask(Asked::kStep, oneLineOf(line), place, out_.steps);
      if (!reply) return;  // whatever follows would be of another tube
      judge(*reply, felt[s].force_n, std::nullopt, felt[s].depth_mm, place, out_.steps);
    }
  }

  std::string sceneLine(const render::TubeStep& step, bool is_start) const {
    JsonWriter line = lineOf("tube");
    line.beginObject().key(is_start ? "start" : "scene").beginObject().key("conditions").beginObject();
    const std::vector<std::string>& names = questions_.insertions.conditions;
    for (std::size_t i = 0; i < names.size(); ++i) line.key(names[i]).value(step.conditions[i]);
    return oneLineOf(line.endObject().endObject().endObject().endObject());
  }

  /// The answer in time; nothing where it is missing or none, which is counted.
  std::optional<Reply> ask(Asked kind, const std::string& line, const std::string& place, Answers& answers) {
    const auto start = Clock::now();
    if (!say(line, place)) {
      ++answers.missing;
      return std::nullopt;
    }
    while (true) {
      const auto received = program_.receive();
      const std::chrono::duration<double, std::micro> took = Clock::now() - start;
      if (!received) {
        if (!stopped_) ++answers.missing;
        unanswered_[id_] = &answers;
        gone(received.error(), place);
        return std::nullopt;
      }
      const auto reply = replyIn(kind, *received);
      if (over_ || !reply) {
        ++answers.wrong;
        if (!reply) note(place, reply.error());
        return std::nullopt;
      }
      if (const auto before = unanswered_.find(reply->id); before != unanswered_.end()) {
        --before->second->missing;
        ++before->second->late;
        unanswered_.erase(before);
        continue;
      }
      if (reply->id != static_cast<double>(id_)) {
        ++answers.wrong;
        note(place, "an answer to the question " + base::formatNumber(reply->id), "one to " + std::to_string(id_));
        return std::nullopt;
      }
      silences_ = 0;
      answers.latency_us.push_back(took.count());
      return *reply;
    }
  }

  base::Result<Reply> replyIn(Asked kind, const std::string& line) {
    return base::readJson(line, "", [&](JsonMembers& members, std::optional<base::Error>& error) {
      Reply reply;
      if (takeError(members)) return reply;
      const auto answer = members.object(required(kind == Asked::kForce ? "force" : "step"));
      if (!answer) return reply;
      JsonMembers own(*answer, error);
      own.number(required("id"), reply.id);
      own.number(required("force_n"), reply.force_n);
      if (kind == Asked::kForce) {
        own.flag(required("fired"), reply.fired);
      } else {
        own.number(required("depth_mm"), reply.depth_mm);
      }
      return reply;
    });
  }

  /// What the program itself says that it cannot do.
  bool takeError(JsonMembers& members) {
    if (!members.has("error")) return false;
    std::string sentence;
    members.text("error", sentence);
    over_ = true;
    constexpr std::size_t kMostWords = 300;
    if (sentence.size() > kMostWords) sentence.resize(kMostWords);
    note("the program", "the words '" + sentence + "'", "answers");
    return true;
  }

  void judge(const Reply& reply, double force_n, std::optional<bool> fired, std::optional<double> depth_mm,
             const std::string& place, Answers& answers) {
    const double error_n = std::abs(reply.force_n - force_n);
    const double error_mm = depth_mm ? std::abs(reply.depth_mm - *depth_mm) : 0;
    if (error_n > answers.largest_error_n) {
      answers.largest_error_n = error_n;
      answers.where = place;
    }
    out_.largest_depth_error_mm = std::max(out_.largest_depth_error_mm, error_mm);
    const std::string within = base::formatNumber(settings_.tolerance);
    if (!(error_n <= settings_.tolerance)) {
      note(place, base::formatNumber(reply.force_n) + " N", base::formatNumber(force_n) + " N within " + within + " N");
    } else if (!(error_mm <= settings_.tolerance)) {
      note(place, "a depth of " + base::formatNumber(reply.depth_mm) + " mm",
           base::formatNumber(*depth_mm) + " mm within " + within + " mm");
    } else if (fired && reply.fired != *fired) {
      note(place, reply.fired ? "fired" : "not fired",
           std::string(*fired ? "fired" : "not fired") + ", because " + (*fired ? "a" : "no") + " rule fires there");
    } else {
      ++answers.right;
      return;
    }
    ++answers.wrong;
  }

  bool say(const std::string& line, const std::string& place) {
    const auto sent = program_.send(line);
    return sent ? true : gone(sent.error(), place);
  }

  /// Returns false.
  bool gone(const base::Error& error, const std::string& place) {
    stopped_ = stopped_ || error.code == ErrorCode::kCancelled;
    note(place, error);
    // A program that is only silent is asked again, but not for ever.
    over_ = over_ || error.code != ErrorCode::kData || ++silences_ >= kMostSilences;
    return false;
  }

  void note(const std::string& place, const base::Error& error) {
    const std::string inside = error.place.empty() ? "" : " " + error.place;
    note(place, error.found, error.wanted + (inside.empty() ? "" : " at" + inside + " of its line"));
  }
  void note(const std::string& place, const std::string& found, const std::string& wanted) {
    if (out_.failure.empty()) out_.failure = base::oneLine(place + ": found " + found + ", wanted " + wanted);
  }

  std::string valuesText(const std::vector<double>& inputs) const {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      out.push_back(questions_.model.inputs[i].id + " " + base::roundedNumber(inputs[i]));
    return base::joined(out, ", ");
  }

  ForeignProgram& program_;
  const Questions& questions_;
  const CertifySettings& settings_;
  const Patience& patience_;
  Certificate& out_;
  std::size_t id_ = 0;                     ///< of the last question
  std::map<double, Answers*> unanswered_;  ///< ids of questions whose answer did not come in time
  int silences_ = 0;
  bool over_ = false;     ///< nothing more is asked
  bool stopped_ = false;  ///< by the user
};

std::string machine() {
  const std::string name = processor();
  return (name.empty() ? "" : base::oneLine(name) + ", ") + std::to_string(std::thread::hardware_concurrency()) +
         " threads";
}

}  // namespace

base::Result<Certificate> certify(const Target& target, const Questions& questions, const CertifySettings& settings,
                                  const Patience& patience) {
  TACTUS_TRY(auto program, ForeignProgram::open(target, patience));
  Certificate out;
  out.target = target.name;
  out.model_name = questions.model.name;
  out.model_sha256 = questions.model_sha256;
  out.utc = settings.utc;
  out.generator = settings.generator;
  out.machine = machine();
  out.tolerance = settings.tolerance;
  Examiner examiner(program, questions, settings, patience, out);
  examiner.run();
  if (examiner.isStopped()) return base::fail(ErrorCode::kCancelled, target.name, "a request to stop", "time to end");
  return out;
}

// What a program is asked: the points of a model's checks, and scripted insertions.

namespace {

base::Result<std::vector<Point>> pointsAt(const fuzzy::ForceModel& model, std::vector<std::vector<double>> points) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  std::vector<Point> out;
  for (auto& inputs : points) {
    const fuzzy::Evaluation force = compiled.evaluate(inputs);
    out.push_back({std::move(inputs), force.force_n, force.fired});
  }
  return out;
}

/// The columns `names` of a table, row by row.
base::Result<std::vector<std::vector<double>>> rowsOf(const base::CsvTable& table,
                                                      const std::vector<std::string>& names) {
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    TACTUS_TRY(const auto column, table.require(name));
    columns.push_back(column);
  }
  std::vector<std::vector<double>> rows(table.rowCount());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const std::size_t column : columns) {
      TACTUS_TRY(const auto value, table.number(r, column));
      rows[r].push_back(value);
    }
  }
  return rows;
}

base::Result<bundle::FeltTraces> readInsertions(const std::string& path, const fuzzy::ForceModel& model) {
  TACTUS_TRY(const auto inputs, render::tubeInputs(model));
  TACTUS_TRY(const auto table, base::CsvTable::read(path));
  TACTUS_TRY(const auto name, table.require("trace"));
  bundle::FeltTraces out;
  for (const std::size_t input : inputs.conditions) out.conditions.push_back(model.inputs[input].id);
  std::vector<std::string> names = {"position_mm", "held", "dt_s", "force_n", "depth_mm"};
  names.insert(names.end(), out.conditions.begin(), out.conditions.end());
  TACTUS_TRY(const auto rows, rowsOf(table, names));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r == 0 || table.cell(r, name) != table.cell(r - 1, name)) {
      out.traces.push_back({std::string(table.cell(r, name)), {}});
      out.felt.emplace_back();
    }
    const auto& row = rows[r];
    out.traces.back().steps.push_back({row[0], row[1] != 0, row[2], {row.begin() + 5, row.end()}});
    out.felt.back().push_back({row[3], row[4], 0, 0});
  }
  return out;
}

bundle::FeltTraces insertionsOf(const fuzzy::ForceModel& model) {
  return bundle::feltTraces(model).value_or(bundle::FeltTraces{});
}

}  // namespace

base::Result<Questions> questionsOf(fuzzy::ForceModel model, std::string sha256) {
  TACTUS_TRY(auto points, pointsAt(model, analysis::checkPoints(model)));
  auto insertions = insertionsOf(model);
  return Questions{std::move(model), std::move(sha256), std::move(points), std::move(insertions)};
}

base::Result<Questions> questionsOfBundle(const std::string& folder) {
  TACTUS_TRY(auto bundle, model_io::checkBundle(folder));
  std::string checks;
  std::string traces;
  for (const model_io::FileCheck& check : bundle.files) {
    if (!check.ok) {
      return base::fail(ErrorCode::kMismatch, folder, "a bundle that is not what it promises (" + check.wrong + ")",
                        "an undamaged one");
    }
    if (check.file.kind == "checks") checks = check.file.path;
    if (check.file.kind == "tube-checks") traces = check.file.path;
  }
  if (checks.empty()) return base::fail(ErrorCode::kSchema, folder, "a bundle without checks", "one with checks.csv");
  std::vector<std::string> inputs;
  for (const fuzzy::Variable& input : bundle.model.inputs) inputs.push_back(input.id);
  Questions out;
  TACTUS_TRY(const auto table, base::CsvTable::read(folder + "/" + checks));
  TACTUS_TRY(auto rows, rowsOf(table, inputs));
  TACTUS_TRY(out.points, pointsAt(bundle.model, std::move(rows)));
  if (traces.empty()) {
    out.insertions = insertionsOf(bundle.model);
  } else {
    TACTUS_TRY(out.insertions, readInsertions(folder + "/" + traces, bundle.model));
  }
  out.model = std::move(bundle.model);
  out.model_sha256 = std::move(bundle.model_sha256);
  return out;
}

}  // namespace tactus::certify
