#include "core/store/recording_codec.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/files/checksums.h"
#include "core/base/text.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;

constexpr std::string_view kRecordingMagic = "TREC";
constexpr std::uint64_t kLayout = 1;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

void putNumber(std::string& out, std::uint64_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

void putDouble(std::string& out, double value) { putNumber(out, std::bit_cast<std::uint64_t>(value), 8); }

tl::unexpected<base::Error> badRecording(std::string found, std::string wanted) {
  return base::fail(ErrorCode::kValue, "recording", std::move(found), std::move(wanted));
}

Result<void> requireStorable(const study::Recording& recording) {
  if (!(recording.sample_rate_hz > 0) || !std::isfinite(recording.sample_rate_hz)) {
    return badRecording(base::formatNumber(recording.sample_rate_hz) + " samples per second", "a rate above 0");
  }
  if (recording.channels.size() > 100) {
    return badRecording(std::to_string(recording.channels.size()) + " channels", "at most 100");
  }
  if (recording.size() * recording.channels.size() > kMostBytes / sizeof(double)) {
    return badRecording(std::to_string(recording.size()) + " samples", "at most 64 MiB of samples");
  }
  for (const study::Channel& channel : recording.channels) {
    if (channel.values.size() != recording.size()) {
      return badRecording("channels of " + std::to_string(recording.size()) + " and " +
                              std::to_string(channel.values.size()) + " samples",
                          "channels of one length");
    }
    if (channel.name.size() > 255 || channel.unit.size() > 255 || !base::isUtf8(channel.name) ||
        !base::isUtf8(channel.unit)) {
      return badRecording("the channel " + base::quoted(channel.name), "a name and a unit of at most 255 bytes UTF-8");
    }
    for (const double value : channel.values) {
      if (!std::isfinite(value)) {
        return badRecording(base::formatNumber(value) + " in the channel " + base::quoted(channel.name),
                            "finite numbers");
      }
    }
  }
  return {};
}

/// Reads numbers and texts in order; `ok` turns false at the end of the bytes.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) {
      ok_ = false;
      return {};
    }
    const auto taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::uint64_t number(std::size_t count) {
    std::uint64_t value = 0;
    const auto taken = take(count);
    for (std::size_t i = 0; i < taken.size(); ++i) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(taken[i])) << (8 * i);
    }
    return value;
  }
  double real() { return std::bit_cast<double>(number(8)); }
  std::string text() { return std::string(take(static_cast<std::size_t>(number(1)))); }

  bool ok() const { return ok_; }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool ok_ = true;
};

tl::unexpected<base::Error> damaged(std::string found) {
  return base::fail(ErrorCode::kMismatch, "recording", std::move(found), "the bytes that were recorded");
}

}  // namespace

Result<std::string> encodeRecording(const study::Recording& recording) {
  if (auto storable = requireStorable(recording); !storable) return tl::unexpected(storable.error());
  std::string out(kRecordingMagic);
  putNumber(out, kLayout, 2);
  putNumber(out, recording.channels.size(), 2);
  putNumber(out, recording.size(), 4);
  putDouble(out, recording.sample_rate_hz);
  for (const study::Channel& channel : recording.channels) {
    for (const std::string& text : {channel.name, channel.unit}) {
      putNumber(out, text.size(), 1);
      out += text;
    }
  }
  out.reserve(out.size() + recording.size() * recording.channels.size() * sizeof(double) + kChecksumBytes);
  for (const study::Channel& channel : recording.channels) {
    for (const double value : channel.values) putDouble(out, value);
  }
  putNumber(out, base::crc32(out), kChecksumBytes);
  return out;
}

Result<study::Recording> decodeRecording(std::string_view bytes) {
  if (bytes.size() < kChecksumBytes) return damaged(std::to_string(bytes.size()) + " bytes");
  const auto body = bytes.substr(0, bytes.size() - kChecksumBytes);
  if (Reader(bytes.substr(body.size())).number(kChecksumBytes) != base::crc32(body)) {
    return damaged("bytes with another checksum");
  }
  Reader reader(body);
  if (reader.take(kRecordingMagic.size()) != kRecordingMagic) return damaged("another beginning");
  if (const auto layout = reader.number(2); layout != kLayout) {
    return base::fail(ErrorCode::kVersion, "recording", "layout " + std::to_string(layout), "layout 1");
  }
  study::Recording recording;
  recording.channels.resize(static_cast<std::size_t>(reader.number(2)));
  const auto samples = static_cast<std::size_t>(reader.number(4));
  recording.sample_rate_hz = reader.real();
  for (study::Channel& channel : recording.channels) {
    channel.name = reader.text();
    channel.unit = reader.text();
  }
  const bool has_no_channel = recording.channels.empty() && samples > 0;
  if (!reader.ok() || has_no_channel || reader.left() != samples * recording.channels.size() * sizeof(double)) {
    return damaged("another number of samples");
  }
  for (study::Channel& channel : recording.channels) {
    channel.values.reserve(samples);
    for (std::size_t i = 0; i < samples; ++i) channel.values.push_back(reader.real());
  }
  return recording;
}

}  // namespace tactus::store
