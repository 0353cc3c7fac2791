// Her own model in the hand: OwnModelTrial of participant_course.h.
#include <QPointer>
#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "app/session/session_notes.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/participant_course.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {
namespace {

using base::Result;

constexpr int kCurvePoints = 200;  // one a few pixels

template <class Row>
void keepOnly(std::vector<Row>& rows, const std::string& code) {
  std::erase_if(rows, [&](const Row& row) { return row.participant != code; });
}

/// What one participant told the study.
study::Study dataOf(study::Study all, const std::string& code) {
  std::erase_if(all.participants, [&](const study::Participant& one) { return one.code != code; });
  keepOnly(all.speeds, code);
  keepOnly(all.judgements, code);
  keepOnly(all.answers, code);
  keepOnly(all.rules, code);
  return all;
}

/// The value at which the model is felt: as the procedure says, in the middle of what belongs to the word wholly.
double feltAt(const procedure::Procedure& procedure, const fuzzy::Variable& input) {
  const auto ids = procedure.inputIds();
  const auto place = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), input.id) - ids.begin());
  if (place == ids.size()) return std::midpoint(input.min, input.max);
  const procedure::InputNotes& notes = procedure.input_notes[place];
  const fuzzy::Term* const term = fuzzy::findTerm(input.terms, notes.own_model);
  if (term == nullptr) return std::clamp(notes.usual, input.min, input.max);
  const std::vector<double>& points = term->points;
  const double middle = points.size() == 4   ? std::midpoint(points[1], points[2])
                        : points.size() == 3 ? points[1]
                                             : points[0];
  return std::clamp(middle, input.min, input.max);
}

// From the middle of the overlap with the region before to that with the next.
std::vector<OwnRegion> regionsOf(const fuzzy::Variable& depth) {
  std::vector<OwnRegion> out;
  for (const fuzzy::Term& term : depth.terms) {
    if (term.points.size() != 4) continue;
    const double from_mm = (term.points[0] + term.points[1]) / 2;
    const double to_mm = (term.points[2] + term.points[3]) / 2;
    out.push_back({term.id, std::max(from_mm, depth.min), std::min(to_mm, depth.max)});
  }
  return out;
}

std::vector<QPointF> curveOf(const fuzzy::CompiledModel& compiled, std::vector<double> inputs, std::size_t depth,
                             const fuzzy::Variable& variable) {
  std::vector<QPointF> out;
  double largest_n = 0;
  for (int i = 0; i <= kCurvePoints; ++i) {
    inputs[depth] = variable.min + (variable.max - variable.min) * i / kCurvePoints;
    const fuzzy::Evaluation force = compiled.evaluate(inputs);
    if (!force.fired) continue;
    out.emplace_back(inputs[depth], force.force_n);
    largest_n = std::max(largest_n, force.force_n);
  }
  for (QPointF& point : out) point.setY(largest_n > 0 ? point.y() / largest_n : 0);
  return out;
}

}  // namespace

Result<OwnModel> ownModel(const store::StudyFile& file, const std::string& code) {
  TACTUS_TRY(auto view, session::studyForElicitation(file));
  elicitation::BuildSettings settings;
  settings.name = code;
  const auto now = std::chrono::system_clock::now();
  settings.created_utc = base::formatUtc(now);
  settings.generator = kGenerator;
  // The study is moved from below.
  const auto procedure = view.study.procedure != nullptr ? view.study.procedure : procedure::defaultProcedure();
  const auto forms = session::knownForms(*procedure);
  TACTUS_TRY(const auto built, elicitation::buildModel(dataOf(std::move(view.study), code), forms, settings));
  const fuzzy::ForceModel& model = built.model;
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));

  OwnModel out;
  std::vector<double> inputs;
  std::optional<std::size_t> depth;
  for (const fuzzy::Variable& input : model.inputs) {
    const fuzzy::Role role = fuzzy::roleOf(input);
    if (role == fuzzy::Role::kWay) depth = inputs.size();
    inputs.push_back(feltAt(*procedure, input));
    if (role == fuzzy::Role::kCondition) out.conditions[input.id] = inputs.back();
  }
  if (!depth) return base::fail(base::ErrorCode::kReference, "her model", "no way of a tip", "a model along the way");
  TACTUS_TRY(auto scene, haptics::ServoScene::make(model, compiled, out.conditions));
  out.scene = std::move(scene);
  out.version.utc_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  out.version.author = code;
  out.version.label = session::kOwnModelLabel;
  out.version.text = model_io::formatModel(model);
  out.regions = regionsOf(model.inputs[*depth]);
  out.curve = curveOf(compiled, inputs, *depth, model.inputs[*depth]);
  return out;
}

