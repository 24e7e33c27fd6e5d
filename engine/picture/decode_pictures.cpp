#include "engine/picture/decode_pictures.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "engine/picture/image.h"
#include "engine/picture/picture_bytes.h"

namespace hazumi {
namespace {

using Clock = std::chrono::steady_clock;
constexpr const char* kRemedy = "; save the picture anew with another program";
constexpr size_t kLongestMessage = 1000;

class Decoding {
 public:
  Decoding(std::span<const std::span<const std::uint8_t>> files, const ReadOptions& options)
      : files_(files), options_(options) {}

  std::vector<Result<Image>> Run() {
    while (!rest().empty()) {
      const double seconds = std::min(options_.limits.seconds, SecondsLeft());
      if (seconds <= 0.0) {
        LeaveOutAll({ErrorCode::kSyntax, "", "",
                     "is left out: the pictures before it took all the time that there is"});
      } else {
        Go(seconds);
      }
    }
    return std::move(images_);
  }

 private:
  std::span<const std::span<const std::uint8_t>> rest() const {
    return files_.subspan(images_.size());
  }

  double SecondsLeft() const {
    const std::chrono::duration<double> gone = Clock::now() - start_;
    return 2.0 * options_.limits.seconds - gone.count();
  }

  // One process, for all that is left.
  void Go(double seconds) {
    ReadOptions options = options_;
    options.limits.seconds = seconds;
    options.limits.answer = static_cast<size_t>(4 * pixels_left_) + rest().size() * kLongestMessage;
    const std::string request = RequestToBytes(rest(), pixels_left_);
    const Result<ChildOutcome> outcome = RunReader({kDecodePictures, "", request}, options);
    if (!outcome.ok()) return LeaveOutAll(outcome.error());
    for (Result<Image>& image :
         AnswersFromBytes(outcome.value().output, rest().size(), pixels_left_)) {
      if (image.ok()) pixels_left_ -= std::int64_t{image.value().width} * image.value().height;
      images_.push_back(std::move(image));
    }
    if (!rest().empty()) BlameTheNext(WhyNoAnswer(outcome.value(), options.limits));
  }

  // The process ended, or began to talk nonsense, at the first picture that it has not answered.
  void BlameTheNext(const std::optional<Error>& why) {
    if (why && why->code != ErrorCode::kSyntax) return LeaveOutAll(*why);
    const std::string message = why ? why->message : "reading it gave no usable answer";
    images_.emplace_back(Error{ErrorCode::kSyntax, "", "", message + kRemedy});
  }

  void LeaveOutAll(const Error& error) { images_.resize(files_.size(), Result<Image>(error)); }

  std::span<const std::span<const std::uint8_t>> files_;
  const ReadOptions& options_;
  const Clock::time_point start_ = Clock::now();
  std::int64_t pixels_left_ = kMostPixelsTogether;
  std::vector<Result<Image>> images_;
};

}  // namespace

std::vector<Result<Image>> DecodePictures(std::span<const std::span<const std::uint8_t>> files,
                                          const ReadOptions& options) {
  return Decoding(files, options).Run();
}

}  // namespace hazumi
