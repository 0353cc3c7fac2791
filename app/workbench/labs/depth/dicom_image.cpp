#include "app/workbench/labs/depth/dicom_image.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QStringList>
#include <QTemporaryDir>
#include <utility>
#include <vector>

#include "app/workbench/labs/depth/dicom_facts.h"
#include "app/workbench/labs/depth/installed_program.h"

namespace tactus::workbench {
namespace {

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
