// tactus-workbench [MODEL|STUDY]: the program with a window.
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QLocale>
#include <QSettings>
#include <csignal>

#include "app/version.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/translation.h"
#include "app/workbench/workbench.h"

int main(int argc, char** argv) {
  // A limit on the size of files is then an error that is told, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("Tactus"));
  QApplication::setApplicationName(QStringLiteral("tactus-workbench"));
  QApplication::setApplicationDisplayName(QStringLiteral("Tactus Workbench"));
  QApplication::setApplicationVersion(
      QString::fromUtf8(tactus::kVersion.data(), static_cast<qsizetype>(tactus::kVersion.size())));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/tactus/icon.svg")));

  tactus::workbench::installTranslations(application, QLocale());

  QCommandLineParser arguments;
  arguments.setApplicationDescription(QCoreApplication::translate("main", "Explore force models of expert nurses."));
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.addPositionalArgument(QStringLiteral("file"),
                                  QCoreApplication::translate("main", "A model (*.tactus.json) or a study (*.tactus)."),
                                  QStringLiteral("[file]"));
  arguments.process(application);

  QSettings settings;
  tactus::workbench::theme::apply(application, tactus::workbench::theme::storedLook(settings));
  tactus::workbench::Workbench workbench(settings);
  workbench.window.show();
  if (!arguments.positionalArguments().isEmpty()) workbench.files.open(arguments.positionalArguments().first());
  return QApplication::exec();
}
