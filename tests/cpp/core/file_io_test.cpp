// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/file_io.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "posix_file.h"
#include "support/expect.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own, removed with all that is in it.
class FileIo : public testing::Test {
protected:
    FileIo()
    {
        std::string name = (fs::temp_directory_path() / "nacre-test-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~FileIo() override { fs::remove_all(folder_); }

    [[nodiscard]] std::ptrdiff_t files_in_folder() const
    {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    fs::path folder_;
};

/// Writing past `bytes` fails while it lives: the one kind of full disc that needs no disc.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        (void)std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_F(FileIo, ReadsBackWhatItWrote)
{
    const std::string bytes("a\0b\r\n\xff", 6);
    write_atomically(folder_ / "file.bin", bytes);
    EXPECT_EQ(read_text(folder_ / "file.bin"), bytes);
    write_atomically(folder_ / "file.bin", "");
    EXPECT_EQ(read_text(folder_ / "file.bin"), "");
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(FileIo, WritesIntoTheCurrentFolder)
{
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    write_atomically("bare.txt", "x");
    fs::current_path(before);
    EXPECT_EQ(read_text(folder_ / "bare.txt"), "x");
}

TEST_F(FileIo, ReadingNamesWhatIsWrong)
{
    EXPECT_INPUT_ERROR((void)read_text(folder_ / "none.yml"), "none.yml: there is no such file");
    for (const char* uri : {"ocio://default", "https://a.org/x.yml", "file:///x.spd", "s3+x://y"})
        EXPECT_INPUT_ERROR((void)read_text(uri),
                           std::string(uri) + ": must be a file; this is a URI");
    for (const char* path : {"://x", "a b://x", "none//x", "none:/x", "ä://x"})
        EXPECT_INPUT_ERROR((void)read_text(path), "there is no such file");
    EXPECT_INPUT_ERROR((void)read_text(folder_), "it is a folder");
    write_atomically(folder_ / "big", std::string(101, 'x'));
    EXPECT_EQ(read_text(folder_ / "big", 101).size(), 101u);
    EXPECT_INPUT_ERROR((void)read_text(folder_ / "big", 100), "must not be larger than 100 bytes");
    EXPECT_INPUT_ERROR((void)read_text("/dev/zero"), "must not be larger than 16777216 bytes");
}

TEST_F(FileIo, FailedWriteLeavesTheOldFileAndNothingElse)
{
    write_atomically(folder_ / "file", "old");
    {
        const FileSizeLimit limit(1000);
        EXPECT_INPUT_ERROR(write_atomically(folder_ / "file", std::string(5000, 'x')),
                           "file: cannot be written: File too large");
    }
    EXPECT_EQ(read_text(folder_ / "file"), "old");
    EXPECT_EQ(files_in_folder(), 1);
}

// Writing past the limit kills with SIGXFSZ, as good as kill -9 in the middle of a write.
TEST_F(FileIo, KilledWriterLeavesTheOldFileWhole)
{
    write_atomically(folder_ / "file", "old");
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        (void)std::signal(SIGXFSZ, SIG_DFL);
        write_atomically(folder_ / "file", std::string(5000, 'x'));
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the writer was not killed";
    EXPECT_EQ(read_text(folder_ / "file"), "old");

    const FileDescriptor nameless(::open(folder_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600));
    if (nameless.valid()) {
        EXPECT_EQ(files_in_folder(), 1);
    }
}

// /dev/full answers every write as a disc without space does.
TEST(WriteAndSync, SaysThatTheDiscIsFull)
{
    const FileDescriptor full(::open("/dev/full", O_WRONLY | O_CLOEXEC));
    if (!full.valid()) {
        GTEST_SKIP() << "this machine has no /dev/full";
    }
    EXPECT_INPUT_ERROR(write_and_sync(full.get(), "x", "out.exr"),
                       "out.exr: cannot be written: no space left on the disc");
}

TEST_F(FileIo, SaysWhenTheFolderIsMissing)
{
    EXPECT_INPUT_ERROR(write_atomically(folder_ / "none" / "file", "x"), "there is no such folder");
    write_atomically(folder_ / "file", "x");
    EXPECT_INPUT_ERROR(write_atomically(folder_ / "file" / "below", "x"),
                       "there is no such folder");
}

TEST_F(FileIo, OrdinaryUserCannotWriteIntoALockedFolder)
{
    constexpr ::uid_t kNobody = 65534;
    ::chmod(folder_.c_str(), 0555);
    const ::uid_t before = ::geteuid();
    if (before == 0 && ::seteuid(kNobody) != 0) {  // root may write everywhere
        GTEST_SKIP() << "root cannot become user " << kNobody << " here";
    }
    EXPECT_INPUT_ERROR(write_atomically(folder_ / "file", "x"), "the folder is not writable");
    if (before == 0) {
        ASSERT_EQ(::seteuid(before), 0);
    }
    ::chmod(folder_.c_str(), 0755);
}

TEST_F(FileIo, RefusesToReplaceWhatIsNoFile)
{
    fs::create_directory(folder_ / "sub");
    EXPECT_INPUT_ERROR(write_atomically(folder_ / "sub", "x"), "it is a folder");
    EXPECT_INPUT_ERROR(write_atomically("/dev/null", "x"), "not a regular file");
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(FileIo, WritesThroughALink)
{
    write_atomically(folder_ / "real", "old");
    fs::create_symlink("real", folder_ / "link");
    write_atomically(folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_text(folder_ / "real"), "new");
}

TEST_F(FileIo, NewFilesFollowTheUmask)
{
    const ::mode_t before = ::umask(0027);
    write_atomically(folder_ / "file", "x");
    ::umask(before);
    EXPECT_EQ(fs::status(folder_ / "file").permissions(), fs::perms(0640));
}

TEST_F(FileIo, AtomicFileAppearsOnCommitOnly)
{
    const fs::path target = folder_ / "table.exr";
    {
        AtomicFile file(target);
        EXPECT_EQ(file.temporary().extension(), ".exr");
        EXPECT_EQ(file.temporary().parent_path(), folder_);
        std::ofstream(file.temporary()) << "pixels";
        EXPECT_FALSE(fs::exists(target));
        file.commit();
        EXPECT_EQ(read_text(target), "pixels");
    }
    EXPECT_EQ(files_in_folder(), 1);
    {
        const AtomicFile file(target);
        std::ofstream(file.temporary()) << "half";
    }
    EXPECT_EQ(read_text(target), "pixels");
    EXPECT_EQ(files_in_folder(), 1);
}

}  // namespace
}  // namespace nacre
