// SPDX-License-Identifier: Apache-2.0
#include "sim/io/atomic_file.h"

#include "tests/sim/disk_limit.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

using AtomicFileTest = FileTest;

TEST_F(AtomicFileTest, AppearsOnlyWithCommit) {
  AtomicFile file(Path("a.json"));
  file.stream() << "new";
  file.stream().flush();
  EXPECT_FALSE(std::filesystem::exists(Path("a.json")));
  EXPECT_TRUE(std::filesystem::exists(Path("a.json.tmp")));
  file.Commit();
  EXPECT_EQ(Read("a.json"), "new");
  EXPECT_EQ(FileCount(), 1);
}

TEST_F(AtomicFileTest, WithoutCommitTheOldFileStays) {
  Write("a.json", "old");
  { AtomicFile(Path("a.json")).stream() << "new"; }
  EXPECT_EQ(Read("a.json"), "old");
  EXPECT_EQ(FileCount(), 1);
}

TEST_F(AtomicFileTest, FullDiskLeavesTheOldFile) {
  Write("a.json", "old");
  {
    const DiskLimit limit(4096);
    AtomicFile file(Path("a.json"));
    file.stream() << std::string(100000, 'x');
    ExpectError([&] { file.Commit(); }, "a.json: could not be written in full");
  }
  EXPECT_EQ(Read("a.json"), "old");
  EXPECT_EQ(FileCount(), 1);
}

TEST_F(AtomicFileTest, DevicesAreWrittenDirectly) {
  if (!HasFullDevice()) GTEST_SKIP() << "/dev/full is no device here";
  AtomicFile full("/dev/full");
  full.stream() << "text";
  ExpectError([&] { full.Commit(); }, "/dev/full: could not be written in full");
  AtomicFile null("/dev/null");
  null.stream() << "text";
  null.Commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, LinkToDeviceIsWrittenDirectly) {
  if (!HasFullDevice()) GTEST_SKIP() << "/dev/full is no device here";
  std::filesystem::create_symlink("/dev/full", Path("link"));
  AtomicFile file(Path("link"));
  file.stream() << "text";
  ExpectError([&] { file.Commit(); }, "could not be written in full");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_EQ(FileCount(), 1);
}

TEST_F(AtomicFileTest, LinkIsFollowed) {
  Write("target", "old");
  std::filesystem::create_symlink(Path("target"), Path("link"));
  AtomicFile file(Path("link"));
  file.stream() << "new";
  file.Commit();
  EXPECT_TRUE(std::filesystem::is_symlink(Path("link")));
  EXPECT_EQ(Read("target"), "new");
}

TEST_F(AtomicFileTest, BadPlaces) {
  ExpectError([&] { AtomicFile file(Path("none/a.json")); }, "create it");
  std::filesystem::create_directory(Path("sub"));
  ExpectError([&] { AtomicFile file(Path("sub")); }, "is a folder; give a file name");
  // Also true for the superuser, whom permissions do not stop.
  ExpectError([&] { AtomicFile file("/proc/none.json"); }, "choose another folder");
  ExpectError([&] { AtomicFile file(Path(std::string(300, 'n'))); }, "choose another folder");
}

TEST_F(AtomicFileTest, RenameThatFailsLeavesNothing) {
  AtomicFile file(Path("a.json"));
  file.stream() << "new";
  std::filesystem::create_directories(Path("a.json"));
  ExpectError([&] { file.Commit(); }, "choose another name");
  EXPECT_EQ(FileCount(), 1);
}

}  // namespace
}  // namespace shading::sim
