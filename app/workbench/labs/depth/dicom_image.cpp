#include "app/workbench/labs/depth/dicom_image.h"

#include <QBuffer>
#include <QByteArray>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tactus::workbench {
namespace {

/// Runs programs that are installed beside this one, one after another, and waits for each.
struct ProgramRun {
  bool ok = false;
  QByteArray said;  ///< what it printed; if it failed, its errors
};

constexpr int kDecodeMs = 60'000;  // a scan of the whole body takes some seconds

/// The path of an installed program; empty without it.
QString installedProgram(const char* name) { return QStandardPaths::findExecutable(QLatin1String(name)); }

/// Waits for its end, at most a minute. Thread: any but the gui.
ProgramRun runProgram(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments, QIODevice::ReadOnly);
  if (!process.waitForFinished(kDecodeMs)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  const bool ok = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
  return {ok, ok ? process.readAllStandardOutput() : process.readAllStandardError()};
}

/// What a DICOM file holds, as the installed programs of DCMTK or GDCM print it.
struct DicomFacts {
  int pictures = 1;
  std::optional<double> mm_per_px;  ///< nothing without a spacing that is the same in both directions
  bool has_picture = true;
  bool ends_early = false;
  QString compression;  ///< the transfer syntax, e.g. `JPEG2000LosslessOnly`; empty if it is unknown
};

constexpr double kSameSpacing = 1e-3;  // of both directions, relative

/// The value of a tag of the file's top level: `(0028,0008) IS [10]`, `(0002,0010) UI =JPEGBaseline`.
QString valueOf(const QString& printed, const char* tag) {
  const QRegularExpression line(QStringLiteral("^\\(%1\\) .. (?:=|\\[)([^\\]\\s]*)").arg(QLatin1String(tag)),
                                QRegularExpression::MultilineOption);
  return line.match(printed).captured(1);
}

/// `[0.33\0.33]` behind the tag.
std::optional<double> spacingIn(const QString& printed, const char* tag) {
  const QRegularExpression line(
      QStringLiteral("\\(%1\\)[^\\[]*\\[\\s*([0-9.eE+-]+)\\s*\\\\\\s*([0-9.eE+-]+)\\s*\\]").arg(QLatin1String(tag)));
  const auto found = line.match(printed);
  if (!found.hasMatch()) return std::nullopt;
  const double rows = found.captured(1).toDouble();
  const double columns = found.captured(2).toDouble();
  if (!(rows > 0) || std::abs(rows - columns) > kSameSpacing * rows) return std::nullopt;
  return rows;
}

DicomFacts factsIn(const QString& printed) {
  DicomFacts facts;
  facts.has_picture = printed.contains(QLatin1String("(7fe0,0010)"));
  if (facts.has_picture) facts.pictures = std::max(1, valueOf(printed, "0028,0008").toInt());
  facts.compression = valueOf(printed, "0002,0010");
  // Pixel spacing, that of the imager's plate, that of a scanned film.
  for (const char* tag : {"0028,0030", "0018,1164", "0018,2010"}) {
    if (!facts.mm_per_px) facts.mm_per_px = spacingIn(printed, tag);
  }
  return facts;
}

/// The facts of the file at `path`; of a file that no program prints only the defaults. Thread: any but the gui.
DicomFacts dicomFacts(const QString& path) {
  bool ends_early = false;
  for (const char* name : {"dcmdump", "gdcmdump"}) {
    const QString program = installedProgram(name);
    if (program.isEmpty()) continue;
    const ProgramRun dump = runProgram(program, {path});
    ends_early = ends_early || (!dump.ok && dump.said.contains("premature end"));
    if (!dump.ok) continue;
    DicomFacts facts = factsIn(QString::fromLatin1(dump.said));
    facts.ends_early = ends_early;
    return facts;
  }
  DicomFacts facts;
  facts.ends_early = ends_early;
  return facts;
}

using base::ErrorCode;
using base::fail;

constexpr qsizetype kPreamble = 128;  // bytes before the letters DICM

struct Command {
  QString program;
  QStringList arguments;
};
/// Commands one after another, of which the last writes `out`.
struct Way {
  std::vector<Command> commands;
  QString out;
};

/// The ways of the installed programs to picture number `picture`, the best first.
std::vector<Way> waysOf(const QTemporaryDir& folder, const QString& in, int picture) {
  const QString png = folder.filePath(QStringLiteral("out.png"));
  const QString plain = folder.filePath(QStringLiteral("plain.dcm"));
  const QStringList frame =
      picture > 1 ? QStringList{QStringLiteral("--frame"), QString::number(picture)} : QStringList();
  std::vector<Way> ways;
  // The window of gray values that the file brings; without one, all of them. The first two also know compressed files.
  const auto addDcmtk = [&](const std::vector<Command>& before, const QString& from) {
    for (const char* name : {"dcmj2pnm", "dcml2pnm", "dcm2pnm", "dcm2img"}) {
      const QString program = installedProgram(name);
      if (program.isEmpty()) continue;
      for (const QStringList& window : {QStringList{QStringLiteral("--use-window"), QStringLiteral("1")},
                                        QStringList{QStringLiteral("--min-max-window")}}) {
        Way way{before, png};
        way.commands.push_back(
            {program, QStringList{QStringLiteral("--write-png")} + window + frame + QStringList{from, png}});
        ways.push_back(std::move(way));
      }
    }
  };
  addDcmtk({}, in);
  // GDCM knows more compressions.
  const QString unpack = installedProgram("gdcmconv");
  if (unpack.isEmpty()) return ways;
  const std::vector<Command> unpacked = {{unpack, {QStringLiteral("--raw"), in, plain}}};
  addDcmtk(unpacked, plain);
  // It writes the first picture of several.
  if (const QString program = installedProgram("gdcmimg"); !program.isEmpty() && picture == 1) {
    const QString gray = folder.filePath(QStringLiteral("out.pgm"));
    Way way{unpacked, gray};
    way.commands.push_back({program, {plain, gray}});
    ways.push_back(std::move(way));
  }
  return ways;
}

/// What `way` wrote, as PNG; nothing if it fails.
QByteArray pictureBy(const Way& way) {
  for (const Command& one : way.commands) {
    if (!runProgram(one.program, one.arguments).ok) return {};
  }
  const QImage image(way.out);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (image.isNull() || !image.save(&buffer, "PNG")) return {};
  return png;
}

/// Why no way led to a picture.
tl::unexpected<base::Error> refused(const std::string& file, const DicomFacts& facts) {
  if (!facts.has_picture) return fail(ErrorCode::kSyntax, file, "a DICOM file without an image", "one with an image");
  if (facts.ends_early) {
    return fail(ErrorCode::kSyntax, file, "a DICOM image that ends too early", "the whole file: copy it again");
  }
  const std::string how = facts.compression.isEmpty() ? "" : " (" + facts.compression.toStdString() + ")";
  return fail(ErrorCode::kSyntax, file, "a DICOM image that the installed programs cannot convert" + how,
              "one without compression, or PNG, JPEG or TIFF");
}

/// `bytes` as a file for the programs.
base::Result<void> writeCopy(const QByteArray& bytes, const QString& path, const std::string& file) {
  QFile copy(path);
  if (copy.open(QIODevice::WriteOnly) && copy.write(bytes) == bytes.size()) return {};
  return fail(ErrorCode::kIo, file, copy.errorString().toStdString(),
              "room for a copy in the folder of temporary files");
}

}  // namespace

