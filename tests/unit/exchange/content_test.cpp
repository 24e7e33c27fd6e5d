#include "engine/exchange/content.h"

#include <gtest/gtest.h>

namespace hazumi {
namespace {

TEST(Content, SaysTheFormatWhateverTheFileIsCalled) {
  const std::vector<std::pair<std::string, CharacterFormat>> cases = {
      {"HIERARCHY\nROOT Hips", CharacterFormat::kBvh},
      {"\xEF\xBB\xBF\r\n  hierarchy\n", CharacterFormat::kBvh},
      {"glTF\x02", CharacterFormat::kGlb},
      {"  {\"asset\":{\"version\":\"2.0\"}}", CharacterFormat::kGltf},
      {"Kaydara FBX Binary  \x1a", CharacterFormat::kFbxBinary},
      {"; FBX 7.3.0 project file\n", CharacterFormat::kFbxText},
      {"FBXHeaderExtension:  {\n", CharacterFormat::kFbxText},
      {"<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">", CharacterFormat::kCollada},
  };
  for (const auto& [bytes, format] : cases) {
    const Result<CharacterFormat> found = FormatOf(ReadUse::kCharacter, bytes, "model.png");
    ASSERT_TRUE(found.ok()) << bytes;
    EXPECT_EQ(found.value(), format) << bytes;
  }
}

TEST(Content, NamesWhatIsNotReadAndWhatIs) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"MD5Version 10\n", "MD5"},        {"ply\nformat ascii 1.0\n", "PLY"},
      {"xof 0303txt 0032\n", "DirectX"}, {"BLENDER-v300", "Blender"},
      {"{\"frames\": []}", "not glTF"},  {"<svg></svg>", "not Collada"},
      {"\x01\x02\x03", "does not know"},
  };
  for (const auto& [bytes, name] : cases) {
    const Result<CharacterFormat> found = FormatOf(ReadUse::kCharacter, bytes, "folder/model.fbx");
    ASSERT_FALSE(found.ok()) << bytes;
    const std::string text = found.error().ToString();
    for (const std::string& part : {std::string("folder/model.fbx"), name, std::string("BVH"),
                                    std::string("glTF 2.0"), std::string("ends in .fbx")})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST(Content, AnEmptyFileIsCalledEmpty) {
  for (const char* bytes : {"", " \n\t", "\xEF\xBB\xBF"}) {
    const Result<CharacterFormat> found = FormatOf(ReadUse::kCharacter, bytes, "a.bvh");
    ASSERT_FALSE(found.ok());
    EXPECT_NE(found.error().message.find("is empty"), std::string::npos);
  }
}

}  // namespace
}  // namespace hazumi
