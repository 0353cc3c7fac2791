#include "app/workbench/report_parts.h"

#include <QAction>
#include <QFileInfo>
#include <chrono>
#include <memory>
#include <utility>

#include "app/report/study_report.h"
#include "app/session/data_checks.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/base/clock.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

// Takes a second for four participants and half a minute for 200.
base::Result<void> writeStudyReport(const session::StudyView& view, const session::StudyAside& aside,
                                    elicitation::BuildSettings settings, const QString& study_name,
                                    const std::string& path) {
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const auto data = session::dataFindings(view.study);
  if (auto ok = study::refuseData(data); !ok) return ok;
  const auto forms = session::knownForms();
  auto built = elicitation::hasRules(view.study) ? elicitation::buildModel(view.study, forms, settings)
                                                 : elicitation::buildTerms(view.study, settings);
  if (!built) return tl::unexpected(built.error());
  built->notes.insert(built->notes.begin(), view.notes.begin(), view.notes.end());
  const auto page = report::studyReport({.study = view.study,
                                         .built = *built,
                                         .build_settings = settings,
                                         .forms = forms,
                                         .data = data,
                                         .settings = {{"Study", study_name.toStdString()},
                                                      {"Program", std::string(kGenerator)},
                                                      {"Created (UTC)", settings.created_utc}},
                                         .usability = aside.usability});
  if (!page) return tl::unexpected(page.error());
  return base::writeFileAtomically(path, *page);
}

}  // namespace

ReportParts::ReportParts(MainWindow& window, StudyConnection& study, const LabData& labs)
    : window_(window),
      study_(study),
      labs_(labs),
      action_(window.menus().addAction(MenuSlot::kFilePictures, tr("Write the repor&t of the study…"))) {
  connect(action_, &QAction::triggered, this, &ReportParts::choose);
  connect(&study_, &StudyConnection::opened, this, &ReportParts::showState);
  connect(&study_, &StudyConnection::closed, this, [this] {
    busy_ = false;
    background_.drop();
    showState();
  });
  connect(this, &ReportParts::written, &window_,
          [this](const QString& path) { window_.say(tr("The report is written: %1").arg(shownFileName(path))); });
  connect(this, &ReportParts::failed, &window_, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The report was not written. %1").arg(sentence),
                                {tr("Choose another file…"), [this] { choose(); }});
  });
  showState();
}

void ReportParts::showState() { action_->setEnabled(study_.isOpen() && !busy_); }

void ReportParts::choose() {
  const QFileInfo study(study_.path());
  const QString proposed =
      study.absolutePath() + QLatin1Char('/') + study.completeBaseName() + QStringLiteral("-report.html");
  const QString path =
      file_dialog::getSaveFileName(&window_, tr("Report of the study"), proposed, tr("Web page (*.html)"));
  if (!path.isEmpty()) write(path);
}

void ReportParts::write(const QString& path) {
  if (busy_ || !study_.isOpen()) return;
  busy_ = true;
  showState();
  window_.say(tr("Writing the report…"));
  study_.read(*this, [this, path, settings = labs_.settings(), name = study_.fileName()](const store::StudyFile& file) {
    auto read = std::make_shared<base::Result<session::StudyView>>(session::studyForElicitation(file));
    auto aside = std::make_shared<base::Result<session::StudyAside>>(session::asideOf(file));
    return [this, path, settings, name, read, aside] {
      if (!*read) return end(path, text(read->error().message()));
      if (!*aside) return end(path, text(aside->error().message()));
      background_.run([this, path, settings, name, read, aside](const std::stop_token&) -> Background::Deliver {
        const auto done = writeStudyReport(**read, **aside, settings, name, path.toStdString());
        return [this, path, failure = done ? QString() : text(done.error().message())] { end(path, failure); };
      });
    };
  });
}

void ReportParts::end(const QString& path, const QString& failure) {
  busy_ = false;
  showState();
  if (failure.isEmpty()) {
    emit written(path);
  } else {
    emit failed(failure);
  }
}

}  // namespace tactus::workbench
