#include "app/workbench/study/connection/study_orders.h"

#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using base::Result;

constexpr int kSlowMs = 200;    // design: a write that takes longer is shown
constexpr int kRetryMs = 3000;  // a disk that refused is asked again

}  // namespace

StudyOrders::StudyOrders(StudyWorker& worker, CallQueue& answers, QObject* parent)
    : QObject(parent), worker_(worker), answers_(answers) {
  slow_timer_.setSingleShot(true);
  slow_timer_.setInterval(kSlowMs);
  retry_.setSingleShot(true);
  retry_.setInterval(kRetryMs);
  connect(&slow_timer_, &QTimer::timeout, this, [this] {
    slow_ = isBusy();
    emit changed();
  });
  connect(&retry_, &QTimer::timeout, this, &StudyOrders::tryAgain);
}

void StudyOrders::add(Work work, Done done, Refused refused) {
  waiting_.push_back({std::move(done), std::move(refused)});
  worker_.post([this, work = std::move(work)](StudyWorker::Desk& desk) {
    desk.works.push_back({work, [this](const Result<void>& written) {
                            const auto error = written ? std::nullopt : std::optional(written.error());
                            answers_.post([this, error] { onAnswer(error); });
                          }});
    desk.catchUp();
  });
  if (!slow_timer_.isActive()) slow_timer_.start();
}

void StudyOrders::tryAgain() {
  retry_.stop();
  if (isBusy()) worker_.post([](StudyWorker::Desk& desk) { desk.catchUp(); });
}

void StudyOrders::whenWritten(std::function<void(bool)> then) {
  worker_.post([this, then = std::move(then)](StudyWorker::Desk& desk) {
    answers_.post([then, done = desk.catchUp()] { then(done); });
  });
}

void StudyOrders::onAnswer(const std::optional<base::Error>& error) {
  if (error && error->code == base::ErrorCode::kIo) {
    retry_.start();
    setFailure(text(error->message()));
    return;
  }
  const Waiting waited = std::move(waiting_.front());
  waiting_.pop_front();
  if (error) {
    waited.refused(text(error->message()));
  } else if (waited.done) {
    waited.done();
  }
  if (!isBusy()) {
    slow_timer_.stop();
    retry_.stop();
    slow_ = false;
  }
  setFailure({});
}

void StudyOrders::setFailure(const QString& sentence) {
  const bool is_new = sentence != failure_ && !sentence.isEmpty();
  failure_ = sentence;
  if (is_new) emit failed(tr("Not stored, and tried again every few seconds: %1").arg(sentence));
  emit changed();
}

}  // namespace tactus::workbench
