#include "app/workbench/shell/demo_maker.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/demo/demo_folder.h"
#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

// Not translated: a copy is found again in another language.
QString demoFolder(const QString& documents, int copy) {
  const QString name = QStringLiteral("Tactus demo");
  return QDir(documents).absoluteFilePath(copy == 1 ? name : name + QLatin1Char(' ') + QString::number(copy));
}

int copiesIn(const QString& documents) {
  int copies = 0;
  while (QFileInfo::exists(demoFolder(documents, copies + 1))) ++copies;
  return copies;
}

}  // namespace

DemoMaker::DemoMaker(const QString& documents, QObject* parent) : QObject(parent) { setDocuments(documents); }

void DemoMaker::setDocuments(const QString& documents) {
  documents_ = documents;
  folder_ = demoFolder(documents_, std::max(1, copiesIn(documents_)));
  emit changed();
}

QString DemoMaker::study() const {
  return folder_ + QLatin1Char('/') +
         QString::fromUtf8(demo::kStudyFile.data(), static_cast<qsizetype>(demo::kStudyFile.size()));
}

bool DemoMaker::isThere() const { return QFileInfo::exists(study()); }

QString DemoMaker::partText() const {
  if (!making_) return {};
  switch (static_cast<demo::DemoPart>(done_)) {
    case demo::DemoPart::kSessions: return tr("Four simulated nurses go through their sessions…");
    case demo::DemoPart::kModel: return tr("Their answers become a model…");
    case demo::DemoPart::kReport: return tr("The tables and figures of the report are drawn…");
    case demo::DemoPart::kFiles: return tr("The files are written…");
  }
  return {};
}

void DemoMaker::explore() {
  if (isThere()) {
    emit ready(study());
  } else if (!making_) {
    make();
  }
}

void DemoMaker::makeFresh() {
  if (making_) return;
  folder_ = demoFolder(documents_, copiesIn(documents_) + 1);
  make();
}

void DemoMaker::make() {
  making_ = true;
  tell(0);
  worker_.post([this, folder = folder_.toStdString()] {
    const auto made = demo::writeDemo(
        {folder}, [this](demo::DemoPart part) { answers_.post([this, part] { begin(static_cast<int>(part)); }); });
    const QString failure = made ? QString() : text(made.error().message());
    answers_.post([this, failure] { end(failure); });
  });
}

// The study is whole before its report is; the user need not wait for the report.
void DemoMaker::begin(int part) {
  tell(part);
  if (part == static_cast<int>(demo::DemoPart::kModel)) emit ready(study());
}

void DemoMaker::tell(int done) {
  done_ = done;
  emit changed();
}

void DemoMaker::end(const QString& failure) {
  making_ = false;
  tell(0);
  if (!failure.isEmpty()) emit failed(tr("The demo study was not made. %1").arg(failure));
}

}  // namespace tactus::workbench
