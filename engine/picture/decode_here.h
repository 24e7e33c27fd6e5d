#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace hazumi {

// Decodes the pictures of a request (picture_bytes.h) in this process, which a broken one may end:
// for hazumi-reader only, all others call DecodePictures. Passes on each answer as soon as it is
// there. False: it is no request, or an answer could not be passed on.
bool DecodeHere(std::string_view request, const std::function<bool(const std::string&)>& pass_on);

}  // namespace hazumi
