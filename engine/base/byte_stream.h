#pragma once

// Values as bytes, from one process of this machine to another: in its byte order, as they lie in
// memory. A reader takes any bytes.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

// Of what it writes nothing changes; the arguments are references as a reader's must be.
class ByteWriter {
 public:
  static constexpr bool kReads = false;

  template <typename T>
  void Value(T& value) {
    Raw(&value, sizeof(T));
  }
  void Flag(bool& flag) {
    uint8_t byte = flag;
    Value(byte);
  }
  void Text(std::string& text) { Bytes(text.data(), text.size()); }
  // Elements without pointers.
  template <typename T>
  void Flat(std::vector<T>& list) {
    Size(list.size());
    Raw(list.data(), list.size() * sizeof(T));
  }
  // To be read as a text, or a flat list of bytes.
  void Bytes(const void* data, size_t size) {
    Size(size);
    Raw(data, size);
  }
  bool ok() const { return true; }
  std::string Take() { return std::move(bytes_); }

 protected:
  void Size(uint64_t size) { Value(size); }
  void Raw(const void* data, size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }

 private:
  std::string bytes_;
};

// Stays at its place, with ok() false, once something is missing; values are then as they were.
// Takes no more memory than the bytes do.
class ByteReader {
 public:
  static constexpr bool kReads = true;
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  void Value(T& value) {
    Raw(&value, sizeof(T));
  }
  void Flag(bool& flag) {
    uint8_t byte = 0;
    Value(byte);
    ok_ = ok_ && byte <= 1;
    flag = byte == 1;
  }
  void Text(std::string& text) {
    text.resize(Size(1));
    Raw(text.data(), text.size());
  }
  template <typename T>
  void Flat(std::vector<T>& list) {
    list.resize(Size(sizeof(T)));
    Raw(list.data(), list.size() * sizeof(T));
  }
  // What Bytes wrote, where it lies.
  std::string_view Bytes() {
    const size_t size = Size(1);
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }
  // What was read contradicts itself otherwise.
  void Expect(bool holds) { ok_ = ok_ && holds; }
  bool ok() const { return ok_; }
  bool at_end() const { return ok_ && rest_.empty(); }

 protected:
  // A number of elements that the rest has room for.
  size_t Size(size_t least_bytes) {
    uint64_t size = 0;
    Value(size);
    ok_ = ok_ && size <= rest_.size() / least_bytes;
    return ok_ ? static_cast<size_t>(size) : 0;
  }
  void Raw(void* data, size_t size) {
    ok_ = ok_ && size <= rest_.size();
    if (!ok_ || size == 0) return;
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace hazumi
