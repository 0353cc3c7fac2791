#include "app/workbench/labs/depth/depth_lab.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/store/study_records.h"

namespace tactus::workbench {
namespace {

std::int64_t utcNow() {
  using std::chrono::milliseconds;
  return std::chrono::duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

DepthLab::DepthLab(LabData& data, std::function<QString()> author, QObject* parent)
    : UndoSource(parent), data_(data), author_(std::move(author)) {
  beginAnew();
  connect(&data_.connection(), &StudyConnection::opened, this, &DepthLab::read);
  connect(&data_.connection(), &StudyConnection::closed, this, &DepthLab::beginAnew);
  connect(&data_, &LabData::settingsChanged, this, &DepthLab::depthsFromChanged);
  connect(&data_, &LabData::studyChanged, this, &DepthLab::depthsFromChanged);
}

void DepthLab::setDepthsFrom(elicitation::DepthsFrom from) {
  if (from == depthsFrom()) return;
  auto settings = data_.settings();
  settings.depths = from;
  if (from == elicitation::DepthsFrom::kMeasured) settings.measured_depths = states_[done_].measurement;
  data_.setSettings(std::move(settings));
}

void DepthLab::setSeen(bool seen) {
  seen_ = seen;
  if (seen && !is_read_) read();
}

void DepthLab::read() {
  is_read_ = false;
  beginAnew();
  kept_ = std::make_shared<std::vector<Kept>>();
  if (!seen_ || !data_.connection().isOpen()) return;
  is_read_ = true;
  data_.connection().read(
      *this,
      [this, kept = kept_, path = data_.connection().path()](const store::StudyFile& file) -> StudyConnection::Deliver {
        auto stored = store::depthMeasurement(file);
        QString sentence = stored ? QString() : text(stored.error().message());
        State state;
        if (stored && *stored) {
          if (auto read = elicitation::readMeasurement((*stored)->text)) {
            state.measurement = std::move(*read);
            state.image = std::make_shared<const QByteArray>(QByteArray::fromStdString((*stored)->image));
            if (!state.image->isEmpty()) kept->push_back({state.image, (*stored)->image_of.value_or((*stored)->id)});
          } else {
            sentence = text(read.error().message());
          }
        }
        const bool found = stored && *stored && sentence.isEmpty();
        return [this, path, found, state, sentence] {
          if (path != data_.connection().path()) return;
          if (!sentence.isEmpty()) {
            emit refused(tr("The stored measurement was not read. %1").arg(sentence), {tr("Try again"), [this] {
                                                                                         if (states_.size() == 1)
                                                                                           read();
                                                                                       }});
          }
          // What was begun meanwhile stays.
          if (!found || states_.size() != 1) return;
          emit done();
          data_.setMeasuredDepths(state.measurement);
          begin(state);
        };
      });
}

void DepthLab::beginAnew() {
  const fuzzy::Variable& way = data_.connection().procedure()->wayInput();
  const bool other = way != depth_;
  if (other) depth_ = terms_ = way;
  begin({elicitation::emptyMeasurement(depth_)});
  if (other) emit depthChanged();
}

void DepthLab::begin(State state) {
  states_ = {std::move(state)};
  go(0);
}

void DepthLab::go(std::size_t state) {
  done_ = state;
  const bool other_image =
      states_[state].image != now_.image || states_[state].measurement.example != now_.measurement.example;
  now_ = states_[state];
  refreshState();
  if (other_image) emit imageChanged();
  emit measurementChanged();
  emit changed();
}

void DepthLab::show(const elicitation::DepthMeasurement& measurement) {
  if (measurement == now_.measurement) return;
  now_.measurement = measurement;
  refreshState();
  emit measurementChanged();
}

void DepthLab::refreshState() {
  path_.reset();
  problem_.clear();
  if (now_.measurement.path.size() >= 2) {
    if (auto made = elicitation::TubePath::through(now_.measurement.path, now_.measurement.mm_per_px)) {
      path_ = std::move(*made);
    } else {
      problem_ = text(made.error().message());
    }
  }
  if (auto terms = elicitation::depthTerms(depth_, now_.measurement.boundaries, now_.measurement.scale)) {
    terms_.terms = std::move(*terms);
  } else {
    problem_ = text(terms.error().message());
  }
}

void DepthLab::commit(const QString& what) {
  if (now_.measurement == states_[done_].measurement) return;
  State next = now_;
  next.what = what;
  add(std::move(next));
}

void DepthLab::add(State next) {
  states_.resize(done_ + 1);
  states_.push_back(std::move(next));
  go(states_.size() - 1);
  store();
}

void DepthLab::setImage(const QByteArray& bytes, const QString& name, std::optional<double> mm_per_px) {
  State next{elicitation::emptyMeasurement(depth_), std::make_shared<const QByteArray>(bytes),
             tr("image %1").arg(name)};
  next.measurement.nose_ear_xiphoid_mm = now_.measurement.nose_ear_xiphoid_mm;
  next.measurement.image = name.toStdString();
  if (mm_per_px) next.measurement.mm_per_px = *mm_per_px;
  add(std::move(next));
}

void DepthLab::setExample(double mm_per_px, std::vector<elicitation::ImagePoint> path) {
  State next{elicitation::emptyMeasurement(depth_), std::make_shared<const QByteArray>(), tr("the example")};
  next.measurement.nose_ear_xiphoid_mm = now_.measurement.nose_ear_xiphoid_mm;
  next.measurement.example = true;
  next.measurement.image = tr("Anatomy drawing").toStdString();
  next.measurement.mm_per_px = mm_per_px;
  next.measurement.path = std::move(path);
  add(std::move(next));
}

void DepthLab::undo() {
  if (!canUndo()) return;
  go(done_ - 1);
  store();
}

void DepthLab::redo() {
  if (!canRedo()) return;
  go(done_ + 1);
  store();
}

void DepthLab::store() {
  data_.setMeasuredDepths(now_.measurement);
  emit depthsFromChanged();
  if (!data_.connection().takesOrders()) return;
  last_ms_ = std::max(utcNow(), last_ms_ + 1);
  const auto id = std::make_shared<std::optional<study::RecordId>>();
  data_.connection().order(
      [id, kept = kept_, image = now_.image, measured = elicitation::toText(now_.measurement),
       author = author_().toStdString(), utc_ms = last_ms_](store::StudyFile& file, study::RecordIds& ids) {
        if (!*id) *id = ids.next();
        study::DepthRecord record{**id, utc_ms, author, measured, std::nullopt, {}};
        const auto there =
            std::find_if(kept->begin(), kept->end(), [&image](const Kept& one) { return one.image == image; });
        if (there != kept->end()) {
          record.image_of = there->record;
        } else {
          record.image = image->toStdString();
        }
        auto stored = store::append(file, record);
        if (stored && there == kept->end() && !image->isEmpty()) kept->push_back({image, record.id});
        return stored;
      },
      [this] { emit done(); },
      [this](const QString& sentence) {
        emit refused(tr("The measurement was not stored. %1").arg(sentence), {tr("Try again"), [this] { store(); }});
      });
}

}  // namespace tactus::workbench
