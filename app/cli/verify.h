#pragma once

// Internal. Whether a motion or pictures come out again as they were made.

#include <string>
#include <vector>

#include "app/cli/options.h"
#include "engine/base/result.h"

namespace hazumi {

struct Verdict {
  bool is_same = false;
  std::string sentence;              // "the same: ...", or where the first difference is
  std::vector<std::string> remarks;  // that decide nothing: other versions
};

// Of a file that --bake or --export wrote as JSON. Every value is compared, but for the times that
// --timings adds, and the program's version and commit. Errors: of reading both and of baking.
Result<Verdict> VerifyMotion(const std::string& project, const std::string& motion_file);

// Of a folder that --render filled. Every pixel of every picture in it is compared. Errors: of
// reading the pictures, baking and drawing.
Result<Verdict> VerifyPictures(const std::string& project, const std::string& folder,
                               bool open_outside);

// Which program makes things: "Hazumi 0.1.0 (abc1234)".
std::string MadeByText();
// A remark if that is another one than this.
void RemarkOnMaker(const std::string& maker, Verdict* verdict);

// What is noted in the things made, as options again.
Result<Options> OptionsToMakeAgain(const std::vector<std::string>& task,
                                   const std::vector<std::string>& given,
                                   const std::string& project);

}  // namespace hazumi
