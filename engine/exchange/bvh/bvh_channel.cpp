#include "engine/exchange/bvh/bvh_channel.h"

#include "engine/base/text.h"
#include "engine/exchange/bvh/bvh_scanner.h"

namespace hazumi {

std::string ChannelName(const BvhChannel& channel) {
  return std::string(1, "XYZ"[channel.axis]) + (channel.is_rotation ? "rotation" : "position");
}

std::optional<BvhChannel> ChannelNamed(std::string_view word) {
  for (int i = 0; i < 6; ++i) {
    const BvhChannel channel{0, i % 3, i >= 3};
    if (IsKeyword(word, LowerCase(ChannelName(channel)))) return channel;
  }
  return std::nullopt;
}

}  // namespace hazumi
