// The float unit's mode: subnormals kept, results rounded to nearest, no traps, whatever mode the caller's thread is in.
// Programs switch flushing on to save time (compilers do it for -ffast-math); a picture must not depend on it.
#pragma once

#include "core/numeric/isa.hpp"

#include <cstdint>

namespace zerkalo::inline ZERKALO_ISA {

/// IEEE 754 arithmetic for the life of this object; then the caller's mode and flags again.
/// The mode is a register that the compiler does not know of: what is computed under it must come from memory, and
/// results go back there. Elsewhere than on these processors nothing is changed.
class IeeeMode {
public:
    ZERKALO_INLINE IeeeMode() : callers_(current()) {
        if (differs()) set(kIeee);
    }
    ZERKALO_INLINE ~IeeeMode() {
        if (differs()) set(callers_);
    }
    IeeeMode(const IeeeMode&) = delete;
    IeeeMode& operator=(const IeeeMode&) = delete;

private:
#if defined(__x86_64__)
    using Mode = std::uint32_t;
    static constexpr Mode kIeee = 0x1f80;  // MXCSR: all traps masked, nothing else
    static constexpr Mode kFlags = 0x3f;  // what has happened, no mode
    static ZERKALO_INLINE Mode current() {
        Mode mode;
        asm volatile("stmxcsr %0" : "=m"(mode));
        return mode;
    }
    static ZERKALO_INLINE void set(Mode mode) { asm volatile("ldmxcsr %0" : : "m"(mode) : "memory"); }
#elif defined(__aarch64__)
    using Mode = std::uint64_t;
    static constexpr Mode kIeee = 0, kFlags = 0;  // FPCR holds no flags
    static ZERKALO_INLINE Mode current() {
        Mode mode;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static ZERKALO_INLINE void set(Mode mode) { asm volatile("msr fpcr, %0" : : "r"(mode) : "memory"); }
#else
    using Mode = std::uint32_t;
    static constexpr Mode kIeee = 0, kFlags = 0;
    static ZERKALO_INLINE Mode current() { return kIeee; }
    static ZERKALO_INLINE void set(Mode) {}
#endif

    ZERKALO_INLINE bool differs() const { return (callers_ & ~kFlags) != kIeee; }

    Mode callers_;
};

}  // namespace zerkalo::inline ZERKALO_ISA
