#include "app/cli/frame_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

namespace hazumi {

namespace fs = std::filesystem;

namespace {

// Of the last # in the file's name; npos if there is none.
size_t LastMark(const std::string& output) {
  const size_t slash = output.rfind('/');
  const size_t last = output.rfind('#');
  const bool in_folder = slash != std::string::npos && last != std::string::npos && last < slash;
  return in_folder ? std::string::npos : last;
}

}  // namespace

bool IsOnePicture(const std::string& output) {
  if (LastMark(output) != std::string::npos) return false;
  std::string suffix = fs::path(output).extension().string();
  for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr const char* kSuffixes[] = {".png", ".jpg",  ".jpeg", ".bmp",  ".gif", ".tga",
                                       ".tif", ".tiff", ".ppm",  ".webp", ".exr"};
  return std::find(std::begin(kSuffixes), std::end(kSuffixes), suffix) != std::end(kSuffixes);
}

Result<FrameNames> FrameNames::Create(const std::string& output) {
  FrameNames names;
  const size_t last = LastMark(output);
  if (IsOnePicture(output)) {
    names.before_ = output;
    names.is_one_ = true;
  } else if (last == std::string::npos) {
    names.before_ = (fs::path(output) / "frame_").string();
    names.after_ = ".png";
  } else {
    const size_t first = output.find_last_not_of('#', last) + 1;  // npos + 1 is 0
    names.before_ = output.substr(0, first);
    names.after_ = output.substr(last + 1);
    names.digits_ = static_cast<int>(last + 1 - first);
    if (!names.after_.ends_with(".png")) names.after_ += ".png";
  }
  const fs::path folder = fs::path(names.before_ + names.after_).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) {
    return Error{ErrorCode::kCannotWrite, folder.string(), "",
                 "cannot be made: " + error.message()};
  }
  return names;
}

std::string FrameNames::Of(int frame) const {
  if (is_one_) return before_;
  std::string number = std::to_string(std::abs(frame));
  if (static_cast<int>(number.size()) < digits_) number.insert(0, digits_ - number.size(), '0');
  return before_ + (frame < 0 ? "-" : "") + number + after_;
}

}  // namespace hazumi