void OwnModelTrial::prepare(const std::string& code) {
  if (std::exchange(asked_, true) || !study_.takesOrders()) return;
  const auto made = std::make_shared<base::Result<OwnModel>>(base::fail(base::ErrorCode::kData, "", "", ""));
  study_.order(
      [made, code](store::StudyFile& file, study::RecordIds& ids) -> base::Result<void> {
        *made = ownModel(file, code);
        if (!*made) return {};
        auto version = (*made)->version;
        version.id = ids.next();
        (*made)->version.id = version.id;
        return store::append(file, version);
      },
      [self = QPointer(this), made] {
        if (!self) return;
        if (*made) {
          self->model_ = std::make_shared<const OwnModel>(std::move(**made));
        } else {
          self->refused_ = text(made->error().message());
        }
        emit self->changed();
      },
      [self = QPointer(this)](const QString& sentence) {
        if (!self) return;
        self->refused_ = sentence;
        emit self->changed();
      });
}

void OwnModelTrial::feel() {
  ForceOrders force;
  force.source = haptics::ForceSource::kInsertion;
  force.scene = model_->scene;
  force.scale = device_scale_;
  force.placement = device_.newNumber();
  force.start_depth_mm = model_->regions[region_].from_mm - model_->depthOffsetMm();
  device_.setForce(force);
}

void OwnModelTrial::look(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) {
    if (!sample.enabled || sample.source != haptics::ForceSource::kInsertion) continue;
    felt_ = sample;
    if (!pushed_from_mm_ || sample.depth_mm < *pushed_from_mm_) pushed_from_mm_ = sample.depth_mm;
    pushed_mm_ = std::max(pushed_mm_, sample.depth_mm - *pushed_from_mm_);
  }
}

session::OwnModelPlace OwnModelTrial::place() const {
  const haptics::Sample sample = felt_.value_or(device_.latest());
  return {model_->version.id, model_->regions[region_].id, sample.depth_mm + model_->depthOffsetMm(), sample.force_n};
}

session::Note OwnModelTrial::mark() {
  ++marks_;
  return session::ownModelMark(place());
}

session::Note OwnModelTrial::say(const QString& comparison) {
  using session::OwnModelVerdict;
  const auto verdict = comparison == QLatin1String("lighter")     ? OwnModelVerdict::kLighter
                       : comparison == QLatin1String("cant_tell") ? OwnModelVerdict::kCantTell
                       : comparison == QLatin1String("heavier")   ? OwnModelVerdict::kHeavier
                                                                  : OwnModelVerdict::kAboutRight;
  const auto note = session::ownModelVerdict(
      {model_->version.id, model_->regions[region_].id, {}, {}, pushed_mm_, model_->conditions}, verdict);
  marks_ = 0;
  felt_.reset();
  pushed_from_mm_.reset();
  pushed_mm_ = 0;
  if (region_ + 1 < model_->regions.size()) {
    ++region_;
  } else {
    done_ = true;
  }
  return note;
}

OwnModelState OwnModelTrial::state(bool runs) const {
  OwnModelState out;
  out.unavailable = refused_;
  out.marks = marks_;
  out.felt = wasFelt();
  out.ready = model_ != nullptr && runs;
  if (model_ == nullptr) return out;
  const OwnRegion& region = model_->regions[region_];
  out.region = QString::fromStdString(region.id);
  out.from_mm = region.from_mm;
  out.number = static_cast<int>(region_) + 1;
  out.count = static_cast<int>(model_->regions.size());
  return out;
}

const std::vector<QPointF>& OwnModelTrial::curve() const {
  static const std::vector<QPointF> kNone;
  return model_ != nullptr ? model_->curve : kNone;
}

}  // namespace tactus::workbench
