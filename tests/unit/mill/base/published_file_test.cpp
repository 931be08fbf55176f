#include "mill/base/published_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "mill/base/failure.h"

namespace millwear {
namespace {

using ::testing::HasSubstr;

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class PublishedFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder), {});
  }

  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = folder / "history.csv";
};

/// No file of this process may grow above `bytes` [B] while it lives: write() fails with EFBIG.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(PublishedFile, HoldsTheBytesAndNothingStandsBesideIt) {
  const std::string bytes("a\0b\n", 4);
  publish(file, bytes);
  EXPECT_EQ(content(file), bytes);
  EXPECT_EQ(files(), 1);
}

TEST_F(PublishedFile, TakesThePlaceOfTheOldOne) {
  publish(file, "a long old text");
  publish(file, "new");
  EXPECT_EQ(content(file), "new");
}

TEST_F(PublishedFile, StaysAsItWasWhereTheDiskTakesOnlyAPart) {
  publish(file, "old");
  {
    const FileSizeLimit limit(4096);
    try {
      publish(file, std::string(10000, 'x'));
      ADD_FAILURE() << "10000 bytes were written where 4096 fit";
    } catch (const DiskError& error) {
      EXPECT_THAT(error.what(), HasSubstr("history.csv"));
      EXPECT_THAT(error.what(), HasSubstr("File too large"));
    }
  }
  EXPECT_EQ(content(file), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(PublishedFile, IsRefusedWhereTheFolderIsMissing) {
  try {
    publish(folder / "none" / "history.csv", "x");
    ADD_FAILURE() << "a file was published in a folder that is not there";
  } catch (const DiskError& error) {
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

TEST_F(PublishedFile, LeavesNothingWhereItsNameIsAFolder) {
  std::filesystem::create_directory(file);
  EXPECT_THROW(publish(file, "x"), DiskError);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace millwear
