#include "app/cli/option_values.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "engine/base/text.h"

namespace hazumi {

namespace {

template <typename Number>
std::optional<Number> ReadWhole(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

struct IntPair {
  int first, second;
};

// Two whole numbers with `separator` between them.
std::optional<IntPair> ReadPair(std::string_view text, std::string_view separator) {
  const size_t at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto first = ReadInt(text.substr(0, at));
  const auto second = ReadInt(text.substr(at + separator.size()));
  if (!first || !second) return std::nullopt;
  return IntPair{*first, *second};
}

std::vector<double> ReadNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (size_t from = 0; from <= text.size();) {
    const size_t comma = std::min(text.find(',', from), text.size());
    const auto number = ReadFinite(text.substr(from, comma - from));
    if (!number) return {};
    numbers.push_back(*number);
    from = comma + 1;
  }
  return numbers;
}

}  // namespace

std::optional<int> ReadInt(std::string_view text) { return ReadWhole<int>(text); }

std::optional<double> ReadFinite(std::string_view text) {
  const auto number = ReadWhole<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<FrameRange> ReadRange(std::string_view text) {
  if (const auto frame = ReadInt(text)) return FrameRange{*frame, *frame};
  const auto range = ReadPair(text, "..");
  if (!range || range->first > range->second) return std::nullopt;
  return FrameRange{range->first, range->second};
}

std::optional<PictureSize> ReadSize(std::string_view text) {
  const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
  const auto size = ReadPair(text, "x");
  if (!size || !fits(size->first) || !fits(size->second)) return std::nullopt;
  return PictureSize{size->first, size->second};
}

std::optional<FrameRate> ReadRate(std::string_view text) {
  constexpr double kSlowest = 0.1, kFastest = 1e4;  // as in files
  constexpr int kLargest = 100'000'000;             // room for products of rates
  const auto is_good = [](double fps) { return fps >= kSlowest && fps <= kFastest; };
  if (const auto fps = ReadFinite(text)) {
    if (!is_good(*fps)) return std::nullopt;
    if (*fps == std::floor(*fps)) return FrameRate{static_cast<int>(*fps), 1};
    return FrameRate{static_cast<int>(std::lround(*fps * 1000)), 1000};
  }
  const auto fraction = ReadPair(text, "/");
  if (!fraction || fraction->first <= 0 || fraction->second <= 0) return std::nullopt;
  const int divisor = std::gcd(fraction->first, fraction->second);
  const FrameRate rate{fraction->first / divisor, fraction->second / divisor};
  if (!is_good(rate.frames_per_second()) || rate.num > kLargest) return std::nullopt;
  return rate;
}

bool IsVideo(std::string_view path) {
  return LowerCase(std::filesystem::path(path).extension().string()) == ".mp4";
}

std::optional<render::FigureLook> ReadBody(std::string_view text) {
  using enum render::FigureLook;
  if (text == "skin") return kSkin;
  if (text == "capsules") return kLinks;
  return text == "both" ? std::optional(kLinksInSkin) : std::nullopt;
}

std::optional<CameraChoice> ReadCamera(std::string_view text) {
  for (const char* side : {"front", "back", "left", "right", "top", "three-quarter"}) {
    if (text == side) return CameraChoice{side};
  }
  const std::vector<double> n = ReadNumbers(text);
  if (n.size() != 6 && n.size() != 7) return std::nullopt;
  CameraChoice camera;
  camera.eye = {n[0], n[1], n[2]};
  camera.target = {n[3], n[4], n[5]};
  if (n.size() == 7) camera.vertical_fov_deg = n[6];
  const bool sane = (camera.eye - camera.target).norm() > 1e-6 && camera.vertical_fov_deg > 0.1 &&
                    camera.vertical_fov_deg < 170.0;
  return sane ? std::optional(camera) : std::nullopt;
}

}  // namespace hazumi
