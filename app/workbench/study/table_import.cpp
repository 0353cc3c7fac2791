#include "app/workbench/study/table_import.h"

#include <QFileInfo>
#include <functional>
#include <utility>

#include "app/session/data_checks.h"
#include "app/session/study_import.h"
#include "app/session/study_source.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/study/data_finding.h"

namespace tactus::workbench {

void TableImport::run(const QString& folder, const QString& path, bool as_they_are) {
  if (running_) return;
  running_ = true;
  worker_.post([this, folder, path, as_they_are] {
    const auto answer = [this](std::function<void()> say) {
      answers_.post([this, say = std::move(say)] {
        running_ = false;
        say();
      });
    };
    const auto fail = [&](const base::Error& error) {
      answer([this, sentence = text(error.message())] { emit failed(sentence); });
    };
    const std::string from = folder.toStdString();
    const auto tables = session::readTables(from);
    if (!tables) return fail(tables.error());
    const auto data = session::dataFindings(tables->study);
    if (const auto ok = study::refuseData(data); !ok && !as_they_are) {
      const QString sentence = text(ok.error().message());
      return answer([this, folder, path, sentence] { emit doubted(folder, path, sentence); });
    }
    if (const auto ok = study::refuseData(data, study::kAcceptable); !ok) return fail(ok.error());
    const auto source = session::tablesSource(from, tables->study.name, utcNowMs());
    if (!source) return fail(source.error());
    const auto made = session::importAsNewStudy(tables->study, path.toStdString(), *source, std::string(kGenerator));
    if (!made) return fail(made.error());
    QString notes = tr("%n participant(s) imported from %1.", nullptr, static_cast<int>(made->persons))
                        .arg(harmless(QFileInfo(folder).fileName()));
    for (const std::string& note : tables->notes) notes += QLatin1Char(' ') + text(note);
    answer([this, path, notes] { emit imported(path, notes); });
  });
}

}  // namespace tactus::workbench
