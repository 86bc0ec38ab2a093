// An output file that appears whole or not at all: written as a draft beside its target, moved over it at the end.
#pragma once

#include "platform/io_status.hpp"

#include <climits>
#include <sys/types.h>

namespace zerkalo {

/// unnamed: a file without a name until it is finished, which no death of the program can leave behind; where the
/// file system has no such thing, `named` is used. named: a hidden file beside the target.
enum class Draft : unsigned char { unnamed, named };

/// flushed: on the disk before it gets its name. cached: as the system likes (survives a crash of the program only).
enum class Durability : unsigned char { cached, flushed };

class WholeFile {
public:
    WholeFile() = default;
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Without commit() nothing is left and the target is as it was.
    ~WholeFile() { discard(); }

    /// Starts writing `path`. "-" is standard output; it, devices and pipes are written directly. A link's target is
    /// replaced, not the link. Errors: no such directory, not permitted (also a file without write permission), a
    /// directory, a name too long.
    IoStatus open(const char* path, Draft draft = Draft::unnamed);

    /// Errors: full disk, size limit, closed pipe. After an error every further call repeats it.
    IoStatus write(const void* data, std::size_t size);

    /// The file gets its name; one that existed keeps its permissions. On error nothing is left.
    IoStatus commit(Durability durability = Durability::cached);

    /// Drops the draft. What went to standard output or a device stays there.
    void discard();

    /// As given to open(); "standard output" for "-".
    const char* name() const { return name_; }

private:
    enum class Kind : unsigned char { none, direct, unnamed, named };

    IoStatus aim_at(const char* path);
    IoStatus start_draft(Draft draft);
    bool next_draft_name();
    bool give_draft_a_name();
    IoStatus fail(const char* doing, int error_number);

    char name_[PATH_MAX] = "";
    char target_[PATH_MAX] = "";  // where the draft goes at the end, links followed
    char draft_[PATH_MAX] = "";   // the draft's name while it has one
    int file_ = -1;
    Kind kind_ = Kind::none;
    bool target_exists_ = false;
    mode_t target_mode_ = 0;
    unsigned attempt_ = 0;
    IoStatus failure_;
};

}  // namespace zerkalo
