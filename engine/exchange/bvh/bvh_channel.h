#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hazumi {

// One column of the motion.
struct BvhChannel {
  int bone = 0;
  int axis = 0;  // 0 x, 1 y, 2 z
  bool is_rotation = false;
};

// Such as "Xposition".
std::string ChannelName(const BvhChannel& channel);
// That of a name, in any case; of bone 0.
std::optional<BvhChannel> ChannelNamed(std::string_view name);

}  // namespace hazumi
