#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"

namespace millwear {
namespace {

namespace fs = std::filesystem;

class HostileFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::temp_directory_path() / ("millwear_hostile_" + std::to_string(getpid()) + ".toml");
  }
  void TearDown() override { fs::remove(path_); }

  std::string refusal_of(const std::string& content) {
    std::ofstream(path_, std::ios::binary) << content;
    return refusal_of_file(path_);
  }
  static std::string refusal_of_file(const fs::path& file) {
    try {
      static_cast<void>(read_case(file));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  fs::path path_;
};

TEST_F(HostileFile, TenMegabytes) {
  EXPECT_THAT(refusal_of(std::string(10'000'000, '#')),
              testing::HasSubstr(":1: the file is too large (over 64 KiB, 64 KiB at most)"));
}

TEST_F(HostileFile, BinaryRubbish) {
  std::mt19937 random(1);
  std::string rubbish(10'000, '\0');
  std::generate(rubbish.begin(), rubbish.end(), [&] { return static_cast<char>(random() & 0xff); });
  EXPECT_THAT(refusal_of(rubbish), testing::HasSubstr("not plain text"));
}

TEST_F(HostileFile, MissingOrAFolder) {
  EXPECT_THAT(refusal_of_file("no_such_case.toml"),
              testing::StartsWith("no_such_case.toml:1: the file cannot be read"));
  EXPECT_THAT(refusal_of_file(fs::temp_directory_path()), testing::HasSubstr("cannot be read"));
}

TEST_F(HostileFile, DeepNesting) {
  EXPECT_NE(refusal_of(std::string(60'000, '[')), "accepted");
  EXPECT_NE(refusal_of("a = " + std::string(30'000, '[') + std::string(30'000, ']')), "accepted");
  std::string dotted;
  for (int i = 0; i < 30'000; ++i) {
    dotted += "a.";
  }
  for (const std::string& text :
       {dotted + "a = 1", "[" + dotted + "a]", "\na = {" + dotted + "a = 1}"}) {
    EXPECT_THAT(refusal_of(text), testing::HasSubstr("a dotted key has too many parts"));
  }
}

TEST_F(HostileFile, CommaFirst) {
  EXPECT_THAT(refusal_of("a = [,1]"), testing::HasSubstr("not TOML"));
}

std::string pilot_text() {
  std::ifstream stream(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml");
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A shipped case with a few characters changed is read or refused with its name, never worse.
RC_GTEST_PROP(HostileText, MutationsAreReadOrRefused, ()) {
  static const std::string pilot = pilot_text();
  std::string text = pilot;
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
    const auto other =
        static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        text[at] = text[other];
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text[at] = "[]{}=,.\"'\\#\n-e09"[*rc::gen::inRange(0, 16)];
        break;
      default:
        text.insert(at, text.substr(other, 20));
    }
  }
  try {
    const Case mill = case_from_text(text, "mutated.toml");
    RC_ASSERT(totals(mill).particles > 0U);
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).starts_with("mutated.toml:"));
  }
}

}  // namespace
}  // namespace millwear
