#pragma once

#include <string>

#include "engine/base/result.h"

namespace hazumi {

// A picture's name in which no frame number has a place: "out/pic.png".
bool IsOnePicture(const std::string& output);

// Names of the pictures of a sequence: in a folder (frame_0000.png), or a pattern in whose last run
// of #### the frame number stands; or the name of the only one.
class FrameNames {
 public:
  // Makes the folder if it is not there. Error: kCannotWrite.
  static Result<FrameNames> Create(const std::string& output);
  std::string Of(int frame) const;

 private:
  std::string before_, after_;
  int digits_ = 4;
  bool is_one_ = false;
};

}  // namespace hazumi
