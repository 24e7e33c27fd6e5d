#include <algorithm>
#include <unordered_set>

#include "engine/base/utf8.h"
#include "engine/project/json/json.h"

namespace hazumi {

namespace {

std::string LineAndColumn(std::string_view text, size_t offset) {
  text = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(text.begin(), text.end(), '\n');
  text.remove_prefix(text.rfind('\n') + 1);  // npos + 1 == 0
  const auto column =
      1 + std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Builds the tree from the parser's events. The parser does not recurse and neither does this, so
// deep text cannot exhaust the stack. Each callback's result says whether to go on.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(std::string_view text, FirstError* errors, size_t most_bytes)
      : text_(text), errors_(errors), most_bytes_(most_bytes) {}

  Json TakeTree() { return std::move(tree_); }

  bool null() override { return Add(nullptr); }
  bool boolean(bool value) override { return Add(value); }
  bool number_integer(number_integer_t value) override { return Add(value); }
  bool number_unsigned(number_unsigned_t value) override { return Add(value); }
  bool number_float(number_float_t value, const string_t&) override { return Add(value); }
  bool string(string_t& value) override { return Add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in JSON text
  bool start_object(size_t) override { return Open(Json::object()); }
  bool start_array(size_t) override { return Open(Json::array()); }
  bool end_object() override { return Close(); }
  bool end_array() override { return Close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.field = name;
    if (!level.fields.insert(name).second) return Fail(Check::kFieldTwice, {Quoted(name)});
    return Take(NameBytes(name) + kFieldOfSet);
  }

  bool parse_error(size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;
    const std::string place = LineAndColumn(text_, position == 0 ? 0 : position - 1);
    if (error.id == kNumberOverflow) {
      errors_->Report(Check::kNumberOverflow, place, {token});
    } else {
      errors_->Report(Check::kNotJson, place, {ValidUtf8(Reason(error.what()))});
    }
    return false;
  }

 private:
  static constexpr size_t kFieldOfSet = 80;  // memory of a field in Level::fields [bytes]
  struct Level {
    Json container;
    std::string field;                       // of an object: the one being read
    std::unordered_set<std::string> fields;  // of an object: all so far
  };

  // Of "[json.exception...] parse error at ...: syntax error while parsing value - REASON; last
  // read: 'TEXT'", where TEXT may be long.
  static std::string Reason(std::string_view what) {
    constexpr size_t kLongest = 100;
    const size_t dash = what.find(" - ");
    if (dash != std::string_view::npos) what.remove_prefix(dash + 3);
    return std::string(what.size() > kLongest ? what.substr(0, what.find("; last read")) : what);
  }

  bool Add(Json value) {
    if (!Take(TreeBytes(value))) return false;
    if (levels_.empty()) {
      tree_ = std::move(value);
      return true;
    }
    Level& level = levels_.back();
    if (level.container.is_array()) {
      level.container.push_back(std::move(value));
    } else {
      // Known to be new, so the linear search of ordered_map's own insertion is skipped.
      static_cast<std::vector<Json::object_t::value_type>&>(
          level.container.get_ref<Json::object_t&>())
          .emplace_back(level.field, std::move(value));
    }
    return true;
  }

  // Memory of the tree.
  bool Take(size_t bytes) {
    bytes_ += bytes;
    return bytes_ <= most_bytes_ ||
           Fail(Check::kTooManyValues, {std::to_string(most_bytes_ / 1'000'000)});
  }

  bool Open(Json container) {
    if (levels_.size() >= kMaxJsonDepth) return Fail(Check::kTooDeep);
    levels_.push_back({std::move(container), {}, {}});
    return true;
  }

  bool Close() {
    Json done = std::move(levels_.back().container);
    bytes_ -= levels_.back().fields.size() * kFieldOfSet;
    levels_.pop_back();
    return Add(std::move(done));
  }

  bool Fail(Check check, std::initializer_list<std::string_view> arguments = {}) {
    errors_->Report(check, Place(), arguments);
    return false;
  }

  // Where the parser is, such as `joints.r_knee.keys[2]`, without what is deeper than 8.
  std::string Place() const {
    std::string place;
    for (size_t i = 0; i < std::min<size_t>(levels_.size(), 8); ++i) {
      const Level& level = levels_[i];
      if (level.container.is_array()) {
        place += "[" + std::to_string(level.container.size()) + "]";
      } else {
        place += (place.empty() ? "" : ".") + level.field;
      }
    }
    return place;
  }

  std::string_view text_;
  FirstError* errors_;
  std::vector<Level> levels_;
  Json tree_;
  size_t bytes_ = 0, most_bytes_;
};

}  // namespace

// Lists double as they grow; what is in a string or list has a block of its own.
size_t TreeBytes(const Json& value) {
  constexpr size_t kSlot = 2 * sizeof(Json), kBlock = 16;
  if (value.is_structured()) return kSlot + sizeof(std::vector<Json>) + 2 * kBlock;
  if (!value.is_string()) return kSlot;
  return kSlot + sizeof(std::string) + kBlock + value.get_ref<const std::string&>().size();
}

size_t NameBytes(std::string_view name) {
  constexpr size_t kInside = 15;  // letters that need no block
  return sizeof(std::string) * 3 / 2 + (name.size() > kInside ? name.size() : 0);
}

std::optional<Json> ParseJson(std::string_view text, FirstError* errors, size_t most_bytes) {
  const size_t bad = FindInvalidUtf8(text);
  if (bad != std::string_view::npos) {
    errors->Report(Check::kNotUtf8, LineAndColumn(text, bad));
    return std::nullopt;
  }
  TreeBuilder builder(text, errors, most_bytes);
  if (!Json::sax_parse(text, &builder)) return std::nullopt;
  return builder.TakeTree();
}

}  // namespace hazumi
