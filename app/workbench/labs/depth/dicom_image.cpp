#include "app/workbench/labs/depth/dicom_image.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStringList>
#include <QTemporaryDir>
#include <cmath>
#include <utility>
#include <vector>

namespace tactus::workbench {
namespace {

using base::ErrorCode;
using base::fail;

constexpr qsizetype kPreamble = 128;   // bytes before the letters DICM
constexpr int kPatienceMs = 60'000;    // a scan of the whole body takes some seconds
constexpr double kSameSpacing = 1e-3;  // of both directions, relative

struct DicomText {
  Q_DECLARE_TR_FUNCTIONS(DicomText)
};

struct Done {
  bool ok = false;
  QByteArray said;
};

Done runProgram(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments, QIODevice::ReadOnly);
  if (!process.waitForFinished(kPatienceMs)) {
    process.kill();
    process.waitForFinished();
    return {false, DicomText::tr("took longer than a minute").toUtf8()};
  }
  const bool ok = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
  return {ok, ok ? process.readAllStandardOutput() : process.readAllStandardError()};
}

struct Command {
  QString program;
  QStringList arguments;
};
/// Commands one after another, of which the last writes `out`.
struct Way {
  std::vector<Command> commands;
  QString out;
};

/// The ways of the installed programs, the best first.
std::vector<Way> waysOf(const QTemporaryDir& folder, const QString& in) {
  const auto installed = [](const char* name) { return QStandardPaths::findExecutable(QLatin1String(name)); };
  const QString png = folder.filePath(QStringLiteral("out.png"));
  const QString plain = folder.filePath(QStringLiteral("plain.dcm"));
  std::vector<Way> ways;
  // The window of gray values that the file brings; without one, all of them. The first two also know compressed files.
  const auto addDcmtk = [&](const std::vector<Command>& before, const QString& from) {
    for (const char* name : {"dcmj2pnm", "dcml2pnm", "dcm2pnm", "dcm2img"}) {
      const QString program = installed(name);
      if (program.isEmpty()) continue;
      for (const QStringList& window : {QStringList{QStringLiteral("--use-window"), QStringLiteral("1")},
                                        QStringList{QStringLiteral("--min-max-window")}}) {
        Way way{before, png};
        way.commands.push_back({program, QStringList{QStringLiteral("--write-png")} + window + QStringList{from, png}});
        ways.push_back(std::move(way));
      }
    }
  };
  addDcmtk({}, in);
  // GDCM knows more compressions.
  const QString unpack = installed("gdcmconv");
  if (unpack.isEmpty()) return ways;
  const std::vector<Command> unpacked = {{unpack, {QStringLiteral("--raw"), in, plain}}};
  addDcmtk(unpacked, plain);
  if (const QString program = installed("gdcmimg"); !program.isEmpty()) {
    const QString gray = folder.filePath(QStringLiteral("out.pgm"));
    Way way{unpacked, gray};
    way.commands.push_back({program, {plain, gray}});
    ways.push_back(std::move(way));
  }
  return ways;
}

/// What `way` wrote, as PNG; nothing, and what was said, if it fails.
QByteArray pictureBy(const Way& way, QByteArray& said) {
  for (const Command& one : way.commands) {
    const Done done = runProgram(one.program, one.arguments);
    if (done.ok) continue;
    said = done.said;
    return {};
  }
  const QImage image(way.out);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (image.isNull() || !image.save(&buffer, "PNG")) return {};
  return png;
}

/// `[0.33\0.33]` behind the tag in what a program prints.
std::optional<double> spacingIn(const QByteArray& said, const char* tag) {
  const QRegularExpression line(
      QStringLiteral("\\(%1\\)[^\\[]*\\[\\s*([0-9.eE+-]+)\\s*\\\\\\s*([0-9.eE+-]+)\\s*\\]").arg(QLatin1String(tag)));
  const auto found = line.match(QString::fromLatin1(said));
  if (!found.hasMatch()) return std::nullopt;
  const double rows = found.captured(1).toDouble();
  const double columns = found.captured(2).toDouble();
  if (!(rows > 0) || std::abs(rows - columns) > kSameSpacing * rows) return std::nullopt;
  return rows;
}

std::optional<double> spacingOf(const QString& in) {
  for (const char* name : {"dcmdump", "gdcmdump"}) {
    const QString program = QStandardPaths::findExecutable(QLatin1String(name));
    if (program.isEmpty()) continue;
    const Done dump = runProgram(program, {in});
    if (!dump.ok) continue;
    // Pixel spacing, that of the imager's plate, that of a scanned film.
    for (const char* tag : {"0028,0030", "0018,1164", "0018,2010"}) {
      if (const auto spacing = spacingIn(dump.said, tag)) return spacing;
    }
  }
  return std::nullopt;
}

}  // namespace

bool isDicom(const QByteArray& bytes) { return bytes.mid(kPreamble, 4) == "DICM"; }

base::Result<DicomImage> dicomImage(const QByteArray& bytes, const QString& name) {
  const std::string file = name.toStdString();
  const QTemporaryDir folder;
  const QString in = folder.filePath(QStringLiteral("in.dcm"));
  const auto ways = waysOf(folder, in);
  if (ways.empty()) {
    return fail(ErrorCode::kSyntax, file, "a DICOM image",
                "PNG, JPEG or TIFF, or one of the packages dcmtk and libgdcm-tools, whose programs convert it");
  }
  QFile copy(in);
  if (!folder.isValid() || !copy.open(QIODevice::WriteOnly) || copy.write(bytes) != bytes.size()) {
    return fail(ErrorCode::kIo, file, copy.errorString().toStdString(),
                "room for a copy in the folder of temporary files");
  }
  copy.close();
  QByteArray said;
  for (const Way& way : ways) {
    QByteArray png = pictureBy(way, said);
    if (!png.isEmpty()) return DicomImage{std::move(png), spacingOf(in)};
  }
  return fail(ErrorCode::kSyntax, file, "a DICOM image that cannot be converted: " + said.simplified().toStdString(),
              "a DICOM image with a picture");
}

}  // namespace tactus::workbench
