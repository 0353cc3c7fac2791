#include "app/workbench/deliver/bundle_maker.h"

#include <QDir>
#include <QFileInfo>
#include <chrono>
#include <memory>
#include <utility>

#include "app/bundle/bundle.h"
#include "app/bundle/file_errors.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/shown_procedure.h"
#include "core/analysis/force_difference.h"
#include "core/base/clock.h"

namespace tactus::workbench {

QString bundleName(const QString& model_path) {
  QString name = QFileInfo(model_path).fileName();
  for (const auto* ending : {".tactus.json", ".json", ".tactus"}) {
    if (!name.endsWith(QLatin1String(ending))) continue;
    name.chop(QLatin1String(ending).size());
    break;
  }
  if (name.isEmpty()) name = QStringLiteral("model");
  return name + QStringLiteral("-bundle");
}

QString bundleFolder(const QString& chosen, const QString& model_path) {
  if (bundle::mayHoldBundle(chosen.toStdString())) return chosen;
  return QDir(chosen).filePath(bundleName(model_path));
}

QString errorText(double newtons) { return BundleMaker::tr("%1 N").arg(QString::number(newtons, 'g', 2)); }

QString centroidText(const QString& rule) {
  const QString count = rule.section(QLatin1Char(':'), 1);
  if (rule.startsWith(QLatin1String("midpoint:"))) return BundleMaker::tr("middles of %1 cells").arg(count);
  if (rule.startsWith(QLatin1String("linspace:"))) return BundleMaker::tr("%1 points").arg(count);
  if (rule == QLatin1String("table")) return BundleMaker::tr("linear between nodes");
  return rule == QLatin1String("exact") ? BundleMaker::tr("exact") : rule;
}

std::vector<Column<DeliveredFile>> deliveredColumns() {
  using Row = DeliveredFile;
  return withRole<Row>(
      {{BundleMaker::tr("File"), &Row::path},
       {BundleMaker::tr("Largest error"),
        [](const Row& file) { return file.error_n ? errorText(*file.error_n) : QString(); }, Qt::AlignRight},
       {BundleMaker::tr("Tolerance"),
        [](const Row& file) { return file.error_n ? errorText(file.tolerance_n) : QString(); }, Qt::AlignRight},
       {BundleMaker::tr("Centroid"),
        [](const Row& file) { return file.ok ? centroidText(file.rule) : BundleMaker::tr("not as promised"); }}},
      Qt::ToolTipRole, [](const Row& file) { return file.ok ? file.path : file.wrong; });
}

namespace {

/// The sign-offs of the current state, the oldest first.
std::vector<model_io::Approval> approvalsOf(const editing::EditHistory& history) {
  std::vector<model_io::Approval> out;
  for (const editing::Event& event : history.events()) {
    if (event.kind != editing::EventKind::kSignOff || event.state != history.current()) continue;
    const std::chrono::system_clock::time_point at{std::chrono::milliseconds(event.stamp.utc_ms)};
    out.push_back({event.stamp.author, event.label, base::formatUtc(at)});
  }
  return out;
}

DeliveredFile shown(const model_io::FileCheck& check) {
  DeliveredFile file{text(check.file.path), {}, {}, 0, check.ok, text(check.wrong)};
  if (check.file.promise) {
    file.rule = text(check.file.promise->rule);
    file.error_n = check.largest_error_n;
    file.tolerance_n = check.file.promise->tolerance_n;
  }
  return file;
}

}  // namespace

BundleMaker::BundleMaker(EditController& edits, QObject* parent) : QObject(parent), edits_(edits) {
  connect(&edits_, &EditController::changed, this, [this] {
    const bool was_old = old_;
    compare();
    if (delivered_ && was_old != old_) emit changed();
  });
  // What was said of another model does not matter for this one.
  connect(&edits_, &EditController::modelReset, this, [this] {
    if (doing_ != Doing::kNothing) return;
    delivered_.reset();
    failure_.clear();
    emit changed();
  });
}

BundleMaker::~BundleMaker() { stop_.request_stop(); }

bool BundleMaker::mayCancel() const {
  return (doing_ == Doing::kMaking || doing_ == Doing::kWriting) && !stop_.stop_requested();
}

void BundleMaker::compare() {
  if (!delivered_ || !edits_.isOpen()) return;
  // It is not read during a drag.
  old_ = edits_.inGesture() || !analysis::modelChanges(delivered_->model, edits_.model()).empty();
}

BundleMaker::End BundleMaker::readBackIn(const QString& folder) {
  auto check = bundle::verifyBundle(folder.toStdString(), kGenerator);
  if (!check) return {std::nullopt, tr("The bundle was not read. %1").arg(text(check.error().message()))};
  Delivered out{folder, text(model_io::fingerprintText(check->fingerprint)), false, check->ok(), {}, {}, {}};
  for (const model_io::FileCheck& file : check->files) out.files.push_back(shown(file));
  out.model = std::move(check->model);
  return {std::move(out), {}};
}

void BundleMaker::begin(Doing doing, const QString& folder) {
  stop_ = std::stop_source();
  asked_ = doing;
  folder_ = folder;
  delivered_.reset();
  failure_.clear();
  tell(doing, 0, 0);
}

void BundleMaker::tell(Doing doing, std::size_t done, std::size_t all) {
  doing_ = doing;
  done_ = done;
  all_ = all;
  emit changed();
}

void BundleMaker::make(const QString& folder) {
  if (doing_ != Doing::kNothing || !edits_.isOpen()) return;
  edits_.commit();
  begin(Doing::kMaking, folder);
  const auto told = [this](Doing doing, std::size_t done, std::size_t all) {
    answers_.post([this, doing, done, all] { tell(doing, done, all); });
  };
  worker_.run([this, folder, told, stop = stop_.get_token(), model = edits_.history().ready(),
               approvals = approvalsOf(edits_.history()),
               procedure = shownProcedure()](const std::stop_token&) -> Background::Deliver {
    const auto end = [this](End what) -> Background::Deliver {
      return [this, what = std::make_shared<End>(std::move(what))] { onEnd(std::move(*what)); };
    };
    const auto failed = [&end](const base::Error& error) {
      return end({std::nullopt, error.code == base::ErrorCode::kCancelled
                                    ? tr("Canceled: nothing was written.")
                                    : tr("The bundle was not made. %1").arg(text(error.message()))});
    };
    const bundle::BundleSettings settings{
        {},
        base::formatUtc(std::chrono::system_clock::now()),
        std::string(kGenerator),
        std::nullopt,
        stop,
        [&told](std::size_t done, std::size_t all) { told(Doing::kMaking, done, all); },
        approvals,
        procedure};
    // A folder that may not be taken is said before the work.
    if (const auto ok = bundle::mayHoldBundle(folder.toStdString()); !ok) return failed(ok.error());
    const auto made = bundle::makeBundle(model->model, settings);
    if (!made) return failed(made.error());
    told(Doing::kWriting, made->files.size(), made->files.size());
    if (const auto written = bundle::writeBundle(*made, folder.toStdString(), stop); !written)
      return failed(written.error());
    told(Doing::kReadingBack, made->files.size(), made->files.size());
    End out = readBackIn(folder);
    if (out.delivered) {
      out.delivered->made = true;
      for (const std::string& warning : made->warnings) out.delivered->warnings << text(warning);
    }
    return end(std::move(out));
  });
}

void BundleMaker::readBack(const QString& folder) {
  if (doing_ != Doing::kNothing) return;
  begin(Doing::kReadingBack, folder);
  worker_.run([this, folder](const std::stop_token&) -> Background::Deliver {
    auto end = std::make_shared<End>(readBackIn(folder));
    return [this, end] { onEnd(std::move(*end)); };
  });
}

void BundleMaker::cancel() {
  if (!mayCancel()) return;
  stop_.request_stop();
  emit changed();
}

void BundleMaker::onEnd(End end) {
  delivered_ = std::move(end.delivered);
  failure_ = std::move(end.failure);
  compare();
  tell(Doing::kNothing, 0, 0);
}

}  // namespace tactus::workbench