bool isDicom(const QByteArray& bytes) { return bytes.mid(kPreamble, 4) == "DICM"; }

int dicomPictures(const QByteArray& bytes) {
  const QTemporaryDir folder;
  const QString in = folder.filePath(QStringLiteral("in.dcm"));
  return writeCopy(bytes, in, {}) ? dicomFacts(in).pictures : 1;
}

base::Result<DicomImage> dicomImage(const QByteArray& bytes, const QString& name, int picture) {
  const std::string file = name.toStdString();
  const QTemporaryDir folder;
  const QString in = folder.filePath(QStringLiteral("in.dcm"));
  const auto ways = waysOf(folder, in, picture);
  if (ways.empty()) {
    return fail(ErrorCode::kSyntax, file, "a DICOM image",
                picture > 1
                    ? "PNG, JPEG or TIFF, or the package dcmtk, whose programs take one picture of several"
                    : "PNG, JPEG or TIFF, or one of the packages dcmtk and libgdcm-tools, whose programs convert it");
  }
  if (auto ok = writeCopy(bytes, in, file); !ok) return tl::unexpected(ok.error());
  const DicomFacts facts = dicomFacts(in);
  if (!facts.has_picture || facts.ends_early) return refused(file, facts);
  for (const Way& way : ways) {
    QByteArray png = pictureBy(way);
    if (!png.isEmpty()) return DicomImage{std::move(png), facts.mm_per_px};
  }
  return refused(file, facts);
}

}  // namespace tactus::workbench
