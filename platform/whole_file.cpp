// Draft, link, rename. Sources: open(2) on O_TMPFILE, rename(2).
#include "platform/whole_file.hpp"

#include "platform/write_all.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace zerkalo {
namespace {

constexpr unsigned kAttempts = 100;  // names tried for a draft before giving up

// Length of the directory part of `path` with its last slash; 0 when there is none.
int directory_length(const char* path) {
    const char* slash = std::strrchr(path, '/');
    return slash == nullptr ? 0 : static_cast<int>(slash - path) + 1;
}

bool copy_path(char (&to)[PATH_MAX], const char* from) {
    const int length = std::snprintf(to, sizeof to, "%s", from);
    return length >= 0 && static_cast<std::size_t>(length) < sizeof to;
}

void path_of_descriptor(int file, char (&path)[40]) { std::snprintf(path, sizeof path, "/proc/self/fd/%d", file); }

}  // namespace

IoStatus WholeFile::fail(const char* doing, int error_number) {
    failure_ = io_failure(name_, doing, error_number);
    const IoStatus failure = failure_;
    discard();
    failure_ = failure;
    return failure_;
}

IoStatus WholeFile::open(const char* path, Draft draft) {
    discard();
    if (std::strcmp(path, "-") == 0) {
        std::snprintf(name_, sizeof name_, "standard output");
        file_ = STDOUT_FILENO;
        kind_ = Kind::direct;
        return {};
    }
    if (!copy_path(name_, path)) return fail("cannot write", ENAMETOOLONG);
    if (const IoStatus status = aim_at(path); !status.ok() || kind_ == Kind::direct) return status;
    return start_draft(draft);
}

// Decides what `path` is: a device (opened at once), a file to replace, a new name, or nothing that can be written.
IoStatus WholeFile::aim_at(const char* path) {
    struct stat info {};
    target_exists_ = ::stat(path, &info) == 0;
    if (!target_exists_) {
        if (errno != ENOENT) return fail("cannot write", errno);
        if (path[0] == '\0') return fail("cannot write to an empty name", ENOENT);
        if (path[directory_length(path)] == '\0') return fail("cannot write", EISDIR);
        (void)copy_path(target_, path);
        return {};
    }
    if (S_ISDIR(info.st_mode)) return fail("cannot write", EISDIR);
    if (!S_ISREG(info.st_mode)) {
        file_ = ::open(path, O_WRONLY | O_NOCTTY | O_CLOEXEC);
        if (file_ < 0) return fail("cannot open", errno);
        kind_ = Kind::direct;
        return {};
    }
    // A rename would get past the file's own permissions.
    if (::access(path, W_OK) != 0) return fail("cannot write", errno);
    if (::realpath(path, target_) == nullptr) return fail("cannot write", errno);
    target_mode_ = info.st_mode & 07777;
    return {};
}

IoStatus WholeFile::start_draft(Draft draft) {
    char directory[PATH_MAX];
    const int length = directory_length(target_);
    std::snprintf(directory, sizeof directory, "%.*s", length, target_);
    if (draft == Draft::unnamed) {
        file_ = ::open(length == 0 ? "." : directory, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
        if (file_ >= 0) {
            // The only unprivileged way to a name leads through /proc; without it, start with a name.
            char descriptor[40];
            path_of_descriptor(file_, descriptor);
            if (::access(descriptor, F_OK) == 0) {
                kind_ = Kind::unnamed;
                return {};
            }
            ::close(file_);
            file_ = -1;
        }
    }
    do {
        if (!next_draft_name()) return fail("cannot write", ENAMETOOLONG);
        file_ = ::open(draft_, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    } while (file_ < 0 && errno == EEXIST && attempt_ < kAttempts);
    if (file_ < 0) {
        draft_[0] = '\0';
        return fail("cannot write", errno);
    }
    kind_ = Kind::named;
    return {};
}

// Beside the target, so that the rename stays on one file system; short, so that it fits where the target does.
bool WholeFile::next_draft_name() {
    const int length = std::snprintf(draft_, sizeof draft_, "%.*s.zerkalo-%ld-%u", directory_length(target_), target_,
                                     static_cast<long>(::getpid()), attempt_++);
    return length >= 0 && static_cast<std::size_t>(length) < sizeof draft_;
}

IoStatus WholeFile::write(const void* data, std::size_t size) {
    if (!failure_.ok()) return failure_;
    if (const int error = write_all(file_, data, size); error != 0) return fail("cannot write", error);
    return {};
}

bool WholeFile::give_draft_a_name() {
    char descriptor[40];
    path_of_descriptor(file_, descriptor);
    int result = -1;
    do {
        if (!next_draft_name()) {
            errno = ENAMETOOLONG;
            return false;
        }
        result = ::linkat(AT_FDCWD, descriptor, AT_FDCWD, draft_, AT_SYMLINK_FOLLOW);
    } while (result != 0 && errno == EEXIST && attempt_ < kAttempts);
    if (result != 0) {
        draft_[0] = '\0';
        return false;
    }
    kind_ = Kind::named;
    return true;
}

IoStatus WholeFile::commit(Durability durability) {
    if (!failure_.ok()) return failure_;
    if (kind_ == Kind::direct) {
        if (file_ != STDOUT_FILENO && ::close(std::exchange(file_, -1)) != 0) return fail("cannot finish", errno);
        kind_ = Kind::none;
        file_ = -1;
        return {};
    }
    if (target_exists_ && ::fchmod(file_, target_mode_) != 0) return fail("cannot keep its permissions", errno);
    if (durability == Durability::flushed && ::fsync(file_) != 0) return fail("cannot flush", errno);
    if (kind_ == Kind::unnamed && !give_draft_a_name()) return fail("cannot name the finished file", errno);
    // A network file system may tell only now that it is full.
    if (::close(std::exchange(file_, -1)) != 0) return fail("cannot finish", errno);
    if (::rename(draft_, target_) != 0) return fail("cannot rename the finished file", errno);
    draft_[0] = '\0';
    kind_ = Kind::none;
    return {};
}

void WholeFile::discard() {
    if (file_ >= 0 && file_ != STDOUT_FILENO) ::close(file_);
    if (draft_[0] != '\0') ::unlink(draft_);
    file_ = -1;
    draft_[0] = '\0';
    kind_ = Kind::none;
    failure_ = {};
    attempt_ = 0;
}

}  // namespace zerkalo
