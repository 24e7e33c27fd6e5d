#include "ui/shell/fonts.h"

#include <imgui.h>

#include <filesystem>
#include <initializer_list>
#include <optional>

namespace hazumi::ui {

namespace {

// Of Japanese letters, beside Latin ones of the same height.
constexpr float kJapaneseSize = 1.2f;

std::optional<std::string> FirstThatExists(std::initializer_list<const char*> paths) {
  for (const char* path : paths) {
    if (std::filesystem::exists(path)) return path;
  }
  return std::nullopt;
}

std::optional<std::string> LatinFont() {
  return FirstThatExists({"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                          "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                          "/usr/share/fonts/TTF/DejaVuSans.ttf",
                          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"});
}

std::optional<std::string> JapaneseFont() {
  return FirstThatExists({"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                          "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
                          "/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc",
                          "/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc"});
}

bool HasMoreThanLatin(const std::string& texts) {
  for (const char c : texts) {
    if (static_cast<unsigned char>(c) >= 0xe2) return true;  // from U+2000 on
  }
  return false;
}

}  // namespace

bool BuildFonts(float size_px, const std::string& texts, ImFontAtlas* atlas) {
  static const ImWchar kLatin[] = {0x20, 0x17f, 0x2010, 0x2027, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  atlas->Clear();
  const std::optional<std::string> latin = LatinFont();
  if (latin) {
    atlas->AddFontFromFileTTF(latin->c_str(), size_px, nullptr, kLatin);
  } else {
    atlas->AddFontDefault();
  }
  bool is_complete = latin.has_value();
  ImVector<ImWchar> ranges;  // read when the atlas is built
  if (HasMoreThanLatin(texts)) {
    const std::optional<std::string> japanese = JapaneseFont();
    is_complete &= japanese.has_value();
    ImFontGlyphRangesBuilder builder;
    builder.AddText(texts.c_str());
    builder.BuildRanges(&ranges);
    ImFontConfig config;
    config.MergeMode = true;
    if (japanese)
      atlas->AddFontFromFileTTF(japanese->c_str(), kJapaneseSize * size_px, &config, ranges.Data);
  }
  atlas->Build();
  return is_complete;
}

}  // namespace hazumi::ui
