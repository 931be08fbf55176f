#include "orchestrator/postprocess/new_folder.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(NewFolder, AppearsWholeOrNotAtAll) {
  const TemporaryFolder place;
  const fs::path out = place.path() / "results";
  {
    const NewFolder given_up(out);
    put_text(given_up.beside() / "a.txt", "a");
    EXPECT_FALSE(fs::exists(out));
  }
  EXPECT_EQ(entries(place.path()), 0u);
  NewFolder folder(out / "");
  put_text(folder.beside() / "a.txt", "a");
  folder.publish();
  EXPECT_EQ(text_of(out / "a.txt"), "a");
  EXPECT_EQ(entries(place.path()), 1u);
}

TEST(NewFolder, TakesAnEmptyFolderAndNoOther) {
  const TemporaryFolder place;
  const fs::path out = place.path() / "results";
  fs::create_directory(out);
  {
    NewFolder folder(out);
    put_text(folder.beside() / "a.txt", "a");
    folder.publish();
  }
  EXPECT_EQ(entries(out), 1u);
  EXPECT_THROW(NewFolder again(out), Failure);
  EXPECT_EQ(text_of(out / "a.txt"), "a");
}

}  // namespace
}  // namespace millwear::orchestrator
