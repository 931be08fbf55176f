#include "mill/base/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear {
namespace {

std::string refusal(std::string_view text) {
  try {
    check_plain_text(text, "x.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlainText, TakesUtf8AndLineBreaks) {
  EXPECT_EQ(refusal("a = 1\r\n\tb = \"M\xc3\xbchle \xe2\x82\xac \xf0\x9f\x94\xa9\"\n"), "");
}

TEST(PlainText, RefusesControlCharactersByLine) {
  EXPECT_THAT(refusal("a\nb\x1b[31m"), testing::StartsWith("x.toml:2: not plain text (byte 0x1b"));
  EXPECT_NE(refusal(std::string_view("a\0b", 3)), "");
  EXPECT_NE(refusal("\x7f"), "");
}

// Overlong, surrogate, beyond U+10FFFF, cut short, a lone continuation, Latin-1.
TEST(PlainText, RefusesWhatIsNotUtf8) {
  for (const std::string text : {"\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                                 "\xe2\x82", "\x80", "M\xfchle"}) {
    EXPECT_THAT(refusal(text), testing::HasSubstr("not UTF-8")) << in_quotes(text);
  }
}

class TextFile : public testing::Test {
 protected:
  [[nodiscard]] std::string read(std::string_view bytes) const {
    write_file(file, std::string(bytes));
    return read_text_file(file);
  }
  orchestrator::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "scan.csv";
};

TEST_F(TextFile, IsTakenWithAByteOrderMark) { EXPECT_EQ(read("\xef\xbb\xbfx,y\n"), "x,y\n"); }

TEST_F(TextFile, IsTakenAsUtf16) {
  using std::string_view_literals::operator""sv;
  EXPECT_EQ(read("\xff\xfex\0,\0\xfc\0"sv), "x,\xc3\xbc");
  EXPECT_EQ(read("\xfe\xff\0x\0,\0\xfc"sv), "x,\xc3\xbc");
  EXPECT_THAT([&] { static_cast<void>(read("\xff\xfex\0,"sv)); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("scan.csv:1: the file begins like UTF-16 and is not")));
}

TEST(InQuotes, ShowsNoRawBytes) {
  EXPECT_EQ(in_quotes("a\nb\x1b"), "`a\\x0ab\\x1b`");
  EXPECT_EQ(in_quotes(std::string(100, 'x')).size(), 45U);
}

}  // namespace
}  // namespace millwear
