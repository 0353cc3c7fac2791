#include "core/store/journal_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/files/checksums.h"

namespace tactus::store {
namespace {

constexpr std::string_view kMarkBegin = "TACTUSok";
constexpr std::size_t kTokenBytes = 16;
constexpr std::size_t kHeaderBytes = 32;
constexpr std::size_t kFrameHeaderBytes = 24;
constexpr std::uint32_t kMagic = 0x377F0682;  // the lowest bit says in which order of bytes the checksums are made

std::uint32_t word(std::string_view bytes, std::size_t at, bool big_endian = true) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[at + (big_endian ? i : 3 - i)]);
    value = value << 8U | byte;
  }
  return value;
}

using Sums = std::array<std::uint32_t, 2>;

Sums sumsOf(std::string_view bytes, Sums sums, bool big_endian) {
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
    sums[0] += word(bytes, at, big_endian) + sums[1];
    sums[1] += word(bytes, at + 4, big_endian) + sums[0];
  }
  return sums;
}

/// Goes through the frames of a journal whose header fits.
class FrameReader {
 public:
  /// Both must outlive the reader.
  FrameReader(std::ifstream& in, const std::string& header)
      : in_(in),
        header_(header),
        big_endian_((word(header_, 0) & 1U) != 0),
        frame_(kFrameHeaderBytes + word(header_, 8), '\0') {
    sums_ = {word(header_, 24), word(header_, 28)};
  }

  void read(JournalFile& journal) {
    long long at = kHeaderBytes;
    bool readable = true;
    for (; next(); at += static_cast<long long>(frame_.size())) {
      const bool own = frame_.compare(8, 8, header_, 16, 8) == 0;
      const bool fits = own && word(frame_, 0) != 0 && fitsFrameBefore();
      if (readable && !fits) {
        readable = false;
        journal.ends_in_file = !own;
      }
      const bool commit = word(frame_, 4) != 0;
      if (fits && commit && readable) {
        ++journal.commits;
        journal.readable_bytes = at + static_cast<long long>(frame_.size());
      }
      if (fits && commit && !readable) ++journal.commits_behind;
      // Where a frame is broken, the next one is still judged by the checksum that stands in it.
      sums_ = {word(frame_, 16), word(frame_, 20)};
    }
  }

 private:
  bool next() { return static_cast<bool>(in_.read(frame_.data(), static_cast<std::streamsize>(frame_.size()))); }
  bool fitsFrameBefore() const {
    const std::string_view frame = frame_;
    Sums sums = sumsOf(frame.substr(0, 8), sums_, big_endian_);
    sums = sumsOf(frame.substr(kFrameHeaderBytes), sums, big_endian_);
    return sums == Sums{word(frame, 16), word(frame, 20)};
  }

  std::ifstream& in_;
  const std::string& header_;
  bool big_endian_;
  std::string frame_;
  Sums sums_{};
};

bool isHeader(const std::string& header) {
  const std::uint32_t magic = word(header, 0);
  const std::uint32_t page = word(header, 8);
  if ((magic | 1U) != (kMagic | 1U) || page < 512 || page > 65536 || (page & (page - 1)) != 0) return false;
  return sumsOf(std::string_view(header).substr(0, 24), {}, (magic & 1U) != 0) ==
         Sums{word(header, 24), word(header, 28)};
}

}  // namespace

std::string AcknowledgmentMark::bytes() const {
  std::string text(kMarkBegin);
  text += token;
  const auto add = [&](std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) text += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xFFU);
  };
  add(static_cast<std::uint64_t>(commits), 8);
  add(base::crc32(text), 4);
  return text;
}

std::optional<AcknowledgmentMark> AcknowledgmentMark::in(const std::string& bytes) {
  if (bytes.size() < kBytes || !bytes.starts_with(kMarkBegin)) return std::nullopt;
  AcknowledgmentMark mark;
  mark.token = bytes.substr(kMarkBegin.size(), kTokenBytes);
  std::uint64_t commits = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    commits |= std::uint64_t{static_cast<unsigned char>(bytes[kMarkBegin.size() + kTokenBytes + i])} << (8 * i);
  }
  mark.commits = static_cast<long long>(commits);
  if (bytes.compare(0, kBytes, mark.bytes()) != 0) return std::nullopt;
  return mark;
}

JournalFile readJournal(const std::string& path) {
  JournalFile journal;
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error || !in) return journal;
  journal.is_there = true;
  journal.bytes = static_cast<long long>(bytes);
  std::string header(kHeaderBytes, '\0');
  if (in.read(header.data(), kHeaderBytes) && isHeader(header)) {
    journal.has_header = true;
    journal.readable_bytes = kHeaderBytes;
    FrameReader(in, header).read(journal);
  }
  if (journal.bytes >= AcknowledgmentMark::kFromEnd) {
    std::string end(AcknowledgmentMark::kBytes, '\0');
    in.clear();
    in.seekg(journal.bytes - AcknowledgmentMark::kFromEnd);
    if (in.read(end.data(), AcknowledgmentMark::kBytes)) journal.mark = AcknowledgmentMark::in(end);
  }
  return journal;
}

std::string journalOf(const std::string& path) { return path + "-wal"; }

}  // namespace tactus::store
