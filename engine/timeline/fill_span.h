#pragma once

namespace hazumi {

// Frame in which a limb between keys moves with little effort.
enum class FillFrame {
  kWorld,  // hands move smoothly in the world while the body moves
  kBody,   // along with the body that carries the limb, as if it stood still
};
constexpr const char* NameOf(FillFrame frame) {
  switch (frame) {
    case FillFrame::kWorld:
      return "world";
    case FillFrame::kBody:
      return "body";
  }
  return "";
}

// Motion of a fill at its first and last key, where the joint has no keys beyond and states no
// rate.
enum class FillEnds {
  kRest,  // standing still, as automatic tangents do
  kFree,  // in the middle of a motion, as a capture does
};
constexpr const char* NameOf(FillEnds ends) {
  switch (ends) {
    case FillEnds::kRest:
      return "rest";
    case FillEnds::kFree:
      return "free";
  }
  return "";
}

}  // namespace hazumi
