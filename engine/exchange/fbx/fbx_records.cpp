#include "engine/exchange/fbx/fbx_records.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

namespace hazumi {
namespace {

constexpr std::string_view kMagic = "Kaydara FBX Binary  ";
constexpr size_t kVersionAt = 23, kHeader = 27;
constexpr int kLongOffsets = 7500;  // version from which on offsets have eight bytes
constexpr int kDeepest = 32;
constexpr size_t kLongestArray = size_t{256} << 20;  // [bytes]

// Records that are kept, by their depth; below them everything is.
bool IsWanted(std::string_view name, int depth) {
  constexpr std::string_view kTop[] = {"Objects", "Connections"};
  constexpr std::string_view kObjects[] = {
      "Model", "AnimationStack", "AnimationLayer", "AnimationCurveNode", "AnimationCurve",
      "C",     "Connect"};
  const auto is_one_of = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
  };
  return depth == 0 ? is_one_of(kTop) : depth > 1 || is_one_of(kObjects);
}

// [FBX binary: record = end offset, number and length of properties, name, properties, records].
class BinaryReader {
 public:
  explicit BinaryReader(std::string_view bytes)
      : bytes_(bytes), is_long_(FbxVersion(bytes) >= kLongOffsets) {}

  std::optional<FbxRecord> Read() {
    FbxRecord top;
    at_ = kHeader;
    if (!ReadChildren(bytes_.size(), 0, &top)) return std::nullopt;
    return top;
  }

 private:
  template <typename T>
  T Take() {
    T value = {};
    if (sizeof value > bytes_.size() - at_) {
      is_broken_ = true;
    } else {
      std::memcpy(&value, bytes_.data() + at_, sizeof value);  // little-endian, as this machine
      at_ += sizeof value;
    }
    return value;
  }
  std::string_view TakeText(size_t length) {
    if (length > bytes_.size() - at_) {
      is_broken_ = true;
      return {};
    }
    at_ += length;
    return bytes_.substr(at_ - length, length);
  }
  uint64_t TakeOffset() { return is_long_ ? Take<uint64_t>() : Take<uint32_t>(); }

  // Up to the empty record at the end.
  bool ReadChildren(size_t end, int depth, FbxRecord* parent) {
    if (depth > kDeepest) return false;
    while (at_ < end) {
      const uint64_t record_end = TakeOffset(), count = TakeOffset();
      TakeOffset();  // length of the properties
      const std::string_view name = TakeText(Take<uint8_t>());
      if (is_broken_) return false;
      if (record_end == 0) return true;
      if (record_end > end || record_end < at_) return false;
      if (IsWanted(name, depth) && !ReadOne(name, count, record_end, depth, parent)) return false;
      at_ = record_end;
    }
    return true;
  }

  bool ReadOne(std::string_view name, uint64_t count, size_t end, int depth, FbxRecord* parent) {
    FbxRecord record;
    record.name = name;
    for (uint64_t i = 0; i < count && !is_broken_; ++i) record.values.push_back(TakeValue());
    if (is_broken_ || at_ > end || !ReadChildren(end, depth + 1, &record)) return false;
    parent->children.push_back(std::move(record));
    return true;
  }

  FbxValue TakeValue() {
    FbxValue value;
    switch (Take<char>()) {
      case 'C':
      case 'B':
        value.whole = Take<uint8_t>();
        break;
      case 'Y':
        value.whole = Take<int16_t>();
        break;
      case 'I':
        value.whole = Take<int32_t>();
        break;
      case 'L':
        value.whole = Take<int64_t>();
        break;
      case 'F':
        value.real = static_cast<double>(Take<float>());
        break;
      case 'D':
        value.real = Take<double>();
        break;
      case 'S':
      case 'R':
        value.text = std::string(TakeText(Take<uint32_t>()));
        break;
      case 'f':
        TakeArray<float>(&value.numbers);
        break;
      case 'd':
        TakeArray<double>(&value.numbers);
        break;
      case 'l':
        TakeArray<int64_t>(&value.wholes);
        break;
      case 'i':
        TakeArray<int32_t>(&value.wholes);
        break;
      case 'b':
        TakeArray<uint8_t>(&value.wholes);
        break;
      default:
        is_broken_ = true;
    }
    return value;
  }

  template <typename T, typename To>
  void TakeArray(std::vector<To>* to) {
    const size_t count = Take<uint32_t>();
    const uint32_t is_compressed = Take<uint32_t>();
    const std::string_view stored = TakeText(Take<uint32_t>());
    const size_t length = count * sizeof(T);
    if (is_broken_ || length > kLongestArray) {
      is_broken_ = true;
      return;
    }
    std::vector<T> values(count);
    uLongf unpacked = length;
    if (is_compressed) {
      const auto* from = reinterpret_cast<const Bytef*>(stored.data());
      auto* target = reinterpret_cast<Bytef*>(values.data());
      is_broken_ = ::uncompress(target, &unpacked, from, stored.size()) != Z_OK;
    } else if (stored.size() == length) {
      std::memcpy(values.data(), stored.data(), length);
    } else {
      is_broken_ = true;
    }
    if (!is_broken_ && unpacked == length) to->assign(values.begin(), values.end());
  }

