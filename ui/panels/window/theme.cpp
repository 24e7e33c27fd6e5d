#include "ui/panels/window/theme.h"

namespace hazumi::ui {

using render::FromHex;

const Theme& DarkTheme() {
  static const Theme theme = {
      FromHex(0x181818), FromHex(0x303030), FromHex(0x262626), FromHex(0x545454), FromHex(0x656565),
      FromHex(0x4a4a4a), FromHex(0xe6e6e6), FromHex(0x989898), FromHex(0x4772b3), FromHex(0x2b2b2b),
      FromHex(0x303030), FromHex(0xffbe33), FromHex(0xe58a3a)};
  return theme;
}

const Theme& LightTheme() {
  static const Theme theme = {
      FromHex(0x9c9c9c), FromHex(0xe3e3e3), FromHex(0xd0d0d0), FromHex(0xfafafa), FromHex(0xffffff),
      FromHex(0xb4b4b4), FromHex(0x1a1a1a), FromHex(0x6a6a6a), FromHex(0x5680c2), FromHex(0xdcdcdc),
      FromHex(0xe6e6e6), FromHex(0x7a4a00), FromHex(0xa33c00)};
  return theme;
}

}  // namespace hazumi::ui