  std::string_view bytes_;
  bool is_long_, is_broken_ = false;
  size_t at_ = 0;
};

// [FBX text: `Name: value, value { records }`, arrays are `*4 { a: 1,2,3,4 }`].
class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  std::optional<FbxRecord> Read() {
    FbxRecord top;
    if (!ReadChildren(0, &top)) return std::nullopt;
    return top;
  }

 private:
  // Over blanks and comments.
  char Peek() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == ';') {
        at_ = std::min(text_.find('\n', at_), text_.size() - 1);
      } else if (!std::isspace(static_cast<unsigned char>(text_[at_]))) {
        return text_[at_];
      }
    }
    return '\0';
  }

  bool ReadChildren(int depth, FbxRecord* parent) {
    if (depth > kDeepest) return false;
    for (;;) {
      const char next = Peek();
      if (next == '\0') return depth == 0;
      if (next == '}') {
        ++at_;
        return depth > 0;
      }
      const size_t colon = text_.find(':', at_);
      if (colon == std::string_view::npos) return false;
      FbxRecord record;
      record.name = text_.substr(at_, colon - at_);
      at_ = colon + 1;
      if (!ReadValues(&record)) return false;
      if (text_.substr(at_, 1) == "{") {
        ++at_;
        const bool is_wanted = IsWanted(record.name, depth);
        if (!(is_wanted ? ReadChildren(depth + 1, &record) : SkipBraces())) return false;
      }
      TakeArray(&record);
      if (IsWanted(record.name, depth)) parent->children.push_back(std::move(record));
    }
  }

  // Up to the end of the line or an opening brace. A comma at the end of a line goes on.
  bool ReadValues(FbxRecord* record) {
    for (;;) {
      while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r'))
        ++at_;
      if (at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '{' || text_[at_] == '}')
        return true;
      if (text_[at_] == ',') {
        ++at_;
        Peek();
        continue;
      }
      if (text_[at_] == ';') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        return true;
      }
      record->values.push_back(text_[at_] == '"' ? TakeQuoted() : TakeWord());
    }
  }

  FbxValue TakeQuoted() {
    const size_t end = std::min(text_.find('"', at_ + 1), text_.size());
    FbxValue value;
    value.text = std::string(text_.substr(at_ + 1, end - at_ - 1));
    at_ = std::min(end + 1, text_.size());
    return value;
  }

  FbxValue TakeWord() {
    const size_t end = std::min(text_.find_first_of(",{} \t\r\n", at_), text_.size());
    const std::string word(text_.substr(at_, std::max(end, at_ + 1) - at_));
    at_ += word.size();
    FbxValue value;
    char* rest = nullptr;
    const int64_t whole = std::strtoll(word.c_str(), &rest, 10);
    if (*rest == '\0') {
      value.whole = whole;
    } else if (const double real = std::strtod(word.c_str(), &rest); *rest == '\0') {
      value.real = real;
    } else {
      value.text = word;  // such as *24 of an array
    }
    return value;
  }

  // `KeyTime: *2 { a: 0,1 }` has its numbers in a record of its own.
  static void TakeArray(FbxRecord* record) {
    const FbxRecord* numbers = record->Find("a");
    if (!numbers || record->values.size() != 1) return;
    FbxValue array;
    for (const FbxValue& value : numbers->values) {
      array.numbers.push_back(value.number());
      array.wholes.push_back(value.whole.value_or(0));
    }
    record->values = {std::move(array)};
    record->children.clear();
  }

  // From behind an opening brace to behind its closing one.
  bool SkipBraces() {
    for (int open = 1; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        at_ = std::min(text_.find('"', at_ + 1), text_.size() - 1);
      } else if (c == '{') {
        ++open;
      } else if (c == '}' && --open == 0) {
        ++at_;
        return true;
      }
    }
    return false;
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

const FbxRecord* FbxRecord::Find(std::string_view child) const {
  for (const FbxRecord& record : children)
    if (record.name == child) return &record;
  return nullptr;
}

std::string FbxRecord::Text(size_t value) const {
  return value < values.size() ? values[value].text.value_or("") : "";
}

int64_t FbxRecord::Whole(size_t value) const {
  return value < values.size() ? values[value].whole.value_or(0) : 0;
}

int FbxVersion(std::string_view bytes) {
  if (bytes.starts_with(kMagic)) {
    uint32_t version = 0;
    if (bytes.size() >= kHeader) std::memcpy(&version, bytes.data() + kVersionAt, sizeof version);
    return static_cast<int>(version);
  }
  constexpr std::string_view kWord = "FBXVersion:";
  const size_t at = bytes.substr(0, 4096).find(kWord);
  if (at == std::string_view::npos) return 0;
  return std::atoi(std::string(bytes.substr(at + kWord.size(), 16)).c_str());
}

std::optional<FbxRecord> ReadFbxRecords(std::string_view bytes) {
  return bytes.starts_with(kMagic) ? BinaryReader(bytes).Read() : TextReader(bytes).Read();
}

}  // namespace hazumi
